// SPDX-License-Identifier: GPL-3.0-or-later
// What contours cost and how far they are from the truth, beside marching
// squares on a grid of certified values that costs as many evaluations.

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <fmt/format.h>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "truelux/derivatives.h"
#include "truelux/io.h"
#include "truelux/irradiance.h"
#include "truelux/isolux.h"

#include "support/portable_random.h"

namespace truelux {
namespace {

using testing::PortableRandom;

/// A floor to be measured.
struct Floor {
  std::string name;
  Scene scene;
  /// Its extent along right and up, from the corner.
  Point3 corner;
  double width = 0;
  double height = 0;
};

/// A room with boxes on and above its floor, a hundred faces in all.
Scene MakeRoom() {
  PortableRandom random(17);
  SceneBuilder builder("room of 100 faces");
  builder.SetGroup("floor");
  builder.AddFace({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}});
  builder.SetGroup("room");
  builder.AddFace({{0, 0, 0}, {0, 0, 4}, {10, 0, 4}, {10, 0, 0}});
  builder.AddFace({{10, 0, 0}, {10, 0, 4}, {10, 10, 4}, {10, 10, 0}});
  builder.AddFace({{10, 10, 0}, {10, 10, 4}, {0, 10, 4}, {0, 10, 0}});
  builder.AddFace({{0, 10, 0}, {0, 10, 4}, {0, 0, 4}, {0, 0, 0}});
  for (int i = 0; i < 4; ++i) {
    const double x = i % 2 == 0 ? 2 : 7;
    const double y = i / 2 == 0 ? 2 : 7;
    builder.AddFace(
        {{x, y, 3.9}, {x, y + 1, 3.9}, {x + 1, y + 1, 3.9}, {x + 1, y, 3.9}},
        {1, 1, 1});
  }
  for (int i = 0; i < 15; ++i) {
    // Turned boxes; every third one hangs.
    const double turn = random.Uniform(0, 1.5);
    const double x = random.Uniform(1, 9);
    const double y = random.Uniform(1, 9);
    const double z = i % 3 == 2 ? random.Uniform(0.5, 2) : 0;
    const double h = random.Uniform(0.3, 1.2);
    const double a = random.Uniform(0.15, 0.5);
    std::array<std::array<double, 2>, 4> c;
    for (std::size_t k = 0; k < 4; ++k) {
      const double angle = turn + 1.5707963 * static_cast<double>(k);
      c[k] = {x + a * std::cos(angle), y + a * std::sin(angle)};
    }
    const auto at = [&](std::size_t k, double height) {
      return Point3{c[k % 4][0], c[k % 4][1], height};
    };
    builder.AddFace({at(0, z + h), at(1, z + h), at(2, z + h), at(3, z + h)});
    for (std::size_t k = 0; k < 4; ++k) {
      builder.AddFace({at(k, z), at(k + 1, z), at(k + 1, z + h), at(k, z + h)});
    }
    if (z > 0) builder.AddFace({at(3, z), at(2, z), at(1, z), at(0, z)});
  }
  return *builder.Build().value;
}

Scene Example(const char* name) {
  auto result = ReadScene(std::string(TRUELUX_EXAMPLES "/scenes/") + name);
  if (!result.ok()) throw std::invalid_argument(result.diagnostics[0].Text());
  return *result.value;
}

/// Distances, sorted.
struct Distances {
  std::vector<double> sorted;

  explicit Distances(std::vector<double> all) : sorted(std::move(all)) {
    std::ranges::sort(sorted);
  }

  [[nodiscard]] double At(double share) const {
    if (sorted.empty()) return 0;
    const auto last = static_cast<double>(sorted.size() - 1);
    return sorted[static_cast<std::size_t>(share * last)];
  }
};

class Measurer {
 public:
  Measurer(const Floor& floor, const Oracle& oracle, const Isolux& isolux)
      : floor_(floor), oracle_(oracle), isolux_(isolux) {
    const Vector3& r = isolux.right;
    const Vector3& u = isolux.up;
    normal_ = {r.y * u.z - r.z * u.y, r.z * u.x - r.x * u.z,
               r.x * u.y - r.y * u.x};
  }

