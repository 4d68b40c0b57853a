// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/face_choice.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "truelux/io.h"

#include "scene/group_selection.h"
#include "scene/io/quoted.h"
#include "text/csv.h"
#include "text/number_text.h"

namespace truelux {
namespace {

constexpr std::string_view kAuto = "auto";

}  // namespace

std::optional<FaceChoice> FaceWords::Parse(std::string_view text,
                                           std::string& defect) {
  const std::string word(TrimBlanks(text));
  if (word.empty()) return usual_;
  if (word == kAuto || word.starts_with("auto:"))
    return ParseAuto(word, defect);
  const std::optional<double> number = ParseNumber(word);
  if (!number || std::trunc(*number) != *number) {
    if (IsName(word)) return SearchOf(word, {word, {}});
    defect = fmt::format(
        "{} is not the number of a face, the name of an object or group, or "
        "auto",
        Quoted(word));
    return std::nullopt;
  }
  const auto count = static_cast<int>(scene_.faces().size());
  if (*number < 1 || *number > count) {
    defect = fmt::format("{} is out of range; the scene has {} {}",
                         Quoted(word), count, count == 1 ? "face" : "faces");
    return std::nullopt;
  }
  return FaceChoice{static_cast<int>(*number), nullptr};
}

std::optional<FaceChoice> FaceWords::ParseAuto(const std::string& word,
                                               std::string& defect) {
  if (word == kAuto) return SearchOf(word, {});
  const std::optional<double> limit =
      ParseNumber(word.substr(kAuto.size() + 1));
  if (limit && *limit >= 0) return SearchOf(word, {"", limit});
  defect = fmt::format(
      "{}: expected auto, or auto:D with a distance D from 0 upwards",
      Quoted(word));
  return std::nullopt;
}

/// Whether a word is the name of an object or a group.
bool FaceWords::IsName(const std::string& word) {
  {
    const std::lock_guard lock(mutex_);
    if (searches_.contains(word)) return true;
  }
  return !GroupsNamed(scene_, word).empty();
}

FaceChoice FaceWords::SearchOf(const std::string& word,
                               const FaceSearch& search) {
  const std::lock_guard lock(mutex_);
  return {0, &searches_.try_emplace(word, search).first->second};
}

FoundFaces& FoundFaces::operator+=(const FoundFaces& other) {
  searched += other.searched;
  found += other.found;
  farthest = std::max(farthest, other.farthest);
  unsure += other.unsure;
  return *this;
}

void SetFace(const Scene& scene, const FaceChoice& choice, Receiver& receiver,
             FoundFaces& counts) {
  receiver.on_face = choice.number;
  if (choice.search == nullptr) return;
  const FaceSearch& search = *choice.search;
  const std::optional<NearFace> found =
      search.name.empty() ? scene.FaceNear(receiver, search.limit)
                          : scene.FaceNear(receiver, search.name);
  ++counts.searched;
  if (!found) return;
  receiver.on_face = found->number;
  ++counts.found;
  counts.farthest = std::max(counts.farthest, found->distance);
  if (found->has_second) ++counts.unsure;
}

std::string FoundFacesText(const FoundFaces& counts) {
  if (counts.searched == 0) return "";
  constexpr int kDigits = 2;
  std::string text = fmt::format("{} of {} receivers lie on a face",
                                 counts.found, counts.searched);
  if (counts.found > 0) {
    text += fmt::format(", at most {} away",
                        ScientificText(counts.farthest, kDigits));
  }
  if (counts.unsure > 0) {
    text += fmt::format("; {} of them {} near to a second face, too",
                        counts.unsure, counts.unsure == 1 ? "is" : "are");
  }
  return text;
}

std::string BehindFacesText(std::uint64_t dark, std::uint64_t receivers) {
  if (dark == 0) return "";
  return fmt::format(
      "{} of {} receivers {} 0 and {} behind a face, no farther than rounding "
      "moves a point; --on-face auto takes {} as lying on it",
      dark, receivers, dark == 1 ? "gets" : "get", dark == 1 ? "lies" : "lie",
      dark == 1 ? "it" : "them");
}

}  // namespace truelux
