// SPDX-License-Identifier: GPL-3.0-or-later
// The names of what can be chosen, one switch each: without a default, so that
// the compiler asks for the name of a new enumerator.

#include <string_view>

#include "truelux/derivatives.h"
#include "truelux/diagnostics.h"
#include "truelux/formulas.h"
#include "truelux/irradiance.h"
#include "truelux/visibility.h"

namespace truelux {

std::string_view Name(Severity severity) {
  switch (severity) {
    case Severity::kError:
      return "error";
    case Severity::kNote:
      return "note";
  }
  return "";
}

std::string_view Name(Smoothness smoothness) {
  switch (smoothness) {
    case Smoothness::kC1:
      return "C1";
    case Smoothness::kKink:
      return "kink";
    case Smoothness::kDiscontinuous:
      return "discontinuous";
  }
  return "";
}

std::string_view Name(Arithmetic arithmetic) {
  switch (arithmetic) {
    case Arithmetic::kFloat:
      return "float";
    case Arithmetic::kDouble:
      return "double";
    case Arithmetic::kDoubleDouble:
      return "double-double";
    case Arithmetic::kMultiprecision:
      return "MPFR";
  }
  return "";
}

std::string_view Name(VertexKind kind) {
  switch (kind) {
    case VertexKind::kIntrinsic:
      return "intrinsic";
    case VertexKind::kHorizon:
      return "horizon";
    case VertexKind::kApparent:
      return "apparent";
  }
  return "";
}

std::string_view Name(Engine engine) {
  switch (engine) {
    case Engine::kContour:
      return "contour";
    case Engine::kArrangement:
      return "arrangement";
    case Engine::kAngularSpans:
      return "angular-spans";
  }
  return "";
}

std::string_view Name(Method method) {
  switch (method) {
    case Method::kCertified:
      return "certified";
    case Method::kDouble:
      return "double";
  }
  return "";
}

std::string_view Name(Emission emission) {
  switch (emission) {
    case Emission::kExitance:
      return "exitance";
    case Emission::kRadiance:
      return "radiance";
  }
  return "";
}

}  // namespace truelux