  /// How far a point is from where E is the level, along the gradient; at most
  /// a hundredth of the size.
  [[nodiscard]] double DistanceAt(const Point3& from, double level) const {
    const double most = 0.01 * isolux_.size;
    Point3 p = from;
    for (int i = 0; i < 6; ++i) {
      const Derivatives d = oracle_.Derivatives(
          Receiver{p, normal_, 1}, {.sphere = false, .jacobian = false});
      const Vector3& g = d.channels[0].tangential;
      const double square = g.x * g.x + g.y * g.y + g.z * g.z;
      if (!(square > 0)) return most;
      const double step = (level - d.irradiance.value[0]) / square;
      p = {p.x + step * g.x, p.y + step * g.y, p.z + step * g.z};
      const double moved = std::hypot(p.x - from.x, p.y - from.y, p.z - from.z);
      if (!(moved < most)) return most;
      if (std::fabs(step) * std::sqrt(square) < 1e-12 * isolux_.size)
        return moved;
    }
    return std::hypot(p.x - from.x, p.y - from.y, p.z - from.z);
  }

  /// Of the middles of all chords, or of some of them.
  [[nodiscard]] Distances OfContours() const {
    std::vector<double> all;
    std::size_t seen = 0;
    for (const IsoluxContour& contour : isolux_.contours) {
      for (std::size_t i = 0; i < contour.widths.size(); ++i) {
        if (seen++ % stride_ != 0) continue;
        const Point3& a = contour.vertices[i].at;
        const Point3& b =
            contour.vertices[(i + 1) % contour.vertices.size()].at;
        // The contour goes from one end to the other.
        const double half = std::hypot(b.x - a.x, b.y - a.y, b.z - a.z) / 2;
        const Point3 middle = {(a.x + b.x) / 2, (a.y + b.y) / 2,
                               (a.z + b.z) / 2};
        all.push_back(std::min(half, DistanceAt(middle, contour.level)));
      }
    }
    return Distances(std::move(all));
  }

  /// Of marching squares with so many certified values.
  [[nodiscard]] Distances OfMarchingSquares(double evaluations) const {
    const auto columns =
        static_cast<int>(std::sqrt(evaluations * floor_.width / floor_.height));
    const auto rows = static_cast<int>(evaluations / columns);
    const auto at = [&](double x, double y) {
      const Vector3& r = isolux_.right;
      const Vector3& u = isolux_.up;
      const double a = floor_.width * x / (columns - 1);
      const double b = floor_.height * y / (rows - 1);
      return Point3{floor_.corner.x + a * r.x + b * u.x,
                    floor_.corner.y + a * r.y + b * u.y,
                    floor_.corner.z + a * r.z + b * u.z};
    };
    std::vector<double> values;
    for (int y = 0; y < rows; ++y) {
      std::vector<Receiver> row;
      for (int x = 0; x < columns; ++x)
        row.push_back({at(x, y), normal_, 1});
      for (const Irradiance& e : oracle_.Evaluate(row))
        values.push_back(e.value[0]);
    }
    const auto value = [&](int x, int y) {
      return values[static_cast<std::size_t>(y) *
                        static_cast<std::size_t>(columns) +
                    static_cast<std::size_t>(x)];
    };
    std::vector<double> all;
    std::size_t seen = 0;
    for (int y = 0; y + 1 < rows; ++y) {
      for (int x = 0; x + 1 < columns; ++x) {
        for (const double level : isolux_.levels)
          AddSquare(x, y, value, at, level, seen, all);
      }
    }
    return Distances(std::move(all));
  }

  /// Takes every n-th chord only, so that some thousands are left.
  void Thin(std::size_t chords) {
    stride_ = std::max<std::size_t>(1, chords / 4000);
  }

