// SPDX-License-Identifier: GPL-3.0-or-later
#include "explain/receiver_reason.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <map>
#include <numbers>
#include <set>
#include <span>
#include <vector>

#include "base/vector_math.h"
#include "scene/scene_access.h"
#include "text/number_text.h"
#include "visibility/on_horizon.h"

namespace truelux {
namespace {

/// What is visible of one source.
struct Part {
  Vector3 vector_irradiance{0, 0, 0};
  double perimeter = 0;
  std::set<int> vertices;  ///< indices into VisibleContour::vertices
};

/// The scene vertices of a face.
std::set<VertexId> VerticesOfFace(const Scene& scene, FaceNumber number) {
  std::set<VertexId> vertices;
  for (const FacetId f : FacetsOf(FacesOf(scene)[IndexOf(number)])) {
    for (const Triangle& triangle : TrianglesOf(scene, FacetsOf(scene)[f])) {
      for (const int vertex : triangle.vertices)
        vertices.emplace(vertex);
    }
  }
  return vertices;
}

/// Gathers the facts of one contour.
class Reader {
 public:
  Reader(const Scene& scene, const Receiver& receiver,
         const VisibleContour& contour)
      : scene_(scene),
        receiver_(receiver),
        contour_(contour),
        normal_(UnitOf(receiver.normal)) {
    for (const ContourVertex& vertex : contour.vertices)
      directions_.push_back(UnitOf(vertex.direction));
  }

  ReceiverTraits Read() {
    if (contour_.arcs.empty()) {
      if (contour_.statistics.sources > 0) traits_.lighting = Lighting::kUmbra;
      return traits_;
    }
    traits_.lighting = Lighting::kFullyLit;
    traits_.arcs = static_cast<int>(contour_.arcs.size());
    traits_.shortest_arc = 2 * std::numbers::pi;
    for (const ContourArc& arc : contour_.arcs)
      ReadArc(arc);
    traits_.sources = static_cast<int>(parts_.size());
    if (term_sizes_ > 0) {
      traits_.cancellation =
          term_sizes_ / std::max(std::abs(term_sum_), kRounding * term_sizes_);
    }
    ReadVertices();
    ReadMainSource();
    return traits_;
  }

 private:
  [[nodiscard]] const Vector3& Direction(int vertex) const {
    return directions_[static_cast<std::size_t>(vertex)];
  }

  void ReadArc(const ContourArc& arc) {
    const double angle = AngleBetween(Direction(arc.from), Direction(arc.to));
    const Vector3 term = Times(angle / 2, UnitOf(arc.plane_normal));
    term_sum_ += Dot(normal_, term);
    term_sizes_ += std::abs(Dot(normal_, term));
    Part& part = parts_[arc.source];
    part.vector_irradiance = Sum(part.vector_irradiance, term);
    part.perimeter += angle;
    part.vertices.insert({arc.from, arc.to});
    traits_.shortest_arc = std::min(traits_.shortest_arc, angle);
    if (arc.edge_face == 0) {
      ++traits_.horizon_arcs;
    } else if (!IsOutline(arc)) {
      traits_.lighting = Lighting::kPenumbra;
    }
  }

  /// Whether an arc lies on the outline of its own source. Where faces share
  /// an edge, the arc may be said to lie on the other one's.
  bool IsOutline(const ContourArc& arc) {
    if (arc.edge_face == arc.source) return true;
    auto& own = outlines_[arc.source];
    if (own.empty()) own = VerticesOfFace(scene_, FaceNumber(arc.source));
    const auto is_own = [&](int index) {
      const ContourVertex& vertex =
          contour_.vertices[static_cast<std::size_t>(index)];
      return own.contains(VertexId(vertex.vertex));
    };
    return is_own(arc.from) && is_own(arc.to);
  }

  void ReadVertices() {
    for (std::size_t i = 0; i < contour_.vertices.size(); ++i) {
      const ContourVertex& vertex = contour_.vertices[i];
      if (vertex.conjunctive) {
        ++traits_.conjunctions;
        traits_.most_planes = std::max(traits_.most_planes, vertex.planes);
      }
      const double height = Height(i);
      traits_.highest = std::max(traits_.highest, height);
      if (IsOnHorizon(scene_, receiver_, vertex)) continue;
      traits_.lowest = std::min(traits_.lowest.value_or(height), height);
    }
  }

  /// Above the horizon; of scene vertices from their coordinates, which are
  /// exact, while directions are rounded.
  [[nodiscard]] double Height(std::size_t index) const {
    const VertexId vertex(contour_.vertices[index].vertex);
    Vector3 direction = directions_[index];
    if (vertex.valid()) {
      const Point3& v = VerticesOf(scene_)[vertex];
      const Point3& r = receiver_.position;
      direction = UnitOf({v.x - r.x, v.y - r.y, v.z - r.z});
    }
    const double sine = Dot(normal_, direction);
    return std::max(0.0, std::atan2(sine, LengthOf(Cross(normal_, direction))));
  }

