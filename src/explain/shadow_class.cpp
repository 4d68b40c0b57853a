// SPDX-License-Identifier: GPL-3.0-or-later
#include "explain/shadow_class.h"

#include "explain/receiver_reason.h"

namespace truelux {

const char* Name(ShadowClass shadow) {
  switch (shadow) {
    case ShadowClass::kNothing:
      break;
    case ShadowClass::kNoSource:
      return "no source in front";
    case ShadowClass::kUmbra:
      return "umbra";
    case ShadowClass::kPenumbra:
      return "penumbra";
    case ShadowClass::kLit:
      return "lit";
    case ShadowClass::kConjunctive:
      return "conjunctive";
  }
  return "nothing";
}

ShadowClass ShadowClassOf(const Scene& scene, const Receiver& receiver,
                          const VisibleContour& contour) {
  const ReceiverTraits traits = TraitsOf(scene, receiver, contour);
  if (traits.conjunctions > 0) return ShadowClass::kConjunctive;
  switch (traits.lighting) {
    case Lighting::kUnlit:
      break;
    case Lighting::kUmbra:
      return ShadowClass::kUmbra;
    case Lighting::kFullyLit:
      return ShadowClass::kLit;
    case Lighting::kPenumbra:
      return ShadowClass::kPenumbra;
  }
  return ShadowClass::kNoSource;
}

}  // namespace truelux
