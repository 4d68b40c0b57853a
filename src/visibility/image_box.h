// Conservative boxes in a source's plane: cones whose boxes are apart share no
// direction. (Boxes only save time; nothing depends on how tight they are.)

#ifndef TRUELUX_VISIBILITY_IMAGE_BOX_H_
#define TRUELUX_VISIBILITY_IMAGE_BOX_H_

#include <algorithm>
#include <cmath>

#include "exact/number.h"
#include "exact/vec3.h"

namespace truelux {

/// A closed box that contains the image; by default the whole plane.
struct ImageBox {
  double x_min = -HUGE_VAL;
  double x_max = HUGE_VAL;
  double y_min = -HUGE_VAL;
  double y_max = HUGE_VAL;

  [[nodiscard]] bool Meets(const ImageBox& other) const {
    return x_min <= other.x_max && other.x_min <= x_max &&
           y_min <= other.y_max && other.y_min <= y_max;
  }

  void Include(const ImageBox& other) {
    x_min = std::min(x_min, other.x_min);
    x_max = std::max(x_max, other.x_max);
    y_min = std::min(y_min, other.y_min);
    y_max = std::max(y_max, other.y_max);
  }
};

/// Where directions meet a plane parallel to the source's, in two of the three
/// coordinates. Requires RoundUpward.
class ImageChart {
 public:
  /// away: the source's normal, as intervals, pointing away from r.
  explicit ImageChart(const Vec3<Interval>& away) : away_(away) {
    const auto size = [](const Interval& c) {
      return std::max(std::fabs(c.inf()), std::fabs(c.sup()));
    };
    const double x = size(away.x);
    const double y = size(away.y);
    const double z = size(away.z);
    dropped_ = z >= x && z >= y ? 2 : (y >= x ? 1 : 0);
  }

  /// Whether the direction certainly never meets the source's plane.
  [[nodiscard]] bool Misses(const Vec3<Interval>& d) const {
    return Dot(away_, d).sup() <= 0;
  }

  /// The image of one direction; the whole plane unless it certainly points
  /// away from the parallel plane through r.
  [[nodiscard]] ImageBox Of(const Vec3<Interval>& d) const {
    const Interval depth = Dot(away_, d);
    if (!(depth.inf() > 0)) return {};
    const Interval x = (dropped_ == 0 ? d.y : d.x) / depth;
    const Interval y = (dropped_ == 2 ? d.y : d.z) / depth;
    if (!(x.inf() <= x.sup() && y.inf() <= y.sup())) return {};  // NaN
    return {x.inf(), x.sup(), y.inf(), y.sup()};
  }

 private:
  Vec3<Interval> away_;
  int dropped_;  ///< the coordinate along which the normal is longest
};

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_IMAGE_BOX_H_
