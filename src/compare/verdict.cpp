// SPDX-License-Identifier: GPL-3.0-or-later
#include "truelux/comparison.h"

namespace truelux {

std::string_view Name(Verdict verdict) {
  switch (verdict) {
    case Verdict::kNothingFails:
      return "nothing fails";
    case Verdict::kMistake:
      return "mistake";
    case Verdict::kOffFaces:
      return "receivers off their faces";
    case Verdict::kNoise:
      return "noise";
    case Verdict::kUnexplained:
      break;
  }
  return "unexplained";
}

}  // namespace truelux
