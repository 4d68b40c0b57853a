// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/io/obj_parser.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/stop.h"
#include "scene/io/face_index.h"
#include "scene/io/number_defect.h"
#include "scene/io/quoted.h"
#include "scene/io/statement.h"

namespace truelux {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// The text of the note about data that nobody uses.
constexpr std::string_view kUnusedData =
    "data that truelux does not use (vn, vt, vp, indices of them, what follows "
    "x y z) is not as OBJ asks for";

/// What ends the text of an error about a face.
constexpr std::string_view kCure = " (--lenient leaves such faces out)";

class ObjParser {
 public:
  ObjParser(const ReadOptions& options, DiagnosticList& diagnostics)
      : lenient_(options.lenient),
        stop_(options.stop),
        diagnostics_(diagnostics) {}

  ObjContents Parse(std::string_view text) {
    StatementReader reader(text);
    while (const std::optional<Statement> statement = reader.Next()) {
      StopIfAsked(stop_);
      Take(*statement);
    }
    CheckForwardIndices();
    CheckVertices();
    return std::move(contents_);
  }

 private:
  /// A positive index beyond what had been read at its line.
  struct ForwardIndex {
    IndexKind kind = IndexKind::kVertex;
    std::int64_t index = 0;
    std::size_t face = 0;
  };

  /// A vertex without a position. It is an error only if a face uses it.
  struct VertexDefect {
    int vertex = 0;
    int line = 0;
    NumberDefect what;
  };

  void Take(const Statement& statement) {
    const std::string_view keyword = statement.keyword;
    if (keyword == "v") {
      TakeVertex(statement);
    } else if (keyword == "f") {
      TakeFace(statement);
    } else if (keyword == "vn") {
      TakeUnused(statement, 3, 3);
      ++CountOf(IndexKind::kNormal);
    } else if (keyword == "vt") {
      TakeUnused(statement, 1, 3);
      ++CountOf(IndexKind::kTexture);
    } else if (keyword == "vp") {
      TakeUnused(statement, 1, 3);
    } else if (keyword == "usemtl") {
      TakeMaterial(statement);
    } else if (keyword == "mtllib") {
      TakeLibrary(statement);
    } else if (keyword == "o") {
      object_ = statement.rest;
      NameGroup();
    } else if (keyword == "g") {
      group_ = statement.rest;
      NameGroup();
    } else if (keyword != "s") {
      TakeUnknown(statement);
    }
  }

  void TakeVertex(const Statement& statement) {
    Point3 position{kNan, kNan, kNan};
    const Numbers numbers = ReadNumbers(statement.rest);
    const std::size_t count = numbers.count;
    if (count >= 3) {
      position = {numbers.values[0], numbers.values[1], numbers.values[2]};
      if (!numbers.defect.empty() || count == 5 || count > 6) {
        diagnostics_.CountNote(statement.line, kUnusedData);
      } else if (count == 4 && numbers.values[3] != 1) {
        diagnostics_.CountNote(
            statement.line, "the weight w of a vertex is not 1 and is ignored");
      }
    } else {
      NumberDefect what =
          numbers.defect.empty()
              ? NumberDefect{"missing coordinates: v has " +
                                 std::to_string(count) + " numbers, expected 3",
                             false}
              : DefectOfNumber(numbers.defect);
      vertex_defects_.push_back({static_cast<int>(contents_.positions.size()),
                                 statement.line, std::move(what)});
    }
    contents_.positions.push_back(position);
    ++CountOf(IndexKind::kVertex);
  }

  void TakeUnused(const Statement& statement, std::size_t least,
                  std::size_t most) {
    const Numbers numbers = ReadNumbers(statement.rest);
    if (!numbers.defect.empty() || numbers.count < least ||
        numbers.count > most) {
      diagnostics_.CountNote(statement.line, kUnusedData);
    }
  }

  void TakeFace(const Statement& statement) {
    ObjFace face;
    face.first_corner = contents_.corners.size();
    face.line = statement.line;
    face.material = static_cast<int>(contents_.materials.size()) - 1;
    face.group = static_cast<int>(contents_.groups.size()) - 1;
    contents_.faces.push_back(face);
    bool unused_is_odd = false;
    std::string_view rest = statement.rest;
    while (!rest.empty() && contents_.faces.back().defect == FaceDefect::kNone)
      unused_is_odd = !TakeCorner(TakeWord(rest)) || unused_is_odd;
    if (unused_is_odd) NoteUnused(contents_.faces.size() - 1);
    contents_.faces.back().corner_count =
        static_cast<int>(contents_.corners.size() - face.first_corner);
  }

  /// Whether the corner's texture and normal are as they should be.
  bool TakeCorner(std::string_view word) {
    const std::optional<Corner> corner = ParseCorner(word);
    if (!corner) {
      ReportFace(contents_.faces.back(), FaceDefect::kNoIndex,
                 DefectOfCorner(word));
      return true;
    }
    TakeVertexIndex(corner->vertex);
    bool is_regular = corner->is_regular;
    for (const IndexKind kind : {IndexKind::kTexture, IndexKind::kNormal}) {
      const auto& index = corner->unused[static_cast<std::size_t>(kind)];
      if (index) is_regular = TakeUnusedIndex(kind, *index) && is_regular;
    }
    return is_regular;
  }

  void TakeVertexIndex(std::int64_t index) {
    const std::int64_t count = CountOf(IndexKind::kVertex);
    if (index == 0 || index < -count) {
      ReportFace(contents_.faces.back(), FaceDefect::kOutOfRange,
                 {OutOfRange(index, count), false});
      return;
    }
    if (index > count) {
      forward_.push_back(
          {IndexKind::kVertex, index, contents_.faces.size() - 1});
    }
    const std::int64_t position = index > 0 ? index - 1 : count + index;
    contents_.corners.push_back(static_cast<int>(
        std::min<std::int64_t>(position, std::numeric_limits<int>::max())));
  }

