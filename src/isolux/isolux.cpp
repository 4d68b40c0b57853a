// SPDX-License-Identifier: GPL-3.0-or-later
#include "truelux/isolux.h"

#include "isolux/extrema_run.h"
#include "isolux/isolux_run.h"

namespace truelux {

std::string_view Name(SurfaceLineKind kind) {
  return kind == SurfaceLineKind::kJump ? "jump" : "kink";
}

std::string_view Name(ContourPlace place) {
  switch (place) {
    case ContourPlace::kInside:
      break;
    case ContourPlace::kKink:
      return "kink";
    case ContourPlace::kJump:
      return "jump";
    case ContourPlace::kOutline:
      return "outline";
  }
  return "inside";
}

std::string_view Name(ExtremumKind kind) {
  switch (kind) {
    case ExtremumKind::kMaximum:
      break;
    case ExtremumKind::kMinimum:
      return "minimum";
    case ExtremumKind::kSaddle:
      return "saddle";
  }
  return "maximum";
}

SurfaceLines SurfaceLinesOf(const Oracle& oracle, const std::string& surface) {
  return FindSurfaceLines(oracle, surface, {.stop = oracle.options().stop});
}

Isolux IsoluxOf(const Oracle& oracle, const std::string& surface,
                const IsoluxOptions& options) {
  return FindIsolux(oracle, surface, options,
                    {.stop = oracle.options().stop, .hook = options.progress});
}

SurfaceExtrema ExtremaOf(const Oracle& oracle, const std::string& surface,
                         const ExtremaOptions& options) {
  return FindExtrema(oracle, surface, options,
                     {.stop = oracle.options().stop, .hook = options.progress});
}

}  // namespace truelux
