// SPDX-License-Identifier: GPL-3.0-or-later
#include "plan/plan_json.h"

#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "truelux/version.h"

#include "plan/plan_tables.h"
#include "text/results.h"

namespace truelux {
namespace {

/// Names of users need not be UTF-8.
std::string TextOf(std::string_view word) {
  using Json = nlohmann::ordered_json;
  return Json(word).dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string TextOf(double number) {
  if (!std::isfinite(number)) return "null";
  std::string text;
  AppendNumber(text, number);
  return text;
}

std::string TextOf(bool is_true) {
  return is_true ? "true" : "false";
}

std::string TextOf(int number) {
  return std::to_string(number);
}

std::string TextOf(std::uint64_t number) {
  return std::to_string(number);
}

std::string TextOf(const Point3& p) {
  return "[" + TextOf(p.x) + "," + TextOf(p.y) + "," + TextOf(p.z) + "]";
}

std::string TextOf(const Vector3& v) {
  return TextOf(Point3{v.x, v.y, v.z});
}

std::string TextOf(const IsoluxVertex& vertex);

/// An array on one line.
template <class List>
std::string ListText(const List& list) {
  std::string text = "[";
  for (const auto& element : list) {
    if (text.size() > 1) text += ',';
    text += TextOf(element);
  }
  return text + "]";
}

/// An object on one line.
class ObjectText {
 public:
  ObjectText& Add(const char* key, const std::string& value) {
    text_ +=
        (text_.size() > 1 ? ",\"" : "\"") + std::string(key) + "\":" + value;
    return *this;
  }

  [[nodiscard]] std::string Ended() const { return text_ + "}"; }

 private:
  std::string text_ = "{";
};

std::string TextOf(const IsoluxVertex& vertex) {
  return ObjectText()
      .Add("at", TextOf(vertex.at))
      .Add("across", TextOf(vertex.across))
      .Add("half_width", TextOf(vertex.half_width))
      .Add("certified", TextOf(vertex.is_certified))
      .Add("on", TextOf(Name(vertex.on)))
      .Ended();
}

std::string TextOf(const IsoluxContour& contour) {
  return ObjectText()
      .Add("level", TextOf(contour.level))
      .Add("face", std::to_string(contour.face))
      .Add("closed", TextOf(contour.is_closed))
      .Add("vertices", ListText(contour.vertices))
      .Add("widths", ListText(contour.widths))
      .Ended();
}

std::string TextOf(const OpenTriangle& open) {
  return ObjectText()
      .Add("corners", ListText(open.corners))
      .Add("least", TextOf(open.least))
      .Add("most", TextOf(open.most))
      .Ended();
}

std::string TextOf(const Diagnostic& note) {
  return TextOf(std::string_view(note.message));
}

/// Edges by the numbers of their vertices in the scene's file; null where faces
/// pierce each other.
std::string EdgesText(const SurfaceLine& line, const PlanSubject& subject) {
  std::string text = "[";
  for (const std::array<int, 2>& edge : line.edges) {
    if (text.size() > 1) text += ',';
    if (edge[0] < 0 || edge[1] < 0) {
      text += "null";
      continue;
    }
    std::array<int, 2> numbers{};
    for (std::size_t k = 0; k < 2; ++k)
      numbers[k] = subject.vertex_numbers[static_cast<std::size_t>(edge[k])];
    text += ListText(numbers);
  }
  return text + "]";
}

std::string LineText(const SurfaceLine& line, const PlanSubject& subject) {
  ObjectText text;
  text.Add("kind", TextOf(Name(line.kind)))
      .Add("ends", ListText(line.ends))
      .Add("faces", ListText(line.faces));
  if (line.kind == SurfaceLineKind::kJump) {
    text.Add("left", ListText(line.left)).Add("right", ListText(line.right));
  } else {
    text.Add("edges", EdgesText(line, subject)).Add("b", ListText(line.size));
  }
  return text.Ended();
}

/// An object with one member a line, and one element of an array a line.
class FileText {
 public:
  void Add(const char* key, const std::string& value) {
    text_ +=
        (is_first_ ? "\n  \"" : ",\n  \"") + std::string(key) + "\": " + value;
    is_first_ = false;
  }

  template <class List, class Write>
  void AddList(const char* key, const List& list, const Write& write) {
    Add(key, "[");
    bool is_first = true;
    for (const auto& element : list) {
      text_ += (is_first ? "\n    " : ",\n    ") + write(element);
      is_first = false;
    }
    text_ += is_first ? "]" : "\n  ]";
  }

  [[nodiscard]] std::string Ended() const { return text_ + "\n}\n"; }

 private:
  std::string text_ = "{";
  bool is_first_ = true;
};

}  // namespace

std::string PlanJson(const Isolux& isolux, const PlanSubject& subject) {
  FileText text;
  text.Add("version", TextOf(VersionText()));
  text.Add("scene", TextOf(std::string_view(subject.scene)));
  text.Add("surface", TextOf(std::string_view(subject.surface)));
  text.Add("channel", TextOf(std::string_view(subject.channel)));
  text.Add("method", TextOf(Name(subject.options.method)));
  text.Add("emission", TextOf(Name(subject.options.emission)));
  text.Add("size", TextOf(isolux.size));
  text.Add("area", TextOf(isolux.area));
  text.Add("open_area", TextOf(isolux.open_area));
  text.Add("dark_area", TextOf(isolux.dark_area));
  text.Add("least", TextOf(isolux.least));
  text.Add("most", TextOf(isolux.most));
  text.Add("search_evaluations", TextOf(isolux.search_evaluations));
  text.Add("line_evaluations", TextOf(isolux.line_evaluations));
  text.Add("triangles", TextOf(std::uint64_t{isolux.triangles}));
  text.Add("right", TextOf(isolux.right));
  text.Add("up", TextOf(isolux.up));
  text.Add("levels", ListText(isolux.levels));
  text.AddList("notes", isolux.lines.notes,
               [](const Diagnostic& note) { return TextOf(note); });
  text.AddList("outline", isolux.outline,
               [](const auto& side) { return ListText(side); });
  text.AddList("contours", isolux.contours,
               [](const IsoluxContour& contour) { return TextOf(contour); });
  text.Add("lines_complete", TextOf(isolux.lines.is_complete));
  text.AddList("lines", isolux.lines.lines, [&](const SurfaceLine& line) {
    return LineText(line, subject);
  });
  text.AddList("open", isolux.open,
               [](const OpenTriangle& open) { return TextOf(open); });
  return text.Ended();
}

}  // namespace truelux
