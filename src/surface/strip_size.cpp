// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/strip_size.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <utility>

#include "exact/multiprecision.h"
#include "exact/rational.h"

namespace truelux {
namespace {

constexpr mpfr_prec_t kPrecision = 512;
/// What is left of the arcs after as many bits have cancelled is taken as 0.
constexpr long kZeroBits = 160;
/// Double may lose 2^kLostBits of 2^-53.
constexpr double kMostLost = 0x1p-8;

Multiprecision RealOf(const mpq_class& q) {
  Multiprecision x(kPrecision);
  mpfr_set_q(x.get(), q.get_mpq_t(), MPFR_RNDN);
  return x;
}

/// The sum of jump g.w in an arc: x times the first and y times the second
/// coordinate of w.
struct Form {
  mpq_class x;
  mpq_class y;
};

Form FormOf(const PlaneCut& cut, const StripArc& arc, const mpq_class& t,
            std::size_t channel) {
  Form form;
  for (const StripStep& step : arc.steps) {
    const mpq_class& jump = step.jump[channel];
    if (jump == 0) continue;
    const CutLine& line = cut.lines[static_cast<std::size_t>(step.line)];
    const mpq_class inverse = 1 / line.HeightAt(t);
    if (!line.is_level) form.x += jump * inverse;
    form.y += jump * line.b * inverse;
  }
  return form;
}

/// A sum, and that of the sizes of its terms.
struct Sum {
  double value = 0;
  double size = 0;

  void Add(double term) {
    value += term;
    size += std::fabs(term);
  }
};

/// Sums in double, with angles from the trace and lengths of 1.
class NearSum {
 public:
  explicit NearSum(const CutAxes& axes)
      : along_(std::sqrt(NearestTo(Dot(axes.along, axes.along)))),
        up_(std::sqrt(NearestTo(Dot(axes.up, axes.up)))) {}

  /// Adds the integral of sin a (x cos a / |along| + y sin a / |up|) over the
  /// angles a of an arc.
  void Add(const StripArc& arc, const Form& form, Sum& sum) const {
    double x = NearestTo(form.x) / along_;
    const double y = NearestTo(form.y) / up_;
    const auto cotangent = [this](const std::optional<mpq_class>& u,
                                  double otherwise) {
      return u ? NearestTo(*u) * along_ / up_ : otherwise;
    };
    double from = cotangent(arc.from, -HUGE_VAL);
    double to = cotangent(arc.to, HUGE_VAL);
    double angle = 0;
    if (arc.from && arc.to) {
      const double width =
          NearestTo(mpq_class(*arc.to - *arc.from)) * along_ / up_;
      angle = std::atan2(width, 1 + from * to);
    }
    if (from + to < 0) {
      // Small angles are known better than those near pi.
      const double before = from;
      from = -to;
      to = -before;
      x = -x;
    }
    const double least = std::isfinite(to) ? std::atan2(1, to) : 0;
    if (!arc.from || !arc.to) {
      angle = std::isfinite(from) ? std::atan2(1, from) - least
                                  : std::numbers::pi - least;
    }
    AddMiddle(least + angle / 2, angle / 2, x, y, sum);
  }

 private:
  static void AddMiddle(double middle, double half, double x, double y,
                        Sum& sum) {
    // sin(2 half) / (2 half), and what it lacks to 1.
    const double whole = 2 * half;
    const double lack =
        whole < 0.05
            ? whole * whole / 6 *
                  (1 - whole * whole / 20 *
                           (1 - whole * whole / 42 * (1 - whole * whole / 72)))
            : 1 - std::sin(whole) / whole;
    const double sine = std::sin(middle);
    sum.Add(half * y * lack);
    sum.Add(half * y * (1 - lack) * 2 * sine * sine);
    sum.Add(half * x * (1 - lack) * 2 * sine * std::cos(middle));
  }

  double along_;  ///< |along|
  double up_;     ///< |up|
};

/// The same with many bits; nothing where all cancels.
class FarSum {
 public:
  explicit FarSum(const CutAxes& axes)
      : along_(Sqrt(RealOf(Dot(axes.along, axes.along)))),
        up_(Sqrt(RealOf(Dot(axes.up, axes.up)))),
        half_(kPrecision, 0.5),
        value_(kPrecision, 0),
        size_(kPrecision, 0) {}

  void Add(const StripArc& arc, const Form& form) {
    const Multiprecision x = RealOf(form.x) / along_;
    const Multiprecision y = RealOf(form.y) / up_;
    const Place first = PlaceOf(arc.to, true);
    const Place last = PlaceOf(arc.from, false);
    const Multiprecision by_x =
        x * (last.sine * last.sine - first.sine * first.sine);
    const Multiprecision by_y =
        y * (last.angle - first.angle - last.sine * last.cosine +
             first.sine * first.cosine);
    const Multiprecision term = half_ * (by_x + by_y);
    value_ = value_ + term;
    Multiprecision size(kPrecision);
    mpfr_abs(size.get(), term.get(), MPFR_RNDN);
    size_ = size_ + size;
  }

  [[nodiscard]] std::optional<double> Total() const {
    Multiprecision least = size_;
    mpfr_mul_2si(least.get(), least.get(), -kZeroBits, MPFR_RNDN);
    if (mpfr_cmpabs(value_.get(), least.get()) <= 0) return std::nullopt;
    return value_.ToDouble();
  }

 private:
  struct Place {
    Multiprecision angle;
    Multiprecision sine;
    Multiprecision cosine;
  };

  [[nodiscard]] Place PlaceOf(const std::optional<mpq_class>& u,
                              bool is_right) const {
    const Multiprecision zero(kPrecision, 0);
    if (!u) {
      return {is_right ? zero : PiOf(kPrecision), zero,
              Multiprecision(kPrecision, is_right ? 1 : -1)};
    }
    const Multiprecision x = RealOf(*u) * along_;
    const Multiprecision length = Sqrt(x * x + up_ * up_);
    return {Angle(up_, x), up_ / length, x / length};
  }

  Multiprecision along_;
  Multiprecision up_;
  Multiprecision half_;
  Multiprecision value_;
  Multiprecision size_;
};

}  // namespace

Rgb KinkSizeOf(const PlaneCut& cut, std::span<const StripArc> arcs,
               const mpq_class& t) {
  const CutAxes& axes = cut.axes;
  // n.w is this times the sine of the angle of w from the trace.
  const double slope = NearestTo(Dot(axes.surface, axes.up)) /
                       std::sqrt(NearestTo(Dot(axes.surface, axes.surface))) /
                       std::sqrt(NearestTo(Dot(axes.up, axes.up)));
  const NearSum near(axes);
  Rgb size{};
  for (std::size_t channel = 0; channel < 3; ++channel) {
    std::vector<std::pair<const StripArc*, Form>> forms;
    for (const StripArc& arc : arcs) {
      Form form = FormOf(cut, arc, t, channel);
      if (form.x != 0 || form.y != 0) forms.emplace_back(&arc, std::move(form));
    }
    Sum sum;
    for (const auto& [arc, form] : forms)
      near.Add(*arc, form, sum);
    double value = sum.value;
    if (!(std::fabs(sum.value) > kMostLost * sum.size)) {
      FarSum far(axes);
      for (const auto& [arc, form] : forms)
        far.Add(*arc, form);
      value = far.Total().value_or(0);
    }
    size[channel] = value == 0 ? 0 : -slope * value / (2 * std::numbers::pi);
  }
  return size;
}

}  // namespace truelux