  /// Whether an index is in range so far as is known.
  bool TakeUnusedIndex(IndexKind kind, std::int64_t index) {
    const std::int64_t count = CountOf(kind);
    if (index > count) {
      forward_.push_back({kind, index, contents_.faces.size() - 1});
    }
    return index != 0 && index >= -count;
  }

  static std::string OutOfRange(std::int64_t index, std::int64_t count) {
    // A number that no index can be is not printed as another one.
    using Limits = std::numeric_limits<std::int64_t>;
    const bool is_huge = index == Limits::max() || index == Limits::min();
    std::string what = "vertex index";
    if (!is_huge) what.append(" ").append(std::to_string(index));
    if (index == 0) return what + ", expected 1 or more, or less than 0";
    if (index > 0) {
      return what + " is out of range, expected at most " +
             std::to_string(count) + " (all in the file)";
    }
    return what + " is out of range, expected at least " +
           std::to_string(-count) + " (all so far)";
  }

  void CheckForwardIndices() {
    for (const ForwardIndex& forward : forward_) {
      const std::int64_t count = CountOf(forward.kind);
      if (forward.index <= count) continue;
      ObjFace& face = contents_.faces[forward.face];
      if (forward.kind == IndexKind::kVertex) {
        ReportFace(face, FaceDefect::kOutOfRange,
                   {OutOfRange(forward.index, count), false});
      } else {
        NoteUnused(forward.face);
      }
    }
  }

  /// Notes a face whose texture or normals are odd; one line is one line.
  void NoteUnused(std::size_t face) {
    is_noted_.resize(contents_.faces.size());
    if (is_noted_[face]) return;
    is_noted_[face] = true;
    diagnostics_.CountNote(contents_.faces[face].line, kUnusedData);
  }

  /// Takes the first defect of a face; one line is told of each.
  void ReportFace(ObjFace& face, FaceDefect defect, NumberDefect what) {
    if (face.defect != FaceDefect::kNone) return;
    face.defect = defect;
    if (lenient_) return;
    what.text += kCure;
    what.Report(face.line, diagnostics_);
  }

  /// Finds which of the vertices without a position are used.
  void CheckVertices() {
    if (vertex_defects_.empty()) return;
    std::vector<bool> is_used(contents_.positions.size());
    for (ObjFace& face : contents_.faces) {
      if (face.defect != FaceDefect::kNone) continue;
      for (int i = 0; i < face.corner_count; ++i) {
        const auto vertex = static_cast<std::size_t>(
            contents_.corners[face.first_corner + static_cast<std::size_t>(i)]);
        if (!std::isnan(contents_.positions[vertex].x)) continue;
        is_used[vertex] = true;
        face.defect = FaceDefect::kNoPosition;
      }
    }
    for (VertexDefect& defect : vertex_defects_) {
      if (!is_used[static_cast<std::size_t>(defect.vertex)]) {
        diagnostics_.CountNote(defect.line,
                               "the coordinates of a vertex that no face uses "
                               "are no numbers");
      } else if (!lenient_) {
        defect.what.text += kCure;
        defect.what.Report(defect.line, diagnostics_);
      }
    }
  }

  void TakeMaterial(const Statement& statement) {
    if (statement.rest.empty()) {
      diagnostics_.CountNote(
          statement.line,
          "usemtl without a name: the faces that follow have no material and "
          "only block");
    }
    contents_.materials.push_back(
        {std::string(statement.rest), statement.line});
  }

  void TakeLibrary(const Statement& statement) {
    if (statement.rest.empty()) {
      diagnostics_.CountNote(statement.line,
                             "mtllib without a name is ignored");
      return;
    }
    contents_.libraries.push_back(
        {std::string(statement.rest), statement.line});
  }

  void NameGroup() {
    const bool both = !object_.empty() && !group_.empty();
    contents_.groups.push_back(object_ + (both ? "/" : "") + group_);
  }

  void TakeUnknown(const Statement& statement) {
    const bool is_new = noted_.emplace(statement.keyword).second;
    if (!is_new) return;
    diagnostics_.Note(statement.line, "statements " +
                                          Quoted(statement.keyword) +
                                          " are ignored, this is the first");
  }

  std::int64_t& CountOf(IndexKind kind) {
    return counts_[static_cast<std::size_t>(kind)];
  }

  bool lenient_;
  const StopFlag* stop_;
  DiagnosticList& diagnostics_;
  ObjContents contents_;
  std::array<std::int64_t, 3> counts_{};
  std::vector<ForwardIndex> forward_;
  std::vector<VertexDefect> vertex_defects_;
  std::vector<bool> is_noted_;  ///< per face, so far as there was a reason
  std::string object_;
  std::string group_;
  std::set<std::string, std::less<>> noted_;
};

}  // namespace

std::string_view Name(FaceDefect defect) {
  switch (defect) {
    case FaceDefect::kNoIndex:
      return "a vertex that is no integer";
    case FaceDefect::kOutOfRange:
      return "a vertex that does not exist";
    case FaceDefect::kNoPosition:
      return "a vertex whose coordinates are no numbers";
    case FaceDefect::kNone:
      break;
  }
  return "none";
}

ObjContents ParseObj(std::string_view text, const ReadOptions& options,
                     DiagnosticList& diagnostics) {
  return ObjParser(options, diagnostics).Parse(text);
}

}  // namespace truelux
