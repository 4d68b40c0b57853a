// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/derivatives/coincident_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/stamped_table.h"
#include "exact/recipe_evaluator.h"
#include "exact/view_geometry.h"
#include "scene/scene_access.h"

namespace truelux {
namespace {

/// A line of the scene with its plane through r.
struct SeenLine {
  PlaneRecipe plane;
  std::size_t number = 0;  ///< in the order in which lines were found
  double key = 0;          ///< |N^ . g|, g some vector: equal for equal planes
  double error = 0;        ///< bound on the error of the key, and of N^
  Vec3<double> unit;
};

/// No plane of a scene made by hand or by a program is perpendicular to it.
constexpr Vec3<double> kGeneric = {0.48210193271, 0.71923714312, 0.50021931377};

Vec3<double> VectorOf(const Point3& from, const Point3& to) {
  return {to.x - from.x, to.y - from.y, to.z - from.z};
}

double LengthOf(const Vec3<double>& v) {
  return std::sqrt(Dot(v, v));
}

}  // namespace

class SeenLineFinder::Impl {
 public:
  explicit Impl(const ContourEngine& engine)
      : engine_(engine),
        view_{VerticesOf(engine.scene()), TrianglesOf(engine.scene()), {}, {}},
        exact_(view_),
        geometry_(view_, engine.triangle_normals()),
        ignored_(engine.scene()),
        is_known_piece_(engine.pieces().pieces().size()),
        is_known_edge_(engine.pieces().corners().size()) {}

  const SeenLines& Find(const ContourQuery& query, bool with_level) {
    with_level_ = with_level;
    view_ = ViewOf(query);
    exact_ = RecipeEvaluator<Exact>(view_);
    ignored_.SetOnFace(FaceNumber(query.receiver.on_face));
    is_known_piece_.Clear();
    is_known_edge_.Clear();
    lines_.clear();
    found_.pieces.clear();
    found_.sources.clear();
    found_.edge_on.clear();
    found_.pairs.clear();
    {
      const RoundUpward rounding;
      geometry_.SetReceiver(view_.position, view_.normal);
      CollectPieces();
      CollectEdges();
      AddCuts();
    }
    if (!found_.pieces.empty()) AddPairs();
    return found_;
  }

 private:
  /// All pieces on the way to any source, its own included.
  void CollectPieces() {
    const Point3& r = view_.position;
    const auto take = [this](int index) {
      const PieceId piece(index);
      if (is_known_piece_.Contains(piece)) return;
      is_known_piece_.Insert(piece);
      if (!ignored_.IsIgnored(engine_.pieces().pieces()[piece].facet))
        found_.pieces.push_back(piece);
    };
    for (const ContourEngine::Emitter& emitter : engine_.emitters()) {
      if (ignored_.IsIgnored(emitter.facet)) continue;
      const PieceId first = engine_.pieces().FirstPieceOf(emitter.facet);
      const TriangleId triangle = engine_.pieces().pieces()[first].triangle;
      const Sign side = geometry_.ReceiverSide(triangle);
      if (side == Sign::kPositive) continue;
      if (side == Sign::kNegative) found_.sources.push_back(emitter.facet);
      engine_.tree().Visit(Shaft(emitter.shafts, Box::Of(r)), take);
    }
  }

  void CollectEdges() {
    const ConvexPieces& pieces = engine_.pieces();
    for (const PieceId id : found_.pieces) {
      const Piece& piece = pieces.pieces()[id];
      if (geometry_.ReceiverSide(piece.triangle) == Sign::kZero)
        found_.edge_on.push_back(id);
      for (const EdgeId edge : piece.edges()) {
        if (is_known_edge_.Contains(edge)) continue;
        EdgeId same = edge;
        do {
          is_known_edge_.Insert(same);
          same = pieces.NextSameEdge(same);
        } while (same != edge);
        AddEdge(pieces.corners()[edge],
                pieces.corners()[pieces.NextCorner(edge)]);
      }
    }
  }

  /// Whether a vertex is in the receiver plane, as is plain where the normal is
  /// along an axis; false: perhaps.
  [[nodiscard]] bool IsPlainlyLevel(VertexId v) const {
    const Point3& p = view_.vertices[v];
    const Point3& r = view_.position;
    const Vector3& n = view_.normal;
    return (n.x == 0 || p.x == r.x) && (n.y == 0 || p.y == r.y) &&
           (n.z == 0 || p.z == r.z);
  }

