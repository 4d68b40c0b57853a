#include "report/shadow_class.h"

#include "report/receiver_reason.h"

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
  if (contour.arcs.empty()) {
    return contour.statistics.sources == 0 ? ShadowClass::kNoSource
                                           : ShadowClass::kUmbra;
  }
  const ReceiverTraits traits = TraitsOf(scene, receiver, contour);
  if (traits.conjunctions > 0) return ShadowClass::kConjunctive;
  return traits.lighting == Lighting::kFullyLit ? ShadowClass::kLit
                                                : ShadowClass::kPenumbra;
}

}  // namespace truelux
