// SPDX-License-Identifier: GPL-3.0-or-later
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
    const int next = (i + 1) % count;
    contour_.directions.push_back(DirectionRecipe::ToVertex(VertexId(i)));
    // The loop is counter-clockwise, so that a x b points outwards, and a
    // contour's arcs run the other way. Direction i is that to vertex i.
    Arc arc;
    arc.plane = contour_.planes.push_back(
        PlaneRecipe::OfEdge(VertexId(i), VertexId(next)));
    arc.positive = false;
    arc.from = DirectionId(next);
    arc.to = DirectionId(i);
    contour_.arcs.push_back(arc);
  }
  contour_.sources.push_back({FacetId(0), ArcId(0), count});
}

WeightedContour CaseContour::Weighted() const {
  if (case_.loop.empty()) return {ViewOf(query_), contour_, weights_};
  const ReceiverView view{IdSpan<VertexId, const Point3>(case_.loop),
                          {},
                          case_.receiver.position,
                          case_.receiver.normal};
  return {view, contour_, weights_};
}

}  // namespace truelux
