// SPDX-License-Identifier: GPL-3.0-or-later
// The whole library by inclusion.
//
//   #include "truelux/truelux.h"
//
//   truelux::Result<truelux::Scene> scene = truelux::ReadScene("room.obj");
//   if (!scene.ok()) { /* scene.diagnostics says why */ }
//   truelux::Oracle oracle(*scene.value);
//   truelux::Receiver receiver{{0, 0, 0}, {0, 0, 1}};
//   truelux::Irradiance e = oracle.Evaluate(receiver);
//   // e.value[0] is the binary64 nearest to the red irradiance [W/m^2].

#ifndef TRUELUX_TRUELUX_H_
#define TRUELUX_TRUELUX_H_

#include "truelux/derivatives.h"
#include "truelux/diagnostics.h"
#include "truelux/form_factors.h"
#include "truelux/formulas.h"
#include "truelux/geometry.h"
#include "truelux/io.h"
#include "truelux/irradiance.h"
#include "truelux/prepared_scene.h"
#include "truelux/receiver.h"
#include "truelux/scene.h"
#include "truelux/sphere.h"
#include "truelux/statistics.h"
#include "truelux/stop.h"
#include "truelux/version.h"
#include "truelux/visibility.h"

#endif  // TRUELUX_TRUELUX_H_
