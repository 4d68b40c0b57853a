// SPDX-License-Identifier: GPL-3.0-or-later
// The lines of the arrangement engine's arcs.
//
// Its contours have explicit planes: they say what is seen, which is all that E
// needs, but not at what distance. Here each arc finds its edge, or its cut,
// among those of the scene: with its plane, its ends and its face, and without
// any of the contour engine's code.

#ifndef TRUELUX_TESTS_RADIOMETRY_DERIVATIVES_ARRANGEMENT_LINES_H_
#define TRUELUX_TESTS_RADIOMETRY_DERIVATIVES_ARRANGEMENT_LINES_H_

#include <map>
#include <optional>
#include <stdexcept>
#include <vector>

#include "exact/primitive.h"
#include "exact/recipe_evaluator.h"
#include "scene/scene_access.h"
#include "visibility/arc_cleanup.h"
#include "visibility/arrangement/arrangement_engine.h"

namespace truelux::testing {

/// Makes contours with lines, for scenes of planar faces.
class ArrangementLines {
 public:
  /// scene: must outlive the object.
  explicit ArrangementLines(const Scene& scene) : scene_(scene) {}

  /// The arrangement engine's contour of a query, whose planes are edges, cuts
  /// and the horizon. What it has on the walls between its charts is left out
  /// where both sides of the wall have it.
  Contour Find(const ContourQuery& query) {
    contour_ = {};
    Add(query, ViewOf(query));
    return std::move(contour_);
  }

  /// The same over the whole sphere: what is seen above the receiver plane and
  /// below it. The arcs on the horizon are opposite ones.
  Contour FindSphere(ContourQuery query) {
    contour_ = {};
    const ReceiverView view = ViewOf(query);
    Add(query, view);
    Vector3& n = query.receiver.normal;
    n = {-n.x, -n.y, -n.z};
    Add(query, view);
    return std::move(contour_);
  }

  /// What was met so far.
  [[nodiscard]] int edges() const { return edges_; }

  [[nodiscard]] int cuts() const { return cuts_; }

  [[nodiscard]] int horizons() const { return horizons_; }

  [[nodiscard]] int walls() const { return walls_; }

 private:
  /// The directions of one query's contour, each once.
  struct Directions {
    std::map<PrimitiveVector, int> index;
    std::vector<PrimitiveVector> primitive;
    std::vector<DirectionId> ids;
  };

  /// view: of the contour that is made, whose receiver may face the other way.
  void Add(const ContourQuery& query, const ReceiverView& view) {
    const Contour given = ContourByArrangement(query);
    const RecipeEvaluator<Exact> exact(view);
    const auto vectors = given.explicit_vectors.All();
    Directions directions;
    const auto index_of = [&](DirectionId id) {
      const Vec3<Exact> d =
          exact.Direction(given.directions[id], given.planes, vectors);
      const auto [entry, is_new] = directions.index.try_emplace(
          MakePrimitive(d), static_cast<int>(directions.ids.size()));
      if (is_new) {
        directions.primitive.push_back(entry->first);
        directions.ids.push_back(contour_.directions.push_back(
            DirectionRecipe::Explicit(contour_.explicit_vectors.Add(d))));
      }
      return entry->second;
    };
    for (const SourceArcs& source : given.sources) {
      std::vector<ExactArc> arcs;
      for (const Arc& arc : given.ArcsOf(source)) {
        const Vec3<Exact> normal =
            exact.Plane(given.planes[arc.plane], vectors);
        ExactArc& own = arcs.emplace_back();
        own.arc.from = index_of(arc.from);
        own.arc.to = index_of(arc.to);
        own.arc.source = source.facet.value();
        own.arc.edge_face = arc.edge_face.value();
        own.plane = MakePrimitive(arc.positive ? normal : -normal);
      }
      const auto kept = WithoutOppositeArcs(arcs, directions.primitive);
      walls_ += static_cast<int>(arcs.size()) - static_cast<int>(kept.size());
      contour_.sources.push_back({source.facet, contour_.arcs.end_id(),
                                  static_cast<int>(kept.size())});
      for (const ExactArc& arc : kept)
        AddArc(exact, directions, arc.arc, source.facet);
    }
  }

  void AddArc(const RecipeEvaluator<Exact>& exact, const Directions& directions,
              const ContourArc& given, FacetId source) {
    Arc arc;
    arc.from = directions.ids[static_cast<std::size_t>(given.from)];
    arc.to = directions.ids[static_cast<std::size_t>(given.to)];
    arc.edge_face = FaceNumber(given.edge_face);
    const Vec3<Exact>& from = VectorOf(arc.from);
    const Vec3<Exact>& to = VectorOf(arc.to);
    // Towards the visible side.
    const Vec3<Exact> normal = Cross(from, to);
    const PlaneRecipe plane =
        LineOf(exact, normal, from + to, source, arc.edge_face);
    const bool is_along =
        SignOf(Dot(exact.Plane(plane, {}), normal)) == Sign::kPositive;
    arc.plane = contour_.planes.push_back(plane.NegatedIf(!is_along));
    contour_.arcs.push_back(arc);
  }

