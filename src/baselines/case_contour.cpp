#include "baselines/case_contour.h"

#include <utility>

#include "visibility/edges/contour_engine.h"

namespace truelux {

CaseContour::CaseContour(RegimeCase made) : case_(std::move(made)) {
  query_.receiver = case_.receiver;
  if (case_.loop.empty()) {
    query_.scene = case_.scene;
    const ContourEngine engine(query_.scene);
    ContourBuilder(engine).Build(query_, contour_);
  } else {
    TakeLoop();
  }
  weights_.assign(contour_.sources.size(), Rgb{1, 1, 1});
}

void CaseContour::TakeLoop() {
  const int count = static_cast<int>(case_.loop.size());
  for (int i = 0; i < count; ++i) {
    DirectionRecipe corner;
    corner.kind = DirectionRecipe::Kind::kVertex;
    corner.a = i;
    contour_.directions.push_back(corner);
    PlaneRecipe side;
    side.kind = PlaneRecipe::Kind::kEdge;
    side.a = i;
    side.b = (i + 1) % count;
    contour_.planes.push_back(side);
    // The loop is counter-clockwise, so that a x b points outwards, and a
    // contour's arcs run the other way.
    Arc arc;
    arc.plane = i;
    arc.positive = false;
    arc.from = side.b;
    arc.to = side.a;
    contour_.arcs.push_back(arc);
  }
  contour_.sources.push_back({0, 0, count});
}

WeightedContour CaseContour::Weighted() const {
  if (case_.loop.empty()) return {ViewOf(query_), contour_, weights_};
  const ReceiverView view{
      case_.loop, {}, case_.receiver.position, case_.receiver.normal};
  return {view, contour_, weights_};
}

}  // namespace truelux
