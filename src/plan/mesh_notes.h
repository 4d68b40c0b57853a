// SPDX-License-Identifier: GPL-3.0-or-later
// What was measured about an iso-mesh, in words.

#ifndef TRUELUX_PLAN_MESH_NOTES_H_
#define TRUELUX_PLAN_MESH_NOTES_H_

#include <string>
#include <vector>

#include "truelux/isomesh.h"

namespace truelux {

/// A sentence each, the most important first.
[[nodiscard]] std::vector<std::string> MeshNotes(const IsoMesh& mesh);

}  // namespace truelux

#endif  // TRUELUX_PLAN_MESH_NOTES_H_
