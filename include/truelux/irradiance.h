// The oracle: scene + receiver -> irradiance.

#ifndef TRUELUX_IRRADIANCE_H_
#define TRUELUX_IRRADIANCE_H_

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "truelux/formulas.h"
#include "truelux/geometry.h"
#include "truelux/receiver.h"
#include "truelux/scene.h"
#include "truelux/statistics.h"
#include "truelux/visibility.h"

namespace truelux {

/// kContour walks the edges; kArrangement builds the whole view as an exact
/// planar map and is slow. They share no line of visibility and agree.
/// kAngularSpans sums over the vertices of the same map by what is seen around
/// each of them, as vertex tracing does, without a contour; it agrees, too.
enum class Engine { kContour, kArrangement, kAngularSpans };

/// kCertified: the binary64 nearest to the true value.
/// kDouble: the same exact visibility, summed in double, with a proven bound
/// (with kAngularSpans the certified value and its bound).
enum class Method { kCertified, kDouble };

/// How a scene's emission (Ke) is read: as radiant exitance M [W/m^2], or as
/// radiance L [W/m^2/sr], M = pi L.
enum class Emission { kExitance, kRadiance };

struct OracleOptions {
  Engine engine = Engine::kContour;
  Method method = Method::kCertified;
  Emission emission = Emission::kExitance;
  /// kCertified does not depend on it: kHomogeneous and kUnified sum over
  /// vertices there, all others over arcs, and both give the same bits.
  /// kAngularSpans always sums over vertices.
  Formula formula = Formula::kAuto;
  /// kImagePlane and kDirections cut what is visible to the square of this
  /// half-side on the image plane (at unit distance), > 0; the bound holds
  /// what is cut off, at most M / (1 + half_side^2) (S, Lemma 1).
  double half_side = 0x1p20;
};

/// Irradiance at a receiver, with how it was found.
struct Irradiance {
  Rgb value{};  ///< E [W/m^2]; +inf if too large for binary64
  /// Bound on |value - E|, per channel [W/m^2]. kCertified: half the distance
  /// of value to its farther neighbour; kDouble: a proven bound, rounded up.
  Rgb bound{};
  Statistics statistics;
};

/// Answers for one scene. Const methods may be called from several threads;
/// copies share what was prepared.
class Oracle {
 public:
  explicit Oracle(Scene scene, const OracleOptions& options = {});

  [[nodiscard]] const Scene& scene() const { return scene_; }

  [[nodiscard]] const OracleOptions& options() const { return options_; }

  /// E(r) = (1/pi) * integral over d with n.d > 0 of M(first face hit along
  /// d) cos(n, d). Requires a finite receiver with a normal that is not zero
  /// and 0 <= on_face <= number of faces (std::invalid_argument otherwise).
  /// The result does not depend on the engine or on the thread.
  [[nodiscard]] Irradiance Evaluate(const Receiver& receiver) const;

  /// The same for many receivers, in their order: entry i has the value and
  /// bound of Evaluate(receivers[i]). Cheaper where consecutive receivers are
  /// near each other, as in grids and images, since they share where their
  /// blockers can be; the statistics may then count fewer predicates.
  [[nodiscard]] std::vector<Irradiance> Evaluate(
      std::span<const Receiver> receivers) const;

  /// The same, one result after the other: take(i, result of receivers[i]).
  /// What take throws ends it.
  void Evaluate(
      std::span<const Receiver> receivers,
      const std::function<void(std::size_t, const Irradiance&)>& take) const;

  /// E [W/m^2] by one formula in one arithmetic on the exact visible contour,
  /// to see what they lose: without a bound, rounded to binary64 at the end.
  /// What kImagePlane and kDirections cut off is missing. precision [bits]: of
  /// kMultiprecision. Nothing where the formula does not apply (kSeries,
  /// kCubature). Requires a receiver as Evaluate does, a formula that is not
  /// kAuto and a precision of at least 53 (std::invalid_argument otherwise).
  [[nodiscard]] std::optional<Rgb> EvaluateFormula(const Receiver& receiver,
                                                   Formula formula,
                                                   Arithmetic arithmetic,
                                                   int precision = 128) const;

  /// The form factor of one face [1]: E with that face's M = 1 and the
  /// others' 0, all faces blocking as ever. face: its number, from 1.
  [[nodiscard]] Irradiance FormFactor(const Receiver& receiver, int face) const;

  /// The visible contour of every source that is visible from the receiver.
  /// kAngularSpans has none: it is that of kArrangement then.
  [[nodiscard]] VisibleContour Contour(const Receiver& receiver) const;

 private:
  Scene scene_;
  OracleOptions options_;
  struct Prepared;
  std::shared_ptr<Prepared> prepared_;
};

}  // namespace truelux

#endif  // TRUELUX_IRRADIANCE_H_
