// SPDX-License-Identifier: GPL-3.0-or-later
// The oracle: scene + receiver -> irradiance.

#ifndef TRUELUX_IRRADIANCE_H_
#define TRUELUX_IRRADIANCE_H_

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "truelux/export.h"
#include "truelux/form_factors.h"
#include "truelux/formulas.h"
#include "truelux/geometry.h"
#include "truelux/prepared_scene.h"
#include "truelux/receiver.h"
#include "truelux/scene.h"
#include "truelux/statistics.h"
#include "truelux/stop.h"
#include "truelux/visibility.h"

namespace truelux {

/// How it is decided what a receiver sees. Every engine decides exactly, and
/// all give the same irradiance, bit for bit (docs/method.md).
enum class Engine {
  /// "contour": walks along edges. The one to use.
  kContour,
  /// "arrangement": builds the whole view as an exact planar map. Slow; it
  /// shares no line of visibility with kContour and serves to check it.
  kArrangement,
  /// "angular-spans": sums over the vertices of the same map by what is seen
  /// around each of them, as vertex tracing does (Stark and Riesenfeld, Exact
  /// Illumination in Polygonal Environments using Vertex Tracing, 2000,
  /// equation (9)), without a contour. Slow.
  kAngularSpans,
};

/// The word in quotes above, as --engine takes it.
[[nodiscard]] TRUELUX_EXPORT std::string_view Name(Engine engine);

/// How what is visible is summed.
enum class Method {
  /// "certified": the binary64 nearest to the true value, ties to even.
  kCertified,
  /// "double": the same exact visibility, summed in double, with a proven
  /// bound on the error. With kAngularSpans the certified value and its bound.
  kDouble,
};

/// The word in quotes above, as --method takes it.
[[nodiscard]] TRUELUX_EXPORT std::string_view Name(Method method);

/// How a scene's emission (Ke) is read.
enum class Emission {
  kExitance,  ///< "exitance": as radiant exitance M [W/m^2]
  kRadiance,  ///< "radiance": as radiance L [W/m^2/sr]; M = pi L
};

/// The word in quotes above, as --emission takes it.
[[nodiscard]] TRUELUX_EXPORT std::string_view Name(Emission emission);

/// How an oracle answers.
struct OracleOptions {
  Engine engine = Engine::kContour;
  Method method = Method::kCertified;
  Emission emission = Emission::kExitance;
  /// What kDouble sums. The values of kCertified do not depend on it:
  /// kHomogeneous and kUnified sum over vertices there, all others over arcs,
  /// and both give the same bits. kAngularSpans always sums over vertices.
  Formula formula = Formula::kAuto;
  /// kImagePlane and kDirections cut what is visible to the square of this
  /// half-side on the image plane (at distance 1 from the receiver), > 0. The
  /// bound holds what is cut off, at most M / (1 + half_side^2) (Stark 2000,
  /// Lemma 1).
  double half_side = 0x1p20;
  /// Looked at before every receiver and every source; if it is set, every
  /// method that takes receivers throws Stopped.
  const StopFlag* stop = nullptr;
};

/// Irradiance at a receiver, with how it was found.
struct Irradiance {
  /// E [W/m^2], >= 0; +inf if too large for binary64. NaN, with an infinite
  /// bound, where a formula by name does not apply (kDouble only).
  Rgb value{};
  /// Bound on |value - E|, per channel [W/m^2]. kCertified: half the distance
  /// of value to its farther neighbour. kDouble: a proven bound, rounded up.
  Rgb bound{};
  Statistics statistics;  ///< what it cost
};

struct Derivatives;
struct DerivativeOptions;
struct VertexDerivatives;

/// Answers for one scene. Const methods may be called from several threads;
/// copies share what was prepared.
///
/// Face numbers count from 1, as f lines do; indices count from 0. Every method
/// that takes receivers throws ReceiverError for one that cannot be used; it
/// checks all receivers before it finds anything.
class TRUELUX_EXPORT Oracle {
 public:
  /// Prepares the scene, and answers as `options` say. Throws
  /// std::invalid_argument if half_side is not positive.
  explicit Oracle(Scene scene, const OracleOptions& options = {});

