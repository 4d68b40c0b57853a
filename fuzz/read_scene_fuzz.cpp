// SPDX-License-Identifier: GPL-3.0-or-later
// Feeds the OBJ and MTL readers with any bytes. What they accept must be a
// scene that keeps its promises; what they refuse needs a reason.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <string_view>

#include "truelux/scene.h"

#include "scene/io/read_scene.h"
#include "scene/io/text_file.h"

namespace {

/// The OBJ text ends here; the rest is the MTL file, whatever its name.
constexpr std::string_view kSeparator = "%%\n";

void Require(bool condition) {
  if (!condition) std::abort();
}

void CheckScene(const truelux::Scene& scene) {
  const auto vertices = static_cast<int>(scene.vertices().size());
  const auto facets = static_cast<int>(scene.facets().size());
  for (const truelux::Triangle& triangle : scene.triangles()) {
    Require(triangle.facet >= 0 && triangle.facet < facets);
    const std::set<int> corners(triangle.vertices.begin(),
                                triangle.vertices.end());
    Require(corners.size() == 3);
    Require(*corners.begin() >= 0 && *corners.rbegin() < vertices);
  }
  int next_facet = 0;
  for (const truelux::Face& face : scene.faces()) {
    if (face.facet_count == 0) continue;
    Require(face.first_facet == next_facet);
    next_facet += face.facet_count;
    for (const double emission : face.emission)
      Require(emission >= 0);
  }
  Require(next_facet == facets);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const std::size_t end = bytes.find(kSeparator);
  const std::string_view obj = bytes.substr(0, end);
  const std::string_view mtl =
      end == bytes.npos ? "" : bytes.substr(end + kSeparator.size());
  const auto open = [&](const std::filesystem::path& path) {
    truelux::TextFile file;
    file.status = truelux::TextFile::Status::kRead;
    file.text = path == "fuzz.obj" ? obj : mtl;
    return file;
  };
  const auto list = [](const std::filesystem::path& /*folder*/) {
    return std::vector<std::string>();
  };
  truelux::ReadOptions options;
  const truelux::Result<truelux::Scene> strict =
      truelux::ReadSceneWith({open, list}, "fuzz.obj", options);
  Require(strict.ok() || !strict.diagnostics.empty());
  if (strict.ok()) CheckScene(*strict.value);
  options.lenient = true;
  options.two_sided = true;
  options.opaque_from = 0.5;
  const truelux::Result<truelux::Scene> lenient =
      truelux::ReadSceneWith({open, list}, "fuzz.obj", options);
  Require(lenient.ok() || !strict.ok());
  if (lenient.ok()) CheckScene(*lenient.value);
  return 0;
}
