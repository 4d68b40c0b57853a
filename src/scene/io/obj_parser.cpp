// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/io/obj_parser.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/io/face_index.h"
#include "scene/io/statement.h"

namespace truelux {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

class ObjParser {
 public:
  explicit ObjParser(DiagnosticList& diagnostics) : diagnostics_(diagnostics) {}

  ObjContents Parse(std::string_view text) {
    StatementReader reader(text);
    while (const std::optional<Statement> statement = reader.Next()) {
      Take(*statement);
    }
    CheckForwardIndices();
    return std::move(contents_);
  }

 private:
  /// A positive index beyond what had been read at its line.
  struct ForwardIndex {
    IndexKind kind = IndexKind::kVertex;
    std::int64_t index = 0;
    std::size_t face = 0;
  };

  void Take(const Statement& statement) {
    const std::string_view keyword = statement.keyword;
    if (keyword == "v") {
      TakeVertex(statement);
    } else if (keyword == "f") {
      TakeFace(statement);
    } else if (keyword == "vn") {
      TakeIgnoredNumbers(statement, IndexKind::kNormal, 3, 3);
    } else if (keyword == "vt") {
      TakeIgnoredNumbers(statement, IndexKind::kTexture, 1, 3);
    } else if (keyword == "usemtl") {
      TakeReference(statement, contents_.materials);
    } else if (keyword == "mtllib") {
      TakeReference(statement, contents_.libraries);
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
    const std::optional<Numbers> numbers =
        ReadNumbers(statement.rest, statement.line, diagnostics_);
    if (numbers) {
      const std::size_t count = numbers->count;
      if (count == 3 || count == 4 || count == 6) {
        position = {numbers->values[0], numbers->values[1], numbers->values[2]};
      } else {
        diagnostics_.Error(statement.line,
                           "missing or surplus coordinates: v has " +
                               std::to_string(count) +
                               " numbers, expected 3, 4 or 6");
      }
    }
    contents_.positions.push_back(position);
    ++CountOf(IndexKind::kVertex);
  }

  void TakeIgnoredNumbers(const Statement& statement, IndexKind kind,
                          std::size_t least, std::size_t most) {
    const std::optional<Numbers> numbers =
        ReadNumbers(statement.rest, statement.line, diagnostics_);
    if (numbers && (numbers->count < least || numbers->count > most)) {
      const std::string range =
          (least < most ? std::to_string(least) + " to " : "") +
          std::to_string(most);
      diagnostics_.Error(
          statement.line,
          "missing or surplus coordinates: " + std::string(statement.keyword) +
              " has " + std::to_string(numbers->count) + " numbers, expected " +
              range);
    }
    ++CountOf(kind);
  }

  void TakeFace(const Statement& statement) {
    ObjFace face;
    face.first_corner = contents_.corners.size();
    face.line = statement.line;
    face.material = static_cast<int>(contents_.materials.size()) - 1;
    face.group = static_cast<int>(contents_.groups.size()) - 1;
    contents_.faces.push_back(face);
    std::string_view rest = statement.rest;
    while (!rest.empty())
      TakeCorner(TakeWord(rest));
    contents_.faces.back().corner_count =
        static_cast<int>(contents_.corners.size() - face.first_corner);
  }

  void TakeCorner(std::string_view word) {
    ObjFace& face = contents_.faces.back();
    const std::optional<CornerIndices> corner = ParseCorner(word);
    if (!corner) {
      face.usable = false;
      diagnostics_.Error(face.line, Quoted(word) +
                                        " is no vertex of a face, expected "
                                        "integers as v, v/vt, v//vn or "
                                        "v/vt/vn");
      return;
    }
    for (const IndexKind kind : kIndexKinds) {
      const auto& index = (*corner)[static_cast<std::size_t>(kind)];
      if (index) TakeIndex(kind, *index);
    }
  }

  void TakeIndex(IndexKind kind, std::int64_t index) {
    ObjFace& face = contents_.faces.back();
    const std::int64_t count = CountOf(kind);
    if (index == 0 || index < -count) {
      face.usable = false;
      diagnostics_.Error(face.line, OutOfRange(kind, index, count));
      return;
    }
    if (index > count) {
      forward_.push_back({kind, index, contents_.faces.size() - 1});
    }
    if (kind != IndexKind::kVertex) return;
    const std::int64_t position = index > 0 ? index - 1 : count + index;
    contents_.corners.push_back(static_cast<int>(
        std::min<std::int64_t>(position, std::numeric_limits<int>::max())));
  }

  static std::string OutOfRange(IndexKind kind, std::int64_t index,
                                std::int64_t count) {
    // A number that no index can be is not printed as another one.
    using Limits = std::numeric_limits<std::int64_t>;
    const bool is_huge = index == Limits::max() || index == Limits::min();
    std::string what = std::string(NameOf(kind)) + " index";
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
      face.usable = false;
      diagnostics_.Error(face.line,
                         OutOfRange(forward.kind, forward.index, count));
    }
  }

  void TakeReference(const Statement& statement,
                     std::vector<ObjReference>& references) {
    if (statement.rest.empty()) {
      diagnostics_.Error(statement.line,
                         std::string(statement.keyword) + " without a name");
      return;
    }
    references.push_back({std::string(statement.rest), statement.line});
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

  DiagnosticList& diagnostics_;
  ObjContents contents_;
  std::array<std::int64_t, 3> counts_{};
  std::vector<ForwardIndex> forward_;
  std::string object_;
  std::string group_;
  std::set<std::string, std::less<>> noted_;
};

}  // namespace

ObjContents ParseObj(std::string_view text, DiagnosticList& diagnostics) {
  return ObjParser(diagnostics).Parse(text);
}

}  // namespace truelux
