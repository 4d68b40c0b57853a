// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/source_slice.h"

#include "exact/number.h"
#include "exact/vec3.h"

namespace truelux {
namespace {

void Clear(Contour& contour) {
  contour.planes.clear();
  contour.directions.clear();
  contour.explicit_vectors.Clear();
  contour.arcs.clear();
  contour.sources.clear();
  contour.is_joined = false;
  contour.statistics = {};
}

}  // namespace

SourceSlicer::SourceSlicer(const Contour& contour)
    : contour_(contour),
      plane_in_slice_(contour.planes.size()),
      direction_in_slice_(contour.directions.size()) {}

void SourceSlicer::Take(SourceId first, int count, Contour& slice) {
  Clear(slice);
  slice_ = &slice;
  for (const SourceId source : IdRange<SourceId>(first, count))
    AddSource(contour_.sources[source]);
  for (const PlaneId plane : planes_)
    plane_in_slice_[plane] = {};
  for (const DirectionId direction : directions_)
    direction_in_slice_[direction] = {};
  planes_.clear();
  directions_.clear();
}

void SourceSlicer::AddSource(const SourceArcs& source) {
  slice_->sources.push_back(
      {source.facet, slice_->arcs.end_id(), source.arc_count});
  for (Arc arc : contour_.ArcsOf(source)) {
    arc.plane = PlaneOf(arc.plane);
    arc.from = DirectionOf(arc.from);
    arc.to = DirectionOf(arc.to);
    slice_->arcs.push_back(arc);
  }
}

PlaneId SourceSlicer::PlaneOf(PlaneId plane) {
  if (plane_in_slice_[plane].valid()) return plane_in_slice_[plane];
  PlaneRecipe recipe = contour_.planes[plane];
  if (recipe.kind() == PlaneRecipe::Kind::kExplicit) {
    recipe = PlaneRecipe::Explicit(
                 slice_->explicit_vectors.Add(
                     contour_.explicit_vectors[recipe.explicit_vector()]))
                 .NegatedIf(recipe.negated());
  }
  const PlaneId taken = slice_->planes.push_back(recipe);
  planes_.push_back(plane);
  plane_in_slice_[plane] = taken;
  return taken;
}

DirectionId SourceSlicer::DirectionOf(DirectionId direction) {
  if (direction_in_slice_[direction].valid())
    return direction_in_slice_[direction];
  DirectionRecipe recipe = contour_.directions[direction];
  if (recipe.kind() == DirectionRecipe::Kind::kExplicit) {
    recipe = DirectionRecipe::Explicit(
                 slice_->explicit_vectors.Add(
                     contour_.explicit_vectors[recipe.explicit_vector()]))
                 .NegatedIf(recipe.negated());
  } else if (recipe.kind() == DirectionRecipe::Kind::kCrossing) {
    recipe = DirectionRecipe::Crossing(PlaneOf(recipe.first_plane()),
                                       PlaneOf(recipe.second_plane()))
                 .NegatedIf(recipe.negated());
  }
  const DirectionId taken = slice_->directions.push_back(recipe);
  directions_.push_back(direction);
  direction_in_slice_[direction] = taken;
  return taken;
}

}  // namespace truelux
