// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/io/library_search.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/ascii_case.h"
#include "scene/io/statement.h"

namespace truelux {
namespace {

std::string Replaced(std::string_view text, char from, char to) {
  std::string result(text);
  std::ranges::replace(result, from, to);
  return result;
}

std::string Unquoted(std::string_view text) {
  const bool is_quoted = text.size() > 2 &&
                         (text.front() == '"' || text.front() == '\'') &&
                         text.back() == text.front();
  return std::string(is_quoted ? text.substr(1, text.size() - 2) : text);
}

/// With "\ " as a blank.
std::string Unescaped(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_escape = text.substr(i).starts_with("\\ ");
    if (!is_escape) result += text[i];
  }
  return result;
}

std::vector<std::string> SplitAtBlanks(std::string_view text) {
  std::vector<std::string> names;
  while (!text.empty())
    names.push_back(Unquoted(TakeWord(text)));
  return names;
}

/// Names with blanks inside, each of which ends in ".mtl".
std::vector<std::string> SplitAfterEndings(std::string_view text) {
  constexpr std::string_view kEnding = ".mtl";
  std::vector<std::string> names;
  const std::string lowered = LowerAscii(text);
  std::size_t begin = 0;
  while (begin < text.size()) {
    std::size_t end = lowered.find(std::string(kEnding) + ' ', begin);
    end = end == std::string::npos ? text.size() : end + kEnding.size();
    names.push_back(Unquoted(text.substr(begin, end - begin)));
    begin = text.find_first_not_of(' ', end);
  }
  return names;
}

}  // namespace

std::vector<std::vector<std::string>> LibraryReadings(std::string_view line) {
  std::vector<std::vector<std::string>> readings;
  const auto add = [&readings](std::vector<std::string> names) {
    if (std::ranges::find(readings, names) == readings.end()) {
      readings.push_back(std::move(names));
    }
  };
  add({std::string(line)});
  add({Unquoted(line)});
  add({Unescaped(line)});
  add(SplitAtBlanks(line));
  add(SplitAfterEndings(line));
  return readings;
}

std::vector<FoundLibrary> LibrarySearch::Find(
    std::string_view line, std::vector<std::string>& missing) {
  std::vector<FoundLibrary> best;
  missing = {std::string(line)};
  // A file of another folder is a last resort: the last component of a whole
  // line with several paths is a file, too, but not all of them.
  for (const Reach reach : {Reach::kNamed, Reach::kBeside}) {
    for (const std::vector<std::string>& names : LibraryReadings(line)) {
      std::vector<FoundLibrary> found;
      std::vector<std::string> absent;
      for (const std::string& name : names) {
        if (auto library = FindName(name, reach)) {
          found.push_back(std::move(*library));
        } else {
          absent.push_back(name);
        }
      }
      if (found.empty() || (!absent.empty() && !best.empty())) continue;
      best = std::move(found);
      missing = std::move(absent);
      if (missing.empty()) return best;
    }
  }
  return best;
}

/// A name as it is, with slashes for backslashes, and in another letter case;
/// with kBeside also its last component beside the OBJ. A file that can be read
/// goes before one that cannot.
std::optional<FoundLibrary> LibrarySearch::FindName(const std::string& name,
                                                    Reach reach) {
  const std::string with_slashes = Replaced(name, '\\', '/');
  const std::string last =
      with_slashes.substr(with_slashes.find_last_of('/') + 1);
  if (last.empty()) return std::nullopt;
  std::optional<FoundLibrary> unreadable;
  const auto try_path = [&](const std::filesystem::path& path,
                            bool is_literal) -> std::optional<FoundLibrary> {
    const TextFile::Status status = Open(path).status;
    if (status == TextFile::Status::kMissing) return std::nullopt;
    FoundLibrary found{name, path, is_literal};
    if (status == TextFile::Status::kRead) return found;
    if (!unreadable) unreadable = std::move(found);
    return std::nullopt;
  };
  if (auto found = try_path(folder_ / name, true)) return found;
  std::vector<std::string> guesses{with_slashes};
  if (reach == Reach::kBeside) guesses.push_back(last);
  for (const std::string& guess : guesses) {
    const std::filesystem::path path = (folder_ / guess).lexically_normal();
    if (auto found = try_path(path, false)) return found;
    if (const auto similar = InAnotherCase(guess)) {
      if (auto found = try_path(*similar, false)) return found;
    }
  }
  return unreadable;
}

/// The file whose path is a name but for the case of letters; the first of
/// several, by their bytes.
std::optional<std::filesystem::path> LibrarySearch::InAnotherCase(
    const std::string& name) {
  std::filesystem::path path = folder_;
  const std::filesystem::path relative(name);
  if (relative.is_absolute()) path.clear();
  for (const std::filesystem::path& part : relative) {
    if (part == "." || part == ".." || part == "/") {
      path /= part;
      continue;
    }
    const std::vector<std::string>& entries = NamesIn(path);
    const auto exact = std::ranges::find(entries, part.string());
    const auto entry =
        exact != entries.end()
            ? exact
            : std::ranges::find(entries, LowerAscii(part.string()), LowerAscii);
    if (entry == entries.end()) return std::nullopt;
    path /= *entry;
  }
  return path;
}

const std::vector<std::string>& LibrarySearch::NamesIn(
    const std::filesystem::path& folder) {
  const auto [entry, is_new] = listed_.try_emplace(folder);
  if (is_new) {
    entry->second = files_.list(folder);
    std::ranges::sort(entry->second);
  }
  return entry->second;
}

const TextFile& LibrarySearch::Open(const std::filesystem::path& path) {
  const auto opened = opened_.find(path);
  if (opened != opened_.end()) return opened->second;
  return opened_.emplace(path, files_.open(path)).first->second;
}

}  // namespace truelux
