// SPDX-License-Identifier: GPL-3.0-or-later
#include "image/camera_pixels.h"

#include <cstddef>

#include "scene/facet_normal.h"

namespace truelux {

CameraPixels::CameraPixels(const Scene& scene, const CameraFrame& frame,
                           int width, int height)
    : PixelReceivers(width, height),
      scene_(scene),
      frame_(frame),
      finder_(scene) {
  const std::size_t facets = scene.facets().size();
  const auto pixels =
      static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (facets > pixels) return;
  normals_.reserve(facets);
  for (std::size_t i = 0; i < facets; ++i)
    normals_.push_back(FacetNormal(scene, static_cast<int>(i)));
}

std::optional<Receiver> CameraPixels::At(int x, int y) const {
  const Ray ray{frame_.eye, frame_.DirectionThrough(x, y, width(), height())};
  const std::optional<FirstHit> hit = finder_.Find(ray);
  if (!hit) return std::nullopt;
  const int facet =
      scene_.triangles()[static_cast<std::size_t>(hit->triangle)].facet;
  Vector3 normal = normals_.empty() ? FacetNormal(scene_, facet)
                                    : normals_[static_cast<std::size_t>(facet)];
  // Not a bare minus: zeros stay without a sign.
  if (!hit->from_front) normal = {0 - normal.x, 0 - normal.y, 0 - normal.z};
  return Receiver{finder_.PointOn(ray, *hit), normal,
                  scene_.facets()[static_cast<std::size_t>(facet)].face + 1};
}

}  // namespace truelux
