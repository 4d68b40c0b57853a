// SPDX-License-Identifier: GPL-3.0-or-later
// What is seen in the strips beside a plane, from one point of its trace.
//
// Moved out of the plane P by s along its normal, s small, a receiver sees lines
// of P side by side that lay behind each other. How far aside a line appears
// depends on its inverse height z over the trace alone. So a strip of the view
// is told by a direction (u, 1) in P, by z and by the sign of s:
//   - a facet that P crosses is seen at every z, at the depth of its own line,
//   - a facet with an edge in P is seen at those z that lie on its side,
//   - a triangle in P is seen at the z of its own points.
// Of these the nearest one is seen. What is seen changes at lines of P, each of
// which has a z that is linear in u.

#ifndef TRUELUX_SURFACE_STRIP_ARCS_H_
#define TRUELUX_SURFACE_STRIP_ARCS_H_

#include <array>
#include <optional>
#include <vector>

#include <gmpxx.h>

#include "truelux/scene.h"

#include "surface/plane_cut.h"

namespace truelux {

/// A line at which strips differ: the exitance above its z minus that below,
/// added up over both signs of s.
struct StripStep {
  int line = 0;  ///< index into PlaneCut::lines
  std::array<mpq_class, 3> jump;
};

/// Directions (u, 1) in P, between two ends, in which nothing begins or ends,
/// and strips that differ in such a way that they add to the kink.
struct StripArc {
  std::optional<mpq_class> from;  ///< u; nothing: along the trace
  std::optional<mpq_class> to;
  std::vector<StripStep> steps;
  std::vector<int> faces;  ///< indices of faces in P that make steps
  std::vector<int> edges;  ///< indices into PlaneCut::edges, on their lines
};

/// Finds arcs at one place of the trace after the other.
class StripFinder {
 public:
  /// The scene and the cut must outlive it.
  StripFinder(const Scene& scene, const PlaneCut& cut);

  /// Whether what begins or ends in a direction (u, 1) can make a difference:
  /// a light and two lines lie there, seen from (t, 0), or begin there.
  [[nodiscard]] bool Matters(const mpq_class& t, const mpq_class& u) const;

  /// The arcs at (t, 0) in the order of u, which does not lie on a face. Places
  /// that are near each other are faster one after the other.
  [[nodiscard]] std::vector<StripArc> ArcsAt(const mpq_class& t);

 private:
  /// Something with a range of directions.
  struct Span {
    const CutSegment* segment = nullptr;
    int facet = -1;         ///< index into PlaneCut::facets
    int flat = -1;          ///< index into PlaneCut::flats
    bool is_bound = false;  ///< whether strips may differ at its line
    bool is_light = false;
  };

  /// The cells of a span: from first to before last. A cell k ends at the k-th
  /// of the different directions.
  struct Cells {
    int first = 0;
    int last = 0;
  };

  /// Something that is seen in one cell.
  struct Cover {
    const CutFacet* facet = nullptr;  ///< null: a flat triangle
    int scene_facet = 0;
    int front_side = 0;  ///< as CutFlat::front_side
    int near = 0;        ///< index into Cell::lines
    int far = 0;         ///< of a flat triangle; else near
  };

  /// A line in one cell.
  struct PlacedLine {
    int line = 0;
    mpq_class z;
  };

  struct Cell {
    std::vector<PlacedLine> lines;  ///< with rising z
    std::vector<Cover> covers;
  };

  /// The face that is seen, as an index, and what shows it.
  struct Seen {
    const Cover* cover = nullptr;
    int face = -1;  ///< -1: nothing that emits
  };

  /// The steps of a cell by its lines.
  struct Steps {
    std::vector<StripStep> steps;
    std::vector<std::vector<int>> faces;  ///< in P that make them, indices
  };

  void Sort(const mpq_class& t);
  [[nodiscard]] Cells CellsOf(const CutSegment& segment,
                              const mpq_class& t) const;
  [[nodiscard]] bool ShowsFront(const CutFacet& facet,
                                const mpq_class& t) const;
  [[nodiscard]] bool IsIn(const CutSegment& segment, const mpq_class& t,
                          const mpq_class& u) const;
  [[nodiscard]] mpq_class MiddleOf(int cell) const;
  [[nodiscard]] Cell CellOf(const std::vector<int>& spans, const mpq_class& t,
                            const mpq_class& u) const;
  [[nodiscard]] bool ShowsFront(const Cover& cover, int sense,
                                const mpq_class& t) const;
  [[nodiscard]] Seen SeenIn(const Cell& cell, int strip, int sense,
                            const mpq_class& t) const;
  [[nodiscard]] bool IsNearer(const Cover& a, const Cover& b, int strip,
                              int sense, const Cell& cell,
                              const mpq_class& t) const;
  void AddStep(const Seen& below, const Seen& above, int place,
               Steps& steps) const;
  [[nodiscard]] std::optional<StripArc> ArcOf(const Cell& cell,
                                              const mpq_class& t) const;
  [[nodiscard]] bool DropChannelsWithoutKink(
      std::vector<StripStep>& steps) const;
  void AddEdges(StripArc& arc, int cell, const mpq_class& t) const;

  const Scene& scene_;
  const PlaneCut& cut_;
  std::vector<Span> spans_;
  std::vector<int> order_;             ///< of points, by their directions
  std::vector<mpq_class> directions_;  ///< of points
  std::vector<int> ranks_;             ///< of points: of equal ones the same
  std::vector<mpq_class> different_;   ///< the different directions, rising
};

}  // namespace truelux

#endif  // TRUELUX_SURFACE_STRIP_ARCS_H_
