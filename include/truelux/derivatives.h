// SPDX-License-Identifier: GPL-3.0-or-later
// Derivatives of irradiance: by the receiver's place, by its normal, and by the
// vertices of the scene.
//
// Source: Arvo, The Irradiance Jacobian for Partially Occluded Polyhedral
// Sources, 1994; docs/derivatives.md has the formulas as they are used.

#ifndef TRUELUX_DERIVATIVES_H_
#define TRUELUX_DERIVATIVES_H_

#include <array>
#include <string_view>
#include <vector>

#include "truelux/export.h"
#include "truelux/geometry.h"
#include "truelux/irradiance.h"

namespace truelux {

/// Rows of a matrix; entry [p][k].
using Matrix3 = std::array<std::array<double, 3>, 3>;

/// How E depends on the place of a receiver, near it.
enum class Smoothness {
  kC1,             ///< "C1": E has a gradient, which is continuous
  kKink,           ///< "kink": one-sided derivatives differ
  kDiscontinuous,  ///< "discontinuous": the receiver lies on a face that
                   ///< on_face does not name; there are no derivatives
};

/// The word in quotes above.
[[nodiscard]] TRUELUX_EXPORT std::string_view Name(Smoothness smoothness);

/// What one channel's irradiance does when the receiver moves or turns. Where
/// there is a kink, derivatives by r are the means of the limits on all sides.
struct ChannelDerivatives {
  Vector3 gradient;    ///< dE/dr with the normal fixed [W/m^3]
  Vector3 tangential;  ///< its part in the plane of the face that the
                       ///< receiver lies on, else across n [W/m^3]
  Vector3 normal;      ///< dE/dn per radian, across n [W/m^2]
  Vector3 vector;      ///< V over the hemisphere, E = n.V / |n| [W/m^2]
  Matrix3 jacobian{};  ///< [p][k]: dV_p/dr_k [W/m^3]
  Vector3 sphere;      ///< V over the whole sphere, the light field vector
                       ///< [W/m^2]
  double flux = 0;     ///< net flux n.V / |n| of that [W/m^2]
  Matrix3 sphere_jacobian{};  ///< of V over the whole sphere [W/m^3]
};

/// A plane through the receiver across which the gradient jumps: beside the
/// other kinks E'(r; d) = gradient.d + b |m.d|.
struct Kink {
  Vector3 normal;  ///< m, of length 1; its first component that is not 0 is
                   ///< positive; each component within half an ulp
  Rgb size{};      ///< b [W/m^3], the nearest binary64
  /// The numbers of the faces that lie in the plane, seen edge-on; else two
  /// edges cover each other there.
  std::vector<int> faces;
  /// Then: the edges, by indices into Scene::vertices(); -1: a line where two
  /// faces pierce each other.
  std::array<std::array<int, 2>, 2> edges{{{-1, -1}, {-1, -1}}};
};

/// Irradiance and its derivatives at one receiver.
struct Derivatives {
  Irradiance irradiance;  ///< E, with the bits of Oracle::Evaluate
  Smoothness smoothness = Smoothness::kC1;
  /// With Method::kCertified each number is the binary64 nearest to the true
  /// value, zeros exactly; with kDouble it is summed in double (at kinks, and
  /// where double cannot bound it, certified all the same). Without meaning if E
  /// is discontinuous.
  std::array<ChannelDerivatives, 3> channels;
  /// Bounds on the errors, in the same places.
  std::array<ChannelDerivatives, 3> bounds;
  std::vector<Kink> kinks;  ///< of E; none unless smoothness is kKink
  /// Numbers given as 0 with a bound, since 4096 bits left them open.
  int undecided = 0;
};

/// How E of one channel changes with one coordinate of a vertex: on the left,
/// where the coordinate becomes less, and on the right.
struct VertexSlope {
  double left = 0;   ///< [W/m^3], the nearest binary64; 0 if E jumps there
  double right = 0;  ///< likewise
  bool left_jumps = false;   ///< E itself jumps when the coordinate decreases
  bool right_jumps = false;  ///< E itself jumps when the coordinate increases
  double bound = 0;          ///< on the errors of both

  /// Whether there is a derivative, left = right.
  [[nodiscard]] bool IsSmooth() const {
    return !left_jumps && !right_jumps && left == right;
  }
};

/// dE/dv of one vertex.
struct VertexDerivative {
  /// The vertex by its number in the input (Scene::corner_numbers()): all faces
  /// that use it move.
  int number = 0;
  std::array<std::array<VertexSlope, 3>, 3> slopes{};  ///< [channel][axis]
};

/// dE/dv of all vertices that matter, at one receiver.
struct VertexDerivatives {
  Irradiance irradiance;  ///< E, with the bits of Oracle::Evaluate
  Smoothness smoothness = Smoothness::kC1;  ///< kDiscontinuous: no derivatives
  /// By ascending numbers; a vertex that is not here has the derivative 0.
  std::vector<VertexDerivative> vertices;
  int undecided = 0;  ///< as in Derivatives
};

/// The product that optimisation needs: the sum over receivers and channels of
/// weight times dE/dv, for every vertex that a face uses. Adding in one order
/// gives the same bits, however the derivatives were found.
class TRUELUX_EXPORT VertexGradient {
 public:
  /// 0 for every vertex of a scene.
  explicit VertexGradient(const Scene& scene);

  /// Adds the derivatives of one receiver, in the scene, times the weights of
  /// its channels. A one-sided derivative counts with the mean of both sides,
  /// a side on which E jumps with 0.
  void Add(const VertexDerivatives& derivatives, const Rgb& weights);

  /// The vertices by their numbers in the input, ascending.
  [[nodiscard]] const std::vector<int>& numbers() const { return numbers_; }

  /// The sums, in the order of numbers() [weight W/m^3]; each is off by a few
  /// ulps of the largest partial sum.
  [[nodiscard]] const std::vector<Vector3>& values() const { return values_; }

  /// How many slopes were one-sided, or jumped.
  [[nodiscard]] int one_sided() const { return one_sided_; }

 private:
  std::vector<int> numbers_;
  std::vector<Vector3> values_;
  int one_sided_ = 0;
};

/// What is wanted besides the gradient and V over the hemisphere.
struct DerivativeOptions {
  bool sphere = true;    ///< the light field vector, its Jacobian, the net flux
  bool jacobian = true;  ///< Jacobians
};

}  // namespace truelux

#endif  // TRUELUX_DERIVATIVES_H_
