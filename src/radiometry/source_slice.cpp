#include "radiometry/source_slice.h"

#include <cstddef>

#include "exact/number.h"
#include "exact/vec3.h"

namespace truelux {
namespace {

constexpr int kNotTaken = -1;

std::size_t Index(int i) {
  return static_cast<std::size_t>(i);
}

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
      plane_index_(contour.planes.size(), kNotTaken),
      direction_index_(contour.directions.size(), kNotTaken) {}

void SourceSlicer::Take(std::size_t first, std::size_t count, Contour& slice) {
  Clear(slice);
  slice_ = &slice;
  for (std::size_t i = first; i < first + count; ++i)
    AddSource(contour_.sources[i]);
  for (const int plane : planes_)
    plane_index_[Index(plane)] = kNotTaken;
  for (const int direction : directions_)
    direction_index_[Index(direction)] = kNotTaken;
  planes_.clear();
  directions_.clear();
}

void SourceSlicer::AddSource(const SourceArcs& source) {
  slice_->sources.push_back(
      {source.facet, static_cast<int>(slice_->arcs.size()), source.arc_count});
  for (int a = source.first_arc; a < source.first_arc + source.arc_count; ++a) {
    Arc arc = contour_.arcs[Index(a)];
    arc.plane = PlaneIndex(arc.plane);
    arc.from = DirectionIndex(arc.from);
    arc.to = DirectionIndex(arc.to);
    slice_->arcs.push_back(arc);
  }
}

int SourceSlicer::PlaneIndex(int plane) {
  int& index = plane_index_[Index(plane)];
  if (index != kNotTaken) return index;
  PlaneRecipe recipe = contour_.planes[Index(plane)];
  if (recipe.kind == PlaneRecipe::Kind::kExplicit)
    recipe.a =
        slice_->explicit_vectors.Add(contour_.explicit_vectors[recipe.a]);
  index = static_cast<int>(slice_->planes.size());
  planes_.push_back(plane);
  slice_->planes.push_back(recipe);
  return index;
}

int SourceSlicer::DirectionIndex(int direction) {
  int& index = direction_index_[Index(direction)];
  if (index != kNotTaken) return index;
  DirectionRecipe recipe = contour_.directions[Index(direction)];
  if (recipe.kind == DirectionRecipe::Kind::kExplicit) {
    recipe.a =
        slice_->explicit_vectors.Add(contour_.explicit_vectors[recipe.a]);
  } else if (recipe.kind == DirectionRecipe::Kind::kCrossing) {
    recipe.a = PlaneIndex(recipe.a);
    recipe.b = PlaneIndex(recipe.b);
  }
  index = static_cast<int>(slice_->directions.size());
  directions_.push_back(direction);
  slice_->directions.push_back(recipe);
  return index;
}

}  // namespace truelux
