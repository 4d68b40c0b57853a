// SPDX-License-Identifier: GPL-3.0-or-later
#include "visibility/arc_cleanup.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

namespace truelux {
namespace {

std::size_t Index(int i) {
  return static_cast<std::size_t>(i);
}

/// Sign of det(a, b, c).
int Turn(const PrimitiveVector& a, const PrimitiveVector& b,
         const PrimitiveVector& c) {
  return sgn(mpz_class((a.y * b.z - a.z * b.y) * c.x +
                       (a.z * b.x - a.x * b.z) * c.y +
                       (a.x * b.y - a.y * b.x) * c.z));
}

/// The arcs of one source in one plane, whatever their direction.
using Group = std::vector<ExactArc>;

/// An arc cut at the vertices of its group that lie strictly inside it.
std::vector<ExactArc> Split(const ExactArc& whole,
                            const std::set<int>& vertices,
                            std::span<const PrimitiveVector> directions) {
  const auto inside = [&](int v, int from, int to) {
    return Turn(directions[Index(from)], directions[Index(v)], whole.plane) >
               0 &&
           Turn(directions[Index(v)], directions[Index(to)], whole.plane) > 0;
  };
  std::vector<int> cuts;
  for (const int v : vertices) {
    if (inside(v, whole.arc.from, whole.arc.to)) cuts.push_back(v);
  }
  std::ranges::sort(cuts, [&](int a, int b) {
    return Turn(directions[Index(a)], directions[Index(b)], whole.plane) > 0;
  });
  std::vector<ExactArc> pieces;
  ExactArc piece = whole;
  for (const int v : cuts) {
    piece.arc.to = v;
    pieces.push_back(piece);
    piece.arc.from = v;
  }
  piece.arc.to = whole.arc.to;
  pieces.push_back(piece);
  return pieces;
}

void AppendUncancelled(const Group& group,
                       std::span<const PrimitiveVector> directions,
                       std::vector<ExactArc>& kept) {
  std::set<int> vertices;
  for (const ExactArc& a : group)
    vertices.insert({a.arc.from, a.arc.to});
  std::multimap<std::pair<int, int>, ExactArc> open;
  for (const ExactArc& whole : group) {
    for (const ExactArc& piece : Split(whole, vertices, directions)) {
      const auto opposite = open.find({piece.arc.to, piece.arc.from});
      if (opposite != open.end()) {
        open.erase(opposite);
      } else {
        open.emplace(std::pair{piece.arc.from, piece.arc.to}, piece);
      }
    }
  }
  for (const auto& [ends, piece] : open)
    kept.push_back(piece);
}

}  // namespace

std::vector<ExactArc> WithoutOppositeArcs(
    const std::vector<ExactArc>& arcs,
    std::span<const PrimitiveVector> directions) {
  std::map<std::pair<int, PrimitiveVector>, Group> groups;
  for (const ExactArc& a : arcs) {
    groups[{a.arc.source, WithoutSign(a.plane)}].push_back(a);
  }
  std::vector<ExactArc> kept;
  for (const auto& entry : groups) {
    const Group& group = entry.second;
    const bool one_way = std::ranges::all_of(group, [&](const ExactArc& a) {
      return a.plane == group.front().plane;
    });
    if (one_way) {
      kept.insert(kept.end(), group.begin(), group.end());
    } else {
      AppendUncancelled(group, directions, kept);
    }
  }
  return kept;
}

std::vector<ExactArc> JoinedArcs(std::vector<ExactArc> arcs,
                                 std::span<const ContourVertex> vertices) {
  std::vector<std::vector<std::size_t>> arriving(vertices.size());
  std::vector<std::vector<std::size_t>> leaving(vertices.size());
  for (std::size_t a = 0; a < arcs.size(); ++a) {
    leaving[Index(arcs[a].arc.from)].push_back(a);
    arriving[Index(arcs[a].arc.to)].push_back(a);
  }
  std::vector<bool> gone(arcs.size(), false);
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    if (vertices[v].kind == VertexKind::kIntrinsic || arriving[v].size() != 1 ||
        leaving[v].size() != 1) {
      continue;
    }
    const std::size_t first = arriving[v][0];
    const std::size_t second = leaving[v][0];
    if (first == second || arcs[first].arc.source != arcs[second].arc.source ||
        arcs[first].plane != arcs[second].plane) {
      continue;
    }
    const int end = arcs[second].arc.to;
    arcs[first].arc.to = end;
    if (arcs[first].arc.edge_face == 0) {
      arcs[first].arc.edge_face = arcs[second].arc.edge_face;
    }
    gone[second] = true;
    *std::ranges::find(arriving[Index(end)], second) = first;
  }
  std::vector<ExactArc> joined;
  for (std::size_t a = 0; a < arcs.size(); ++a) {
    if (!gone[a]) joined.push_back(arcs[a]);
  }
  return joined;
}

}  // namespace truelux
