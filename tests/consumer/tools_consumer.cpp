// SPDX-License-Identifier: GPL-3.0-or-later
// Uses what the library truelux_tools adds; exits with 0 if the answers are
// right.

#include <cstdio>
#include <stdexcept>
#include <string>

#include "truelux/compare.h"
#include "truelux/isolux.h"
#include "truelux/isomesh.h"
#include "truelux/picture.h"
#include "truelux/render.h"
#include "truelux/truelux.h"

#ifdef CGAL_VERSION
#error "the public headers must not include CGAL"
#endif

namespace {

/// Says what is wrong; returns how much that is.
int Expect(bool right, const char* what) {
  if (right) return 0;
  std::printf("wrong: %s\n", what);
  return 1;
}

bool NamesTheSurface(const truelux::Oracle& oracle) {
  try {
    (void)truelux::Render(oracle, "roof", {8, 0}, {});
  } catch (const std::invalid_argument& error) {
    return std::string(error.what()).starts_with("surface: ");
  }
  return false;
}

}  // namespace

int main() {
  truelux::SceneBuilder builder;
  builder.AddFace({{-1, -1, 1}, {-1, 1, 1}, {1, 1, 1}, {1, -1, 1}}, {1, 2, 3});
  builder.SetGroup("floor");
  builder.AddFace({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}});
  const truelux::Result<truelux::Scene> scene = builder.Build();
  if (!scene.ok()) return 1;
  const truelux::Oracle oracle(*scene.value);

  const truelux::Rendering rendering =
      truelux::Render(oracle, "floor", {4, 0}, {.wishes = {.arcs = true}});
  int failures =
      Expect(rendering.pixels.image.values.height() == 4, "Render: the size");
  truelux::Candidate candidate;
  candidate.receivers = rendering.receivers.pixels();
  candidate.values = rendering.pixels.image.values.pixels();
  failures += Expect(truelux::Compare(*scene.value, candidate, {}).passes(),
                     "Compare: the truth");
  for (truelux::Rgb& value : candidate.values)
    for (double& channel : value)
      channel *= 2;
  const truelux::CandidateComparison comparison =
      truelux::Compare(*scene.value, candidate, {.tolerance = 1e-6});
  std::printf("%s\n", comparison.diagnosis.text.c_str());
  failures += Expect(comparison.diagnosis.factor == 2, "Compare: the factor");
  truelux::PictureStyle style;
  failures += Expect(truelux::PictureOf(rendering.pixels.image, style)
                         .bytes.starts_with("\x89PNG"),
                     "PictureOf: PNG");
  style.is_exr = true;
  failures += Expect(truelux::PictureOf(rendering.pixels.image, style)
                         .bytes.starts_with("\x76\x2f\x31\x01"),
                     "PictureOf: EXR");
  failures += Expect(NamesTheSurface(oracle), "Render: what is wrong");
  truelux::IsoluxOptions levels;
  levels.count = 2;
  levels.smallest = 0.01;
  failures +=
      Expect(!truelux::IsoluxOf(oracle, "floor", levels).contours.empty(),
             "IsoluxOf: contours");
  failures += Expect(truelux::SurfaceLinesOf(oracle, "floor").is_complete,
                     "SurfaceLinesOf: all lines");
  const truelux::SurfaceExtrema extrema =
      truelux::ExtremaOf(oracle, "floor", {});
  failures += Expect(extrema.most > 1 && extrema.most < 1.1,
                     "ExtremaOf: the largest luminance");
  truelux::IsoMeshOptions mesh;
  mesh.contours = levels;
  mesh.error = 0.1;
  failures +=
      Expect(!truelux::IsoMeshOf(oracle, "floor", mesh).triangles.empty(),
             "IsoMeshOf: triangles");
  style.false_colour = true;
  failures += Expect(
      truelux::PictureContoursOf(oracle, "floor", rendering.pixels.image, style)
              .size() > 1,
      "PictureContoursOf: lines");
  return failures;
}
