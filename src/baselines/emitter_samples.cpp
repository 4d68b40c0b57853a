// SPDX-License-Identifier: GPL-3.0-or-later
#include "baselines/emitter_samples.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <random>
#include <stdexcept>

#include "exact/vec3.h"

namespace truelux {
namespace {

using Vec = Vec3<double>;

Vec ToVec(const Point3& p) {
  return {p.x, p.y, p.z};
}

double Length(const Vec& a) {
  return std::sqrt(Dot(a, a));
}

std::array<float, 3> ToFloat(const Vec& a) {
  return {static_cast<float>(a.x), static_cast<float>(a.y),
          static_cast<float>(a.z)};
}

/// Sobol's first two dimensions, as 32-bit fractions: van der Corput's
/// sequence, and direction numbers v(k + 1) = v(k) xor v(k) / 2.
std::array<std::uint32_t, 2> SobolPoint(std::uint32_t index) {
  constexpr std::uint32_t kHalf = std::uint32_t{1} << 31;
  std::array<std::uint32_t, 2> point{};
  std::array<std::uint32_t, 2> direction = {kHalf, kHalf};
  for (; index != 0; index >>= 1) {
    if ((index & 1) != 0) {
      point[0] ^= direction[0];
      point[1] ^= direction[1];
    }
    direction[0] >>= 1;
    direction[1] ^= direction[1] >> 1;
  }
  return point;
}

double UnitNumber(std::mt19937_64& engine) {
  return static_cast<double>(engine() >> 11) * 0x1p-53;
}

/// The image of the unit square, area for area.
struct MappedPiece {
  Vec corner;
  Vec side_u;
  Vec side_v;
  bool is_triangle = false;
  Rgb exitance{};

  [[nodiscard]] double Area() const {
    return Length(Cross(side_u, side_v)) / (is_triangle ? 2 : 1);
  }

  [[nodiscard]] Vec Normal() const {
    const Vec n = Cross(side_u, side_v);
    return 1 / Length(n) * n;
  }

  [[nodiscard]] Vec At(double u, double v) const {
    if (!is_triangle) {
      return {corner.x + u * side_u.x + v * side_v.x,
              corner.y + u * side_u.y + v * side_v.y,
              corner.z + u * side_u.z + v * side_v.z};
    }
    const double root = std::sqrt(u);
    const Vec on_edge = (1 - v) * side_u;
    const Vec on_other = v * side_v;
    return {corner.x + root * (on_edge.x + on_other.x),
            corner.y + root * (on_edge.y + on_other.y),
            corner.z + root * (on_edge.z + on_other.z)};
  }
};

MappedPiece TrianglePiece(const Scene& scene, const Triangle& triangle) {
  const auto corner = [&](std::size_t k) {
    return ToVec(
        scene.vertices()[static_cast<std::size_t>(triangle.vertices[k])]);
  };
  return {corner(0), corner(1) - corner(0), corner(2) - corner(0), true, {}};
}

/// The parallelogram that two triangles make, up to rounding.
std::optional<MappedPiece> ParallelogramPiece(const Scene& scene,
                                              const Triangle& first,
                                              const Triangle& second) {
  for (std::size_t k = 0; k < 3; ++k) {
    const int apex = first.vertices[k];
    const auto is_apex = [apex](int v) { return v == apex; };
    if (std::ranges::any_of(second.vertices, is_apex)) continue;
    // The edge opposite to the apex is the diagonal.
    const auto at = [&](int vertex) {
      return ToVec(scene.vertices()[static_cast<std::size_t>(vertex)]);
    };
    const Vec a = at(apex);
    const Vec side_u = at(first.vertices[(k + 1) % 3]) - a;
    const Vec side_v = at(first.vertices[(k + 2) % 3]) - a;
    for (const int opposite : second.vertices) {
      const Vec gap = at(opposite) - a - side_u - side_v;
      if (Length(gap) <= 1e-12 * (Length(side_u) + Length(side_v)))
        return MappedPiece{a, side_u, side_v, false, {}};
    }
  }
  return std::nullopt;
}

std::vector<MappedPiece> PiecesOf(const Scene& scene) {
  std::vector<MappedPiece> pieces;
  for (const Facet& facet : scene.facets()) {
    const Face& face = scene.faces()[static_cast<std::size_t>(facet.face)];
    if (face.emission == Rgb{}) continue;
    const auto triangles = scene.triangles().subspan(
        static_cast<std::size_t>(facet.first_triangle),
        static_cast<std::size_t>(facet.triangle_count));
    const std::size_t first_of_facet = pieces.size();
    if (triangles.size() == 2) {
      if (const auto whole =
              ParallelogramPiece(scene, triangles[0], triangles[1]))
        pieces.push_back(*whole);
    }
    if (pieces.size() == first_of_facet) {
      for (const Triangle& triangle : triangles)
        pieces.push_back(TrianglePiece(scene, triangle));
    }
    for (std::size_t i = first_of_facet; i < pieces.size(); ++i)
      pieces[i].exitance = face.emission;
  }
  return pieces;
}

}  // namespace

std::vector<SquarePoint> SquareSamples(SamplePattern pattern, int count,
                                       std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  std::vector<SquarePoint> points;
  if (pattern == SamplePattern::kSobol) {
    const auto shift_u = static_cast<std::uint32_t>(engine() >> 32);
    const auto shift_v = static_cast<std::uint32_t>(engine() >> 32);
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(count); ++i) {
      const auto point = SobolPoint(i);
      points.push_back({((point[0] ^ shift_u) + 0.5) * 0x1p-32,
                        ((point[1] ^ shift_v) + 0.5) * 0x1p-32});
    }
    return points;
  }
  if (pattern == SamplePattern::kRandom) {
    for (int i = 0; i < count; ++i) {
      const double u = UnitNumber(engine);
      points.push_back({u, UnitNumber(engine)});
    }
    return points;
  }
  const auto side = static_cast<int>(std::lround(std::sqrt(count)));
  if (side * side != count)
    throw std::invalid_argument("the number of samples is no square");
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const double u = (column + UnitNumber(engine)) / side;
      points.push_back({u, (row + UnitNumber(engine)) / side});
    }
  }
  return points;
}

EmitterSamples SampleEmitters(const Scene& scene, SamplePattern pattern,
                              int count, std::uint64_t seed) {
  EmitterSamples samples{pattern, 0, {}, {}};
  const std::vector<MappedPiece> pieces = PiecesOf(scene);
  std::vector<double> area_up_to;
  for (const MappedPiece& piece : pieces) {
    samples.area += piece.Area();
    area_up_to.push_back(samples.area);
    samples.pieces.push_back({ToFloat(piece.Normal()), piece.exitance});
  }
  if (pieces.empty()) return samples;
  for (const SquarePoint& point : SquareSamples(pattern, count, seed)) {
    const double at = point[0] * samples.area;
    const auto found =
        std::upper_bound(area_up_to.begin(), area_up_to.end() - 1, at);
    const auto chosen = static_cast<std::size_t>(found - area_up_to.begin());
    const double before = chosen == 0 ? 0 : area_up_to[chosen - 1];
    const double u = std::min((at - before) / pieces[chosen].Area(), 1.0);
    samples.points.push_back(
        {ToFloat(pieces[chosen].At(u, point[1])), static_cast<int>(chosen)});
  }
  return samples;
}

}  // namespace truelux
