// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/edges/source_plane.h"

namespace truelux {

template <class Geometry>
void SourcePlane<Geometry>::Start(TriangleId triangle) {
  triangle_ = triangle;
  chart_ = ImageChart(geometry_.TriangleNormalFilter(triangle));
  entries_.Clear();
}

template <class Geometry>
auto SourcePlane<Geometry>::MakeEntry(ViewDirectionId direction) -> Entry& {
  entries_.Cover(geometry_.direction_count());
  Entry& entry = entries_.Renew(direction);
  entry.box = chart_.Of(geometry_.DirectionFilter(direction), entry.misses);
  entry.side = CachedSign();
  return entry;
}

template <class Geometry>
bool SourcePlane<Geometry>::BoxOfVertices(std::span<const VertexId> vertices,
                                          ImageBox& box) {
  bool misses = true;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const Entry& entry = EntryOf(geometry_.VertexDirection(vertices[k]));
    misses = misses && entry.misses;
    if (k == 0) {
      box = entry.box;
    } else {
      box.Include(entry.box);
    }
  }
  return !misses;
}

template <class Geometry>
ImageBox SourcePlane<Geometry>::BoxOf(const Cone& cone) {
  ImageBox box = EntryOf(cone.directions[0]).box;
  for (std::size_t k = 1; k < cone.size; ++k) {
    box.Include(EntryOf(cone.directions[k]).box);
  }
  return box;
}

template <class Geometry>
ImageBox SourcePlane<Geometry>::BoxOfEdge(ViewDirectionId from,
                                          ViewDirectionId to) {
  ImageBox box = EntryOf(from).box;
  box.Include(EntryOf(to).box);
  return box;
}

template class SourcePlane<ViewGeometry>;
template class SourcePlane<UnfilteredViewGeometry>;
template class SourcePlane<DisplacedViewGeometry>;

}  // namespace truelux
