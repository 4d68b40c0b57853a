// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/kink_pieces.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/stop.h"
#include "surface/cut_merge.h"
#include "surface/cut_sieve.h"
#include "surface/kink_events.h"
#include "surface/plane_cut.h"
#include "surface/strip_arcs.h"
#include "surface/strip_size.h"

namespace truelux {
namespace {

/// What makes a kink.
struct Causes {
  std::vector<int> faces;  ///< indices, ascending
  std::vector<int> edges;  ///< indices into PlaneCut::edges, ascending

  friend bool operator==(const Causes&, const Causes&) = default;
};

/// Of the trace, from one t to another.
struct Part {
  mpq_class from;
  mpq_class to;
  Causes causes;
};

void SortOnce(std::vector<int>& numbers) {
  std::ranges::sort(numbers);
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

Causes CausesOf(const std::vector<StripArc>& arcs) {
  Causes causes;
  for (const StripArc& arc : arcs) {
    causes.faces.insert(causes.faces.end(), arc.faces.begin(), arc.faces.end());
    causes.edges.insert(causes.edges.end(), arc.edges.begin(), arc.edges.end());
  }
  SortOnce(causes.faces);
  SortOnce(causes.edges);
  return causes;
}

/// A short number between two others: the double in the middle if there is one.
mpq_class Between(const mpq_class& a, const mpq_class& b) {
  const mpq_class middle = (a + b) / 2;
  const mpq_class near(middle.get_d());
  return a < near && near < b ? near : middle;
}

bool IsContact(const PlaneCut& cut, const mpq_class& t) {
  return std::ranges::any_of(cut.contacts, [&t](const auto& contact) {
    return contact[0] <= t && t <= contact[1];
  });
}

std::vector<Part> PartsOf(const PlaneCut& cut, StripFinder& finder,
                          const StopFlag* stop) {
  const std::vector<mpq_class> events = EventsOf(cut, finder, stop);
  std::vector<Part> parts;
  for (std::size_t i = 0; i + 1 < events.size(); ++i) {
    StopIfAsked(stop);
    const mpq_class t = Between(events[i], events[i + 1]);
    if (IsContact(cut, t)) continue;
    const std::vector<StripArc> arcs = finder.ArcsAt(t);
    if (arcs.empty()) continue;
    Causes causes = CausesOf(arcs);
    if (!parts.empty() && parts.back().to == events[i] &&
        parts.back().causes == causes) {
      parts.back().to = events[i + 1];
    } else {
      parts.push_back({events[i], events[i + 1], std::move(causes)});
    }
  }
  return parts;
}

/// The size in the middle; nothing if arcs cancel there and at a second place.
std::optional<Rgb> SizeOf(const PlaneCut& cut, StripFinder& finder,
                          const Part& part) {
  const auto size_at = [&](const mpq_class& t) {
    return KinkSizeOf(cut, finder.ArcsAt(t), t);
  };
  const Rgb size = size_at((part.from + part.to) / 2);
  if (size != Rgb{}) return size;
  const mpq_class third = (2 * part.from + part.to) / 3;
  if (size_at(third) != Rgb{}) return size;
  return std::nullopt;
}

/// All that matters in a plane, with crossings.
PlaneCut SimpleCutOf(const Scene& scene, const EdgePlanes& planes,
                     std::size_t plane_index, const CutAxes& axes) {
  PlaneCut cut = PlaneCutOf(scene, planes, plane_index, axes);
  MergeFacets(cut);
  MarkParts(scene, cut);
  DropWithoutEffect(cut);
  if (cut.facets.empty() && cut.flats.empty()) return {};
  DropPoints(cut);
  AddCrossings(cut);
  return cut;
}

}  // namespace

std::vector<KinkPiece> KinkPiecesOf(
    const Scene& scene, const SurfaceFrame& frame, const EdgePlanes& planes,
    std::size_t plane_index, const RationalVector& from,
    const RationalVector& to, bool reversed_side, const StopFlag* stop) {
  const CutAxes axes = CutAxesOf(scene, frame, planes.planes.at(plane_index),
                                 from, to, reversed_side);
  const PlaneCut cut = SimpleCutOf(scene, planes, plane_index, axes);
  if (cut.points.empty()) return {};
  StripFinder finder(scene, cut);
  std::vector<KinkPiece> pieces;
  for (const Part& part : PartsOf(cut, finder, stop)) {
    const std::optional<Rgb> size = SizeOf(cut, finder, part);
    if (!size) continue;
    KinkPiece piece;
    piece.from = axes.PointAt(part.from);
    piece.to = axes.PointAt(part.to);
    piece.size = *size;
    for (const int face : part.causes.faces)
      piece.faces.push_back(face + 1);
    for (const int edge : part.causes.edges)
      piece.edges.push_back(cut.edges[static_cast<std::size_t>(edge)].ends);
    std::ranges::sort(piece.edges);
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

}  // namespace truelux
