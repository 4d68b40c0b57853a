// SPDX-License-Identifier: GPL-3.0-or-later
// What a PreparedScene holds, for the oracles over it.

#ifndef TRUELUX_RADIOMETRY_PREPARED_SCENE_H_
#define TRUELUX_RADIOMETRY_PREPARED_SCENE_H_

#include <memory>
#include <mutex>
#include <utility>

#include "truelux/prepared_scene.h"
#include "truelux/scene.h"

#include "base/pool.h"
#include "radiometry/derivatives/coincident_lines.h"
#include "radiometry/derivatives/loose_engine.h"
#include "radiometry/derivatives/scene_contacts.h"
#include "radiometry/evaluation_workspace.h"
#include "visibility/contour.h"
#include "visibility/edges/contour_engine.h"

namespace truelux {

/// What one thread needs for one receiver after the other, whatever the
/// options of the oracle that asks. It carries no result over; a user starts a
/// block of receivers, or ends the last one, before the first contour.
struct OracleWorkspace {
  explicit OracleWorkspace(const ContourEngine& engine) : builder(engine) {}

  /// Made when derivatives are first asked for.
  SeenLineFinder& Lines(const ContourEngine& engine) {
    if (!lines) lines = std::make_unique<SeenLineFinder>(engine);
    return *lines;
  }

  ContourBuilder builder;
  Contour contour;
  std::unique_ptr<SeenLineFinder> lines;
  EvaluationWorkspace evaluation;
};

/// What is prepared once; shared by the copies of a PreparedScene.
struct PreparedScene::Data {
  explicit Data(Scene given) : scene(std::move(given)), engine(scene) {}

  /// An idle workspace, or a new one.
  Pool<OracleWorkspace>::Loan Borrow() {
    return workspaces.Borrow(
        [this] { return std::make_unique<OracleWorkspace>(engine); });
  }

  /// Made when it is first asked for. Any thread may ask.
  const LooseEngine& GetLoose() {
    std::call_once(loose_is_made,
                   [this] { loose = std::make_unique<LooseEngine>(scene); });
    return *loose;
  }

  /// Made when it is first asked for. Any thread may ask.
  const SceneContacts& GetContacts() {
    std::call_once(contacts_are_made, [this] {
      contacts = std::make_unique<SceneContacts>(engine);
    });
    return *contacts;
  }

  Scene scene;
  ContourEngine engine;
  std::once_flag contacts_are_made;
  std::unique_ptr<const SceneContacts> contacts;
  std::once_flag loose_is_made;
  std::unique_ptr<const LooseEngine> loose;
  Pool<OracleWorkspace> workspaces;
};

}  // namespace truelux

#endif  // TRUELUX_RADIOMETRY_PREPARED_SCENE_H_