  void ReadMainSource() {
    const Part* main = nullptr;
    double largest = -1;
    for (const auto& [source, part] : parts_) {
      const double size = LengthOf(part.vector_irradiance);
      if (size <= largest) continue;
      largest = size;
      main = &part;
    }
    Vector3 mean{0, 0, 0};
    for (const int vertex : main->vertices)
      mean = Sum(mean, Direction(vertex));
    for (const int vertex : main->vertices)
      traits_.extent =
          std::max(traits_.extent, 2 * AngleBetween(mean, Direction(vertex)));
    if (main->perimeter > 0) traits_.width = 2 * largest / main->perimeter;
  }

  const Scene& scene_;
  const Receiver& receiver_;
  const VisibleContour& contour_;
  Vector3 normal_;
  ReceiverTraits traits_;
  std::vector<Vector3> directions_;  ///< of the vertices, of length 1
  std::map<int, Part> parts_;        ///< by the number of the source
  std::map<int, std::set<VertexId>> outlines_;
  double term_sum_ = 0;    ///< of the terms of Lambert's formula
  double term_sizes_ = 0;  ///< of their absolute values
};

std::string SeenText(const ReceiverTraits& traits) {
  std::string text(Name(traits.lighting));
  if (!IsLit(traits)) return text;
  if (traits.sources > 1) text += fmt::format(", {} sources", traits.sources);
  text += fmt::format(", {} arc{}", traits.arcs, traits.arcs == 1 ? "" : "s");
  if (traits.horizon_arcs > 0)
    text += fmt::format(" ({} on the horizon)", traits.horizon_arcs);
  return text;
}

std::vector<std::string> Difficulties(const ReceiverTraits& traits) {
  const auto number = [](double value) {
    return value < kRounding ? "under " + ScientificText(kRounding, 0)
                             : ScientificText(value, 0);
  };
  std::vector<std::string> texts;
  if (!IsLit(traits)) return texts;
  if (traits.conjunctions == 1) {
    texts.push_back(fmt::format("conjunction ({} planes)", traits.most_planes));
  } else if (traits.conjunctions > 1) {
    texts.push_back(fmt::format("{} conjunctions (up to {} planes)",
                                traits.conjunctions, traits.most_planes));
  }
  if (traits.highest < kGrazingHighest) {
    texts.push_back(
        fmt::format("grazing (highest vertex {} rad above the horizon)",
                    number(traits.highest)));
  } else if (traits.lowest && *traits.lowest < kGrazingLowest) {
    texts.push_back(fmt::format("grazing horizon (lowest vertex {} rad above)",
                                number(*traits.lowest)));
  }
  if (traits.extent < kTinyExtent)
    texts.push_back(fmt::format("tiny source ({} rad)", number(traits.extent)));
  if (traits.width < kSliverRatio * traits.extent) {
    texts.push_back(fmt::format("sliver ({} wide)", number(traits.width)));
  }
  if (traits.cancellation > kCancellation) {
    constexpr double kReadable = 1e5;
    texts.push_back(fmt::format("cancellation (terms {} times their sum)",
                                traits.cancellation < kReadable
                                    ? fmt::format("{:.0f}", traits.cancellation)
                                    : number(traits.cancellation)));
  }
  if (traits.shortest_arc < kShortArc * std::min(1.0, traits.extent)) {
    texts.push_back(
        fmt::format("short arc ({} rad)", number(traits.shortest_arc)));
  }
  return texts;
}

}  // namespace

std::string_view Name(Lighting lighting) {
  switch (lighting) {
    case Lighting::kUnlit:
      break;
    case Lighting::kUmbra:
      return "umbra";
    case Lighting::kFullyLit:
      return "fully lit";
    case Lighting::kPenumbra:
      return "penumbra";
  }
  return "unlit";
}

ReceiverTraits TraitsOf(const Scene& scene, const Receiver& receiver,
                        const VisibleContour& contour) {
  return Reader(scene, receiver, contour).Read();
}

std::string TextOf(const ReceiverTraits& traits) {
  const std::vector<std::string> difficulties = Difficulties(traits);
  std::string text = SeenText(traits);
  if (!difficulties.empty())
    text += fmt::format("; {}", fmt::join(difficulties, ", "));
  return text;
}

std::string ReasonOf(const Scene& scene, const Receiver& receiver,
                     const VisibleContour& contour) {
  return TextOf(TraitsOf(scene, receiver, contour));
}

}  // namespace truelux