  /// The same over a scene that is prepared already; costs nothing.
  explicit Oracle(PreparedScene prepared, const OracleOptions& options = {});

  /// The scene that was given.
  [[nodiscard]] const Scene& scene() const { return prepared_.scene(); }

  /// The scene as it was prepared, for another oracle over it.
  [[nodiscard]] const PreparedScene& prepared() const { return prepared_; }

  /// The options that were given.
  [[nodiscard]] const OracleOptions& options() const { return options_; }

  /// E = (1/pi) * integral over the directions d with n.d > 0 of
  /// M(first face hit along d) cos(n, d), with n the receiver's normal. The
  /// result does not depend on the engine or on the thread.
  [[nodiscard]] Irradiance Evaluate(const Receiver& receiver) const;

  /// The same for many receivers, in their order: entry i has the value and
  /// bound of Evaluate(receivers[i]). Cheaper where consecutive receivers are
  /// near each other, as in grids and images, since they share where their
  /// blockers can be; the statistics may then count fewer predicates. If a
  /// receiver cannot be used, what() of the ReceiverError begins with
  /// "receiver i: ", i = index(), counted from 0.
  [[nodiscard]] std::vector<Irradiance> Evaluate(
      std::span<const Receiver> receivers) const;

  /// The same, one result after the other: take(i, result of receivers[i]),
  /// i = 0, 1, 2, ... in the calling thread. An exception that take throws ends
  /// the call and reaches the caller. take is not called if any receiver cannot
  /// be used.
  void Evaluate(
      std::span<const Receiver> receivers,
      const std::function<void(std::size_t, const Irradiance&)>& take) const;

  /// E [W/m^2] by one formula in one arithmetic on the exact visible contour,
  /// to see what they lose: without a bound, rounded to binary64 at the end.
  /// What kImagePlane and kDirections cut off is missing. precision [bit]: of
  /// kMultiprecision. Returns nothing where the formula does not apply (kSeries
  /// and kCubature, on wide sources). Throws std::invalid_argument if the
  /// formula is kAuto or the precision is below 53.
  [[nodiscard]] std::optional<Rgb> EvaluateFormula(const Receiver& receiver,
                                                   Formula formula,
                                                   Arithmetic arithmetic,
                                                   int precision = 128) const;

  /// The form factor [1] of one face, the same in every channel: E with that
  /// face's M = 1 and the others' 0, while all faces block. face: its number,
  /// from 1; the face need not emit. Throws std::invalid_argument if the scene
  /// has no such face.
  [[nodiscard]] Irradiance FormFactor(const Receiver& receiver, int face) const;

  /// The form factors of all emitting faces, with the visibility of all of them
  /// decided together. Each has the value and the bound of FormFactor.
  [[nodiscard]] FormFactorTable FormFactors(const Receiver& receiver) const;

  /// E and its derivatives by the receiver's place and normal
  /// (truelux/derivatives.h). By the contour engine, whatever the options say
  /// of engine and formula.
  [[nodiscard]] truelux::Derivatives Derivatives(
      const Receiver& receiver) const;
  [[nodiscard]] truelux::Derivatives Derivatives(
      const Receiver& receiver, const DerivativeOptions& options) const;

  /// The same for many receivers: take(i, derivatives at receivers[i]), i = 0,
  /// 1, 2, ... in the calling thread, as Evaluate does.
  void Derivatives(
      std::span<const Receiver> receivers, const DerivativeOptions& options,
      const std::function<void(std::size_t, const truelux::Derivatives&)>& take)
      const;

  /// dE/dv of every scene vertex on which E depends at a receiver, one-sided
  /// where the derivative differs with the direction. Certified, whatever the
  /// options say of method.
  [[nodiscard]] truelux::VertexDerivatives VertexDerivatives(
      const Receiver& receiver) const;

  /// The visible contour of every source that is visible from the receiver.
  /// kAngularSpans has no contour of its own and gives that of kArrangement.
  [[nodiscard]] VisibleContour Contour(const Receiver& receiver) const;

 private:
  PreparedScene prepared_;
  OracleOptions options_;
};

}  // namespace truelux

#endif  // TRUELUX_IRRADIANCE_H_