  void AddEdge(VertexId a, VertexId b) {
    if (!with_level_ && IsPlainlyLevel(a) && IsPlainlyLevel(b)) return;
    const Vec3<double> to_a = VectorOf(view_.position, view_.vertices[a]);
    const Vec3<double> edge = VectorOf(view_.vertices[a], view_.vertices[b]);
    const Vec3<double> normal = Cross(to_a, edge);
    // Differences are off by u each, products and their difference by 3 u more.
    AddLine(PlaneRecipe::OfEdge(a, b), normal,
            8 * 0x1p-52 * LengthOf(to_a) * LengthOf(edge));
  }

  /// error: of the normal.
  void AddLine(const PlaneRecipe& plane, const Vec3<double>& normal,
               double error) {
    const double length = LengthOf(normal);
    SeenLine line{plane, lines_.size(), 0, HUGE_VAL, {}};
    // Written so that a NaN has an infinite error.
    if (length > 4 * error && std::isfinite(length) && length > 0x1p-400) {
      line.unit = (1 / length) * normal;
      line.error = 2 * error / length + 0x1p-48;
      line.key = std::fabs(Dot(line.unit, kGeneric));
    }
    lines_.push_back(line);
  }

  /// The lines where faces go through the plane of a source.
  void AddCuts() {
    const ConvexPieces& pieces = engine_.pieces();
    for (const FacetId source : found_.sources) {
      const TriangleId own = FirstTriangleOf(FacetsOf(engine_.scene())[source]);
      for (const PieceId id : found_.pieces) {
        const Piece& piece = pieces.pieces()[id];
        if (piece.facet == source) continue;
        bool before = false;
        bool behind = false;
        for (const VertexId v : pieces.CornersOf(piece)) {
          const Sign side = geometry_.VertexSide(own, v);
          before = before || side == Sign::kPositive;
          behind = behind || side == Sign::kNegative;
        }
        if (!before || !behind ||
            geometry_.ReceiverSide(piece.triangle) == Sign::kZero) {
          continue;
        }
        const PlaneRecipe cut = PlaneRecipe::OfCut(own, piece.triangle);
        const Vec3<Exact> exact = exact_.Plane(cut, {});
        const Vec3<double> normal = {CGAL::to_double(exact.x),
                                     CGAL::to_double(exact.y),
                                     CGAL::to_double(exact.z)};
        AddLine(cut, normal, 0x1p-51 * LengthOf(normal));
      }
    }
  }

  void AddPairs() {
    if (with_level_) {
      const Vector3& n = view_.normal;
      AddLine(PlaneRecipe::OfHorizon(), {n.x, n.y, n.z},
              0x1p-52 * LengthOf(Vec3<double>{n.x, n.y, n.z}));
    }
    std::ranges::sort(lines_, [](const SeenLine& a, const SeenLine& b) {
      return a.key != b.key ? a.key < b.key : a.number < b.number;
    });
    double widest = 0;
    for (const SeenLine& line : lines_) {
      if (line.error < 1e-6) widest = std::max(widest, line.error);
    }
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      if (lines_[i].error < 1e-6) {
        for (std::size_t j = i + 1; j < lines_.size(); ++j) {
          if (lines_[j].key - lines_[i].key > lines_[i].error + widest) break;
          if (lines_[j].error < 1e-6) Compare(lines_[i], lines_[j]);
        }
      } else {
        for (std::size_t j = 0; j < lines_.size(); ++j) {
          if (j < i ? lines_[j].error < 1e-6 : j > i)
            Compare(lines_[i], lines_[j]);
        }
      }
    }
  }

  void Compare(const SeenLine& a, const SeenLine& b) {
    const Vec3<double> across = Cross(a.unit, b.unit);
    if (LengthOf(across) > a.error + b.error) return;
    const Vec3<Exact> normal = exact_.Plane(a.plane, {});
    const Vec3<Exact> other = exact_.Plane(b.plane, {});
    // A line through r is seen as a point.
    if (IsZero(normal) || IsZero(other) || !AreParallel(normal, other)) return;
    if (!Overlap(a.plane, b.plane, normal)) return;
    found_.pairs.push_back({a.plane, b.plane, normal,
                            AreOneLine(a.plane, normal, b.plane, other)});
  }