  [[nodiscard]] const Vec3<Exact>& VectorOf(DirectionId id) const {
    return contour_.explicit_vectors[contour_.directions[id].explicit_vector()];
  }

  /// The line of an arc in a plane, with a direction in its midst. face: of the
  /// edge if known, and is then found.
  PlaneRecipe LineOf(const RecipeEvaluator<Exact>& exact,
                     const Vec3<Exact>& normal, const Vec3<Exact>& middle,
                     FacetId source, FaceNumber& face) {
    if (IsZero(Cross(normal, exact.ReceiverNormal()))) {
      ++horizons_;
      face = {};
      return PlaneRecipe::OfHorizon();
    }
    std::vector<FaceNumber> faces;
    if (face.valid()) {
      faces.push_back(face);
    } else {
      for (const FaceId id : FacesOf(scene_).ids())
        faces.push_back(NumberOf(id));
    }
    // Of several edges in the plane the nearest: what is between r and the
    // source would be seen, what is behind the source is not.
    std::optional<PlaneRecipe> nearest;
    for (const FaceNumber candidate : faces) {
      const auto edge = EdgeOf(exact, normal, middle, candidate);
      if (!edge || (nearest && !IsNearer(exact, middle, *edge, *nearest)))
        continue;
      nearest = edge;
      face = candidate;
    }
    if (nearest) {
      ++edges_;
      return *nearest;
    }
    for (const FaceNumber candidate : faces) {
      if (const auto cut = CutOf(exact, normal, source, candidate)) {
        ++cuts_;
        face = candidate;
        return *cut;
      }
    }
    throw std::logic_error("an arc without a line");
  }

  /// The triangles of a face.
  [[nodiscard]] std::vector<TriangleId> TrianglesOfFace(FaceNumber face) const {
    std::vector<TriangleId> all;
    for (const TriangleId t : TrianglesOf(scene_).ids()) {
      const FacetId facet = FacetOf(TrianglesOf(scene_)[t]);
      if (NumberOf(FaceOf(scene_, facet)) == face) all.push_back(t);
    }
    return all;
  }

  /// Of the outline of a face: where one goes through its diagonal, that is no
  /// edge.
  [[nodiscard]] std::optional<PlaneRecipe> EdgeOf(
      const RecipeEvaluator<Exact>& exact, const Vec3<Exact>& normal,
      const Vec3<Exact>& middle, FaceNumber number) const {
    const Face& face = FacesOf(scene_)[IndexOf(number)];
    const auto count = static_cast<std::size_t>(face.corner_count);
    const auto ring = scene_.corners().subspan(
        static_cast<std::size_t>(face.first_corner), count);
    for (std::size_t k = 0; k < count; ++k) {
      const VertexId a(ring[k]);
      const VertexId b(ring[(k + 1) % count]);
      const PlaneRecipe edge = PlaneRecipe::OfEdge(a, b);
      const Vec3<Exact> own = exact.Plane(edge, {});
      if (IsZero(own) || !IsZero(Cross(own, normal))) continue;
      const bool is_between =
          SignOf(Determinant(exact.FromReceiver(a), middle, own)) ==
              Sign::kPositive &&
          SignOf(Determinant(middle, exact.FromReceiver(b), own)) ==
              Sign::kPositive;
      if (is_between) return edge;
    }
    return std::nullopt;
  }

  /// Whether the edge of a is nearer than that of b in a direction d of their
  /// plane: 1/rho = d . (L x N) / N^2.
  static bool IsNearer(const RecipeEvaluator<Exact>& exact,
                       const Vec3<Exact>& d, const PlaneRecipe& a,
                       const PlaneRecipe& b) {
    const Vec3<Exact> n_a = exact.Plane(a, {});
    const Vec3<Exact> n_b = exact.Plane(b, {});
    const Vec3<Exact> l_a = exact.FromVertex(a.from(), a.to());
    const Vec3<Exact> l_b = exact.FromVertex(b.from(), b.to());
    return SignOf(Dot(d, Cross(l_a, n_a)) * Dot(n_b, n_b) -
                  Dot(d, Cross(l_b, n_b)) * Dot(n_a, n_a)) == Sign::kPositive;
  }

  /// Where a face goes through the plane of a source.
  [[nodiscard]] std::optional<PlaneRecipe> CutOf(
      const RecipeEvaluator<Exact>& exact, const Vec3<Exact>& normal,
      FacetId source, FaceNumber face) const {
    const TriangleId own = FirstTriangleOf(FacetsOf(scene_)[source]);
    for (const TriangleId t : TrianglesOfFace(face)) {
      const PlaneRecipe cut = PlaneRecipe::OfCut(own, t);
      const Vec3<Exact> plane = exact.Plane(cut, {});
      if (!IsZero(plane) && IsZero(Cross(plane, normal))) return cut;
    }
    return std::nullopt;
  }

  const Scene& scene_;
  Contour contour_;
  int edges_ = 0;
  int cuts_ = 0;
  int horizons_ = 0;
  int walls_ = 0;
};

}  // namespace truelux::testing

#endif  // TRUELUX_TESTS_RADIOMETRY_DERIVATIVES_ARRANGEMENT_LINES_H_
