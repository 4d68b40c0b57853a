// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/plain_contour.h"

#include <algorithm>
#include <array>
#include <vector>

#include "scene/coplanar_order.h"
#include "scene/scene_access.h"
#include "support/edge_sweep.h"
#include "visibility/edges/cone.h"
#include "visibility/edges/contour_writer.h"
#include "visibility/edges/coverage.h"

namespace truelux::testing {
namespace {

class PlainEngine {
 public:
  explicit PlainEngine(const ContourQuery& query)
      : query_(query),
        scene_(query.scene),
        pieces_(scene_, 3),
        normals_(
            FilteredTriangleNormals(scene_.vertices(), scene_.triangles())),
        geometry_(ViewOf(query), normals_),
        cones_(geometry_, pieces_),
        sweep_(geometry_),
        writer_(scene_, pieces_, geometry_),
        ignored_(IgnoredFacets(query)) {}

  Contour Build() {
    cones_.SetReceiver();
    Contour contour;
    writer_.Start(contour);
    for (const FacetId facet : FacetsOf(scene_).ids()) {
      if (IsSource(facet)) BuildSource(facet);
    }
    return contour;
  }

 private:
  [[nodiscard]] bool IsIgnored(FacetId facet) const {
    return !ignored_.empty() && ignored_[facet];
  }

  bool IsSource(FacetId facet) {
    const FaceId face = FaceOf(scene_, facet);
    const Rgb& emission = FacesOf(scene_)[face].emission;
    const bool wanted =
        query_.only_source.valid()
            ? NumberOf(face) == query_.only_source
            : std::ranges::any_of(emission, [](double m) { return m > 0; });
    return wanted && !IsIgnored(facet) &&
           cones_.ReceiverSide(pieces_.FirstPieceOf(facet)) == Sign::kNegative;
  }

  void BuildSource(FacetId facet) {
    sources_.clear();
    blockers_.clear();
    const TriangleId source = FirstTriangleOf(FacetsOf(scene_)[facet]);
    for (const PieceId p : pieces_.pieces().ids()) {
      const Piece& piece = pieces_.pieces()[p];
      if (IsIgnored(piece.facet) || cones_.ReceiverSide(p) == Sign::kZero) {
        continue;
      }
      if (piece.facet == facet) {
        if (auto cone = cones_.AboveHorizon(p)) Add(sources_, *cone);
      } else {
        AddBlocker(source, facet, p);
      }
    }
    arcs_.clear();
    for (const auto* parts : {&sources_, &blockers_}) {
      for (std::size_t p = 0; p < parts->size(); ++p) {
        for (std::size_t k = 0; k < (*parts)[p].size; ++k)
          Sweep((*parts)[p], k);
      }
    }
    writer_.WriteSource(facet, arcs_);
  }

  void Add(std::vector<Cone>& cones, Cone cone) {
    cones_.Complete(cone);
    cones.push_back(cone);
  }

  void AddBlocker(TriangleId source, FacetId facet, PieceId p) {
    const Piece& piece = pieces_.pieces()[p];
    CornerSigns sides{};
    int front = 0;
    int behind = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      sides[k] = geometry_.VertexSide(source, pieces_.CornersOf(piece)[k]);
      front += sides[k] == Sign::kPositive ? 1 : 0;
      behind += sides[k] == Sign::kNegative ? 1 : 0;
    }
    const bool shows_front = cones_.ReceiverSide(p) == Sign::kNegative;
    const bool earlier =
        IsSeenBefore(scene_, {piece.facet, shows_front}, {facet, true});
    if (front > 0 && behind > 0) {
      Add(blockers_, cones_.InFrontOf(source, p, sides));
    } else if (front > 0 || (behind == 0 && earlier)) {
      Add(blockers_, cones_.Whole(p));
    }
  }

  /// The cover of a cone whose edge comes before in the order of edges, in the
  /// same plane, owns the arcs.
  void Sweep(const Cone& own, std::size_t edge) {
    const ViewEdge e{own.planes[edge], own.From(edge), own.To(edge)};
    sweep_.Start(e);
    const auto add = [&](const Cone& cone, bool blocks, bool before) {
      Cover cover;
      if (!CoverOf(geometry_, e, cone, cover)) return;
      if (blocks) {
        sweep_.AddBlocker(cover);
      } else {
        sweep_.AddSource(cover);
      }
      const bool is_owner =
          cover.side != Sign::kZero &&
          (before || (&cone == &own && cover.coincident < edge));
      if (is_owner) sweep_.AddOwner(cover);
    };
    bool before = true;
    for (const Cone& cone : sources_) {
      before = before && &cone != &own;
      add(cone, false, before);
    }
    for (const Cone& cone : blockers_) {
      before = before && &cone != &own;
      add(cone, true, before);
    }
    for (const VisiblePiece& piece : sweep_.Finish()) {
      arcs_.push_back({e, piece, own.piece, kNoEdge});
    }
  }

  const ContourQuery& query_;
  const Scene& scene_;
  ConvexPieces pieces_;
  IdVector<TriangleId, FilteredPlane> normals_;
  ViewGeometry geometry_;
  ConeMaker<ViewGeometry> cones_;
  EdgeSweep<ViewGeometry> sweep_;
  ContourWriter<ViewGeometry> writer_;
  IdVector<FacetId, bool> ignored_;
  std::vector<Cone> sources_;
  std::vector<Cone> blockers_;
  std::vector<ViewArc> arcs_;
};

}  // namespace

Contour PlainContour(const ContourQuery& query) {
  const RoundUpward rounding;
  return PlainEngine(query).Build();
}

}  // namespace truelux::testing