  /// The direction L of the line that a plane was made from, N = a x L for its
  /// points a; (0, 0, 0) for the receiver plane.
  [[nodiscard]] Vec3<Exact> DirectionOf(const PlaneRecipe& plane) const {
    if (plane.kind() == PlaneRecipe::Kind::kEdge)
      return exact_.FromVertex(plane.from(), plane.to());
    if (plane.kind() == PlaneRecipe::Kind::kCut) {
      return Cross(exact_.TriangleNormal(plane.first_triangle()),
                   exact_.TriangleNormal(plane.second_triangle()));
    }
    return {Exact(0), Exact(0), Exact(0)};
  }

  /// Whether two planes with the normals n_a and n_b were made from one space
  /// line: L_a = c L_b and N_a = c N_b.
  [[nodiscard]] bool AreOneLine(const PlaneRecipe& a, const Vec3<Exact>& n_a,
                                const PlaneRecipe& b,
                                const Vec3<Exact>& n_b) const {
    const Vec3<Exact> l_a = DirectionOf(a);
    const Vec3<Exact> l_b = DirectionOf(b);
    if (IsZero(l_a) || IsZero(l_b) || !AreParallel(l_a, l_b)) return false;
    // c = L_a.L_b / L_b.L_b, and the same of N.
    return Dot(l_a, l_b) * Dot(n_b, n_b) == Dot(n_a, n_b) * Dot(l_b, l_b);
  }

  /// Whether two edges in one plane overlap as seen from r; other lines count
  /// as endless. normal: of the plane.
  [[nodiscard]] bool Overlap(const PlaneRecipe& a, const PlaneRecipe& b,
                             const Vec3<Exact>& normal) const {
    if (a.kind() != PlaneRecipe::Kind::kEdge ||
        b.kind() != PlaneRecipe::Kind::kEdge) {
      return true;
    }
    std::array<Vec3<Exact>, 2> p = {exact_.FromReceiver(a.from()),
                                    exact_.FromReceiver(a.to())};
    std::array<Vec3<Exact>, 2> q = {exact_.FromReceiver(b.from()),
                                    exact_.FromReceiver(b.to())};
    const auto turn = [&normal](const Vec3<Exact>& from,
                                const Vec3<Exact>& to) {
      return SignOf(Determinant(from, to, normal));
    };
    for (auto* ends : {&p, &q}) {
      if (turn((*ends)[0], (*ends)[1]) == Sign::kNegative)
        std::swap((*ends)[0], (*ends)[1]);
    }
    const auto is_inside = [&turn](const Vec3<Exact>& d,
                                   const std::array<Vec3<Exact>, 2>& ends) {
      return turn(ends[0], d) == Sign::kPositive &&
             turn(d, ends[1]) == Sign::kPositive;
    };
    const auto is_same = [&turn](const Vec3<Exact>& d, const Vec3<Exact>& e) {
      return turn(d, e) == Sign::kZero && SignOf(Dot(d, e)) == Sign::kPositive;
    };
    return is_inside(p[0], q) || is_inside(p[1], q) || is_inside(q[0], p) ||
           is_inside(q[1], p) || (is_same(p[0], q[0]) && is_same(p[1], q[1]));
  }

  const ContourEngine& engine_;
  bool with_level_ = true;
  ReceiverView view_;
  RecipeEvaluator<Exact> exact_;
  ViewGeometry geometry_;
  IgnoredFacetCache ignored_;
  StampedSet<PieceId> is_known_piece_;
  StampedSet<EdgeId> is_known_edge_;
  std::vector<SeenLine> lines_;
  SeenLines found_;
};

Vec3<Exact> Canonical(const Vec3<Exact>& v) {
  for (const Exact* x : {&v.x, &v.y, &v.z}) {
    const Sign sign = SignOf(*x);
    if (sign == Sign::kZero) continue;
    return sign == Sign::kPositive ? v : -v;
  }
  return v;
}

bool AreParallel(const Vec3<Exact>& a, const Vec3<Exact>& b) {
  return IsZero(Cross(a, b));
}

SeenLineFinder::SeenLineFinder(const ContourEngine& engine)
    : impl_(std::make_unique<Impl>(engine)) {}

SeenLineFinder::~SeenLineFinder() = default;

const SeenLines& SeenLineFinder::Find(const ContourQuery& query,
                                      bool with_level) {
  return impl_->Find(query, with_level);
}

}  // namespace truelux
