// SPDX-License-Identifier: GPL-3.0-or-later
// What contours are of, for the files that show them.

#ifndef TRUELUX_PLAN_PLAN_SUBJECT_H_
#define TRUELUX_PLAN_PLAN_SUBJECT_H_

#include <string>
#include <vector>

#include "truelux/irradiance.h"

#include "plan/plan_objects.h"

namespace truelux {

/// The words that go with an Isolux.
struct PlanSubject {
  std::string scene;    ///< the name of its file
  std::string surface;  ///< as the user named it
  std::string
      channel;  ///< "luminance", "r", "g", "b", or "all" of a grey scene
  OracleOptions options;
  /// By index into Scene::vertices(): how the scene's file counts them.
  std::vector<int> vertex_numbers;
  /// What is above the surface, for plans that show it.
  std::vector<PlanObject> objects;
};

}  // namespace truelux

#endif  // TRUELUX_PLAN_PLAN_SUBJECT_H_
