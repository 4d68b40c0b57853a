// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/derivatives/exact_form.h"

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "exact/exact_conversion.h"

namespace truelux {
namespace {

/// The root of a rational that is a square.
std::optional<mpq_class> RootOf(const mpq_class& x) {
  if (mpz_perfect_square_p(x.get_num_mpz_t()) == 0 ||
      mpz_perfect_square_p(x.get_den_mpz_t()) == 0) {
    return std::nullopt;
  }
  mpq_class root;
  mpz_sqrt(root.get_num_mpz_t(), x.get_num_mpz_t());
  mpz_sqrt(root.get_den_mpz_t(), x.get_den_mpz_t());
  return root;
}

/// real + imaginary sqrt(-R).
struct RootNumber {
  mpq_class real = 1;
  mpq_class imaginary = 0;
};

RootNumber Product(const RootNumber& a, const RootNumber& b,
                   const mpq_class& r) {
  return {a.real * b.real - r * a.imaginary * b.imaginary,
          a.real * b.imaginary + a.imaginary * b.real};
}

/// The arcs of one square class whose coefficients agree up to their sign.
struct AngleGroup {
  RootNumber product;
  double turns = 0;  ///< the sum of the angles over pi, nearly
};

/// The arcs of one square class: |N_i| = rho_i sqrt(R).
struct SquareClass {
  mpq_class square;                        ///< R
  std::map<mpq_class, AngleGroup> groups;  ///< by |q_i / rho_i|
};

/// d.d N^2 times one end's part of q.
mpq_class EndPart(const RationalArc& arc, const RationalVector& d,
                  const RationalVector& x, const RationalVector& y) {
  const RationalVector turned = Cross(arc.normal, d);
  mpq_class part = Dot(x, d) * Dot(turned, y) + Dot(x, turned) * Dot(d, y);
  part /= Dot(d, d);
  return part;
}

}  // namespace

RationalVector RationalVectorOf(const Vec3<Exact>& v) {
  return {RationalOf(v.x), RationalOf(v.y), RationalOf(v.z)};
}

RationalArc::RationalArc(const MovingArc& arc)
    : normal(RationalVectorOf(arc.normal)),
      line(RationalVectorOf(arc.line)),
      first(RationalVectorOf(arc.first)),
      last(RationalVectorOf(arc.last)),
      square(Dot(normal, normal)),
      across(Determinant(first, last, normal)),
      along(Dot(first, last)),
      outward(arc.outward ? 1 : -1) {}

void ExactForm::AddMoment(std::size_t index, const mpq_class& weight,
                          const RationalVector& x, const RationalVector& y) {
  if (weight == 0) return;
  const RationalArc& arc = arcs_[index];
  const mpq_class c =
      (Dot(x, y) - Dot(x, arc.normal) * Dot(y, arc.normal) / arc.square) / 2;
  by_angle_[index] += weight * c;
  const mpq_class ends =
      EndPart(arc, arc.last, x, y) - EndPart(arc, arc.first, x, y);
  rational_ -= weight * ends / (4 * arc.square);
}

bool ExactForm::AnglesCancel() const {
  std::vector<SquareClass> classes;
  for (std::size_t i = 0; i < arcs_.size(); ++i) {
    if (by_angle_[i] == 0) continue;
    const RationalArc& arc = arcs_[i];
    SquareClass* own = nullptr;
    mpq_class rho = 1;
    for (SquareClass& c : classes) {
      const mpq_class ratio = arc.square / c.square;
      if (const auto root = RootOf(ratio)) {
        own = &c;
        rho = *root;
        break;
      }
    }
    if (own == nullptr)
      own = &classes.emplace_back(SquareClass{arc.square, {}});
    const mpq_class coefficient = by_angle_[i] / rho;
    AngleGroup& group = own->groups[abs(coefficient)];
    // beta = the argument of d1.d2 + t / (rho R) sqrt(-R).
    RootNumber z{arc.along, arc.across / (rho * own->square)};
    const double sign = coefficient > 0 ? 1 : -1;
    if (sign < 0) z.imaginary = -z.imaginary;
    group.product = Product(group.product, z, own->square);
    const double angle =
        std::atan2(mpq_class(arc.across / (rho * own->square)).get_d() *
                       std::sqrt(own->square.get_d()),
                   arc.along.get_d());
    group.turns += sign * angle / std::numbers::pi;
  }
  for (const SquareClass& c : classes) {
    mpq_class sum = 0;
    for (const auto& [coefficient, group] : c.groups) {
      if (group.product.imaginary != 0) return false;
      sum += coefficient * mpq_class(std::round(group.turns));
    }
    if (sum != 0) return false;
  }
  return true;
}

bool ExactForm::IsZero() const {
  return rational_ == 0 && AnglesCancel();
}

}  // namespace truelux