 private:
  /// The middle of the chord through a square whose outline crosses twice.
  template <class Value, class At>
  void AddSquare(int x, int y, const Value& value, const At& at, double level,
                 std::size_t& seen, std::vector<double>& all) const {
    const std::array<std::array<int, 2>, 4> corners = {
        {{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}};
    std::vector<std::array<double, 2>> hits;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto& [ax, ay] = corners[k];
      const auto& [bx, by] = corners[(k + 1) % 4];
      const double ea = value(ax, ay);
      const double eb = value(bx, by);
      if ((ea < level) == (eb < level)) continue;
      const double share = (level - ea) / (eb - ea);
      hits.push_back({ax + share * (bx - ax), ay + share * (by - ay)});
    }
    if (hits.size() != 2 || seen++ % 16 != 0) return;
    all.push_back(DistanceAt(
        at((hits[0][0] + hits[1][0]) / 2, (hits[0][1] + hits[1][1]) / 2),
        level));
  }

  const Floor& floor_;
  const Oracle& oracle_;
  const Isolux& isolux_;
  Vector3 normal_;
  std::size_t stride_ = 1;
};

void Measure(const Floor& floor) {
  const Oracle oracle(floor.scene);
  IsoluxOptions options;
  options.channel = ScalarChannel::kRed;
  options.threads = 1;
  const auto begin = std::chrono::steady_clock::now();
  const Isolux isolux = IsoluxOf(oracle, "floor", options);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin)
          .count();
  std::size_t vertices = 0;
  std::size_t certified = 0;
  std::size_t chords = 0;
  std::size_t unknown = 0;
  for (const IsoluxContour& contour : isolux.contours) {
    vertices += contour.vertices.size();
    chords += contour.widths.size();
    for (const IsoluxVertex& v : contour.vertices)
      certified += v.is_certified && v.half_width <= 1e-9 * isolux.size ? 1 : 0;
    unknown += static_cast<std::size_t>(std::ranges::count_if(
        contour.widths, [](double width) { return !std::isfinite(width); }));
  }
  fmt::print(
      "| {} | {} | {} | {} | {:.2f} | {} of {} | {:.1g} | {} | {:.1f} |\n",
      floor.name, isolux.contours.size(), vertices, vertices - certified,
      static_cast<double>(isolux.line_evaluations) /
          static_cast<double>(vertices),
      unknown, chords, isolux.open_area / isolux.area,
      isolux.search_evaluations, seconds);
  Measurer measurer(floor, oracle, isolux);
  measurer.Thin(chords);
  const Distances ours = measurer.OfContours();
  const double evaluations =
      static_cast<double>(isolux.line_evaluations + isolux.search_evaluations);
  const Distances grid = measurer.OfMarchingSquares(evaluations);
  const auto row = [&](const char* name, const Distances& d) {
    fmt::print("|   {} | {:.1e} | {:.1e} | {:.1e} |\n", name,
               d.At(0.5) / isolux.size, d.At(0.99) / isolux.size,
               d.At(1) / isolux.size);
  };
  row("contours", ours);
  row("marching squares", grid);
  std::fflush(stdout);
}

}  // namespace
}  // namespace truelux

int main() {
  using namespace truelux;  // NOLINT(google-build-using-namespace)
  fmt::print(
      "| scene | contours | vertices | not certified | evaluations a vertex | "
      "chords of unknown width | open share | evaluations of the search | s "
      "|\n");
  Measure({"cornell", Example("cornell_box.obj"), {550, 0, 0}, 550, 559});
  Measure({"room of 100", MakeRoom(), {0, 0, 0}, 10, 10});
  Measure({"figure7_c", Example("figure7_c.obj"), {-6, -6, 0}, 12, 12});
  Measure({"figure7_a", Example("figure7_a.obj"), {-5.5, -5.5, 0}, 11, 11});
  return 0;
}
