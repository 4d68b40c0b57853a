// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/part_rows.h"

#include <cstdlib>
#include <fmt/format.h>
#include <sstream>

namespace truelux {
namespace {

/// All numbers, with blanks between; the distance in hexadecimal, so that it
/// reads back to the same number.
std::string NoteOf(const EvaluationCounts& c) {
  return fmt::format("{} {} {} {} {} {} {} {} {:a}", c.receivers, c.lit,
                     c.overflowing, c.unanswered, c.behind_faces,
                     c.faces.searched, c.faces.found, c.faces.unsure,
                     c.faces.farthest);
}

EvaluationCounts CountsOf(const std::string& note) {
  EvaluationCounts c;
  std::istringstream words(note);
  std::string farthest;
  words >> c.receivers >> c.lit >> c.overflowing >> c.unanswered >>
      c.behind_faces >> c.faces.searched >> c.faces.found >> c.faces.unsure >>
      farthest;
  c.faces.farthest = std::strtod(farthest.c_str(), nullptr);
  return c;
}

}  // namespace

PartRows::PartRows(const std::string& path, const std::string& key)
    : file_(path, key,
            [this](const std::string& note) { counts_ += CountsOf(note); }) {}

std::optional<EvaluationCounts> PartRows::done() const {
  if (file_.empty()) return std::nullopt;
  return counts_;
}

void PartRows::Take(std::string_view rows, const EvaluationCounts& counts) {
  file_.Append(rows, NoteOf(counts));
  counts_ += counts;
}

void PartRows::CopyTo(OutputFile& output) const {
  file_.ForEach([&output](std::string_view rows) { output.Write(rows); });
}

}  // namespace truelux
