// SPDX-License-Identifier: GPL-3.0-or-later
// The steps of truelux/isomesh.h, for whoever watches.

#ifndef TRUELUX_ISOMESH_ISO_MESH_RUN_H_
#define TRUELUX_ISOMESH_ISO_MESH_RUN_H_

#include <string>

#include "truelux/isomesh.h"

#include "run/watch.h"

namespace truelux {

/// IsoMeshOf, with the watch in place of the options' hook and the oracle's stop
/// flag.
IsoMesh FindIsoMesh(const Oracle& oracle, const std::string& surface,
                    const IsoMeshOptions& options, const Watch& watch);

}  // namespace truelux

#endif  // TRUELUX_ISOMESH_ISO_MESH_RUN_H_
