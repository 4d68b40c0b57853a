// SPDX-License-Identifier: GPL-3.0-or-later
// What a run of side_by_side is asked.

#ifndef TRUELUX_BENCH_OPTIONS_H_
#define TRUELUX_BENCH_OPTIONS_H_

#include <cstdint>
#include <string>

namespace truelux::bench {

struct Options {
  bool quick = false;      ///< few receivers, small grid, about a minute
  std::string only;        ///< scenes whose names contain this; "": all
  std::string meshes;      ///< folder with OBJ files to measure; "": none
  std::string svg;         ///< where to draw the chart; "": nowhere
  std::string csv;         ///< where to write all measurements; "": nowhere
  std::uint64_t seed = 1;  ///< of scenes, receivers and samples

  /// `small` for a quick run, else `full`.
  template <class T>
  [[nodiscard]] T Size(T small, T full) const {
    return quick ? small : full;
  }

  /// Whether a scene is asked for.
  [[nodiscard]] bool Wants(const std::string& scene) const {
    return scene.find(only) != std::string::npos;
  }

  /// Whether scenes of the mesh suite are. They take minutes, so that a run of
  /// everything leaves them out; all their names begin alike.
  [[nodiscard]] bool WantsMeshes() const { return only.starts_with("meshes"); }
};

}  // namespace truelux::bench

#endif  // TRUELUX_BENCH_OPTIONS_H_
