// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes and receivers on which classic mistakes matter.

#ifndef TRUELUX_TESTS_COMPARE_STAGES_H_
#define TRUELUX_TESTS_COMPARE_STAGES_H_

#include <random>
#include <string>
#include <vector>

#include "truelux/io.h"
#include "truelux/receiver.h"
#include "truelux/scene.h"

#include "support/scenes.h"

namespace truelux::testing {

struct Stage {
  Scene scene;
  std::vector<Receiver> receivers;
};

/// The Cornell box with its floor, 12 x 12 receivers.
inline Stage CornellBox() {
  Stage stage;
  stage.scene =
      *ReadScene(std::string(TRUELUX_EXAMPLES) + "/scenes/cornell_box.obj")
           .value;
  for (int i = 0; i < 12; ++i) {
    for (int j = 0; j < 12; ++j) {
      stage.receivers.push_back(
          {{25.0 + 45 * i, 0, 25.0 + 46 * j}, {0, 1, 0}, 1});
    }
  }
  return stage;
}

inline Ring Wall(double x, double half, double low, double high) {
  return {{x, -half, low}, {x, -half, high}, {x, half, high}, {x, half, low}};
}

inline Ring Mirrored(const Ring& ring) {
  Ring mirrored;
  for (const Point3& p : ring)
    mirrored.push_back({-p.x, -p.y, p.z});
  return mirrored;
}

inline std::vector<Receiver> TiltedReceivers() {
  std::vector<Receiver> receivers;
  receivers.reserve(150);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 150; ++i) {
    receivers.push_back({{uniform(random), uniform(random), 0},
                         {uniform(random), uniform(random), 0.6},
                         0});
  }
  return receivers;
}

/// Lamps that reach below many a receiver's horizon; none hides another.
inline Stage AcrossTheHorizon() {
  SceneBuilder builder("stage");
  builder.SetGroup("right");
  builder.AddFace(Wall(2, 1, -1.5, 1.5), {4, 2, 1});
  builder.SetGroup("left");
  builder.AddFace(Mirrored(Wall(2, 1, -1, 0.5)), {1, 3, 2});
  builder.SetGroup("lid");
  builder.AddFace(Ceiling(-1, 1, -1, 1, 2.5), {2, 2, 2});
  return {*builder.Build().value, TiltedReceivers()};
}

/// The same with a lamp whose back is seen, and with two blockers.
inline Stage WithBacksAndBlockers() {
  SceneBuilder builder("stage");
  builder.SetGroup("right");
  builder.AddFace(Wall(2, 1, -1.5, 1.5), {4, 2, 1});
  builder.SetGroup("away");
  builder.AddFace(Reversed(Mirrored(Wall(2, 1.5, -1, 1))), {3, 3, 2});
  builder.SetGroup("lid");
  builder.AddFace(Ceiling(-1, 1, -1, 1, 2.5), {2, 2, 2});
  builder.SetGroup("board");
  builder.AddFace(Ceiling(-0.7, 0.2, -0.5, 0.9, 1.25));
  builder.SetGroup("screen");
  builder.AddFace(Wall(1.5, 0.5, 0.25, 0.75));
  return {*builder.Build().value, TiltedReceivers()};
}

}  // namespace truelux::testing

#endif  // TRUELUX_TESTS_COMPARE_STAGES_H_
