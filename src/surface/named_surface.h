// SPDX-License-Identifier: GPL-3.0-or-later
// A flat surface by the name that the scene's file gives it.

#ifndef TRUELUX_SURFACE_NAMED_SURFACE_H_
#define TRUELUX_SURFACE_NAMED_SURFACE_H_

#include <string>
#include <vector>

#include "truelux/diagnostics.h"
#include "truelux/scene.h"

#include "surface/surface_frame.h"

namespace truelux {

/// A surface, and what the user should know about it.
struct NamedSurface {
  SurfaceFrame frame;
  std::vector<Diagnostic> notes;
};

/// The faces of an object or a group. Notes if they look to different sides.
/// Throws std::invalid_argument if there is no such surface, or if it is not
/// flat.
[[nodiscard]] NamedSurface SurfaceNamed(const Scene& scene,
                                        const std::string& name);

}  // namespace truelux

#endif  // TRUELUX_SURFACE_NAMED_SURFACE_H_
