// The edges that could bound what is visible of one source, by the plainest
// exact means: for looking at a contour, not for finding it.

#ifndef TRUELUX_VISIBILITY_VIEW_VIEW_EDGES_H_
#define TRUELUX_VISIBILITY_VIEW_VIEW_EDGES_H_

#include <optional>
#include <vector>

#include "exact/recipe_evaluator.h"
#include "visibility/contour.h"
#include "visibility/view/seen_edge.h"

namespace truelux {

/// The edges of a source facet and of what lies in front of its plane,
/// without diagonals of faces, without inner edges of blocking meshes, and
/// with the lines where blockers enter the source's plane. Triangles that are
/// more than kBeside away from what the source covers are left out.
class ViewEdges {
 public:
  /// [rad]; no vertex of the source's contour has an edge of those.
  static constexpr double kBeside = 0.01;

  /// query and its scene must outlive the object.
  ViewEdges(const ContourQuery& query, int facet);

  [[nodiscard]] int facet() const { return facet_; }

  /// An edge that passes through a direction.
  struct Hit {
    Vec3<Exact> plane;  ///< normal of the edge's plane through r
    int vertex = -1;    ///< the scene vertex where it ends there, or -1
    SeenEdge edge;
  };

  /// All edges whose closed extent holds the direction d, where they are in
  /// front of the source's plane or on it. Exact.
  [[nodiscard]] std::vector<Hit> Through(const Vec3<Exact>& d) const;

  /// An edge that passes a direction by, and the angle in between [rad], > 0.
  struct Miss {
    SeenEdge edge;
    double angle = 0;
  };

  /// Of the edges of Through that do not pass through the direction d, the one
  /// nearest to it; nothing if there is none. d: seen on the source. That an edge misses is exact,
  /// the angle is good to a few digits.
  [[nodiscard]] std::optional<Miss> Nearest(const Vec3<Exact>& d) const;

 private:
  /// From direction `from` to direction `to`; a and b are its scene vertices,
  /// -1 for the ends of a cut.
  struct Edge {
    Vec3<Interval> plane;
    DirectionRecipe from;
    DirectionRecipe to;
    int a = -1;
    int b = -1;
    SeenEdge seen;
    Vec3<double> from_unit;  ///< of length 1, rounded
    Vec3<double> to_unit;
    double length = 0;  ///< angle between these two
    /// Whether the two are good to 1e-12: differences of input numbers.
    bool has_sure_ends = false;
  };

  /// Directions within an angle of one of them; a wide one, of no less than
  /// 1.5, stands for all directions.
  struct Cap {
    Vec3<double> center;
    double radius = 0;

    [[nodiscard]] bool IsWide() const { return !(radius < 1.5); }
  };

  [[nodiscard]] Cap CapOf(const Triangle& triangle) const;
  [[nodiscard]] bool IsBesideSource(const Triangle& triangle) const;
  [[nodiscard]] Exact AbovePlane(int vertex) const;
  [[nodiscard]] Sign SideOfPlane(int vertex) const;
  [[nodiscard]] Sign SideOfEdge(int a, int b, int vertex) const;
  [[nodiscard]] bool Relevant(int triangle) const;
  void AddSceneEdges(const std::vector<int>& relevant);
  void AddCut(int triangle);
  void AddEdge(const DirectionRecipe& from, const DirectionRecipe& to, int a,
               int b, const SeenEdge& seen);
  [[nodiscard]] std::optional<Hit> HitOf(const Edge& edge,
                                         const Vec3<Exact>& d) const;
  [[nodiscard]] int FaceOf(int facet) const;
  [[nodiscard]] bool InFront(const Edge& edge, const Exact& weight_a,
                             const Exact& weight_b) const;

  const ContourQuery& query_;
  ReceiverView view_;
  RecipeEvaluator<Exact> exact_;
  RecipeEvaluator<Interval> interval_;
  int facet_;
  int source_triangle_;
  std::vector<Cap> source_caps_;  ///< of the source's triangles
  std::vector<Edge> edges_;
};

}  // namespace truelux

#endif  // TRUELUX_VISIBILITY_VIEW_VIEW_EDGES_H_
