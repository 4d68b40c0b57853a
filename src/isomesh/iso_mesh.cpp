// SPDX-License-Identifier: GPL-3.0-or-later
#include "truelux/isomesh.h"

#include "isomesh/iso_mesh_run.h"

namespace truelux {

std::string_view Name(MeshSide side) {
  switch (side) {
    case MeshSide::kInside:
      break;
    case MeshSide::kContour:
      return "contour";
    case MeshSide::kKink:
      return "kink";
    case MeshSide::kJump:
      return "jump";
    case MeshSide::kOutline:
      return "outline";
  }
  return "inside";
}

IsoMesh IsoMeshOf(const Oracle& oracle, const std::string& surface,
                  const IsoMeshOptions& options) {
  return FindIsoMesh(
      oracle, surface, options,
      {.stop = oracle.options().stop, .hook = options.contours.progress});
}

}  // namespace truelux
