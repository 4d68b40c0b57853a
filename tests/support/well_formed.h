// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a text is well-formed XML, as far as this program writes it.

#ifndef TRUELUX_TESTS_SUPPORT_WELL_FORMED_H_
#define TRUELUX_TESTS_SUPPORT_WELL_FORMED_H_

#include <cstddef>
#include <regex>
#include <string>
#include <vector>

namespace truelux::testing {

/// What is wrong with the markup, or "": every tag closed in order, attributes
/// in double quotes and each once, no bare < or &, no entities but those of
/// XML, one root. A document type may come first.
inline std::string MarkupDefect(const std::string& text) {
  static const std::regex tag(
      R"(<(/?)([A-Za-z][\w:-]*)((?:\s+[\w:-]+="[^"<]*")*)\s*(/?)>)");
  static const std::regex attribute(R"(([\w:-]+)=)");
  static const std::regex bare(R"(&(?!(amp|lt|gt|quot|#\d+);))");
  std::size_t at = 0;
  if (text.starts_with("<!DOCTYPE html>") || text.starts_with("<?xml"))
    at = text.find('>') + 1;
  std::vector<std::string> open;
  std::size_t roots = 0;
  for (;;) {
    const std::size_t next = text.find('<', at);
    const std::string between = text.substr(at, next - at);
    if (std::regex_search(between, bare)) return "bare & in " + between;
    if (open.empty() && between.find_first_not_of(" \n") != between.npos)
      return "text outside: " + between;
    if (next == text.npos) break;
    std::smatch found;
    const std::size_t end = text.find('>', next);
    if (end == text.npos) return "< without >";
    const std::string whole = text.substr(next, end + 1 - next);
    if (!std::regex_match(whole, found, tag)) return "no tag: " + whole;
    if (std::regex_search(whole, bare)) return "bare & in " + whole;
    const std::string attributes = found[3];
    std::vector<std::string> names;
    for (std::sregex_iterator i(attributes.begin(), attributes.end(),
                                attribute);
         i != std::sregex_iterator(); ++i) {
      for (const std::string& name : names) {
        if (name == (*i)[1]) return "attribute twice: " + whole;
      }
      names.push_back((*i)[1]);
    }
    if (found[1] == "/") {
      if (open.empty() || open.back() != found[2]) return "not open: " + whole;
      open.pop_back();
    } else {
      if (open.empty()) ++roots;
      if (found[4] != "/") open.push_back(found[2]);
    }
    at = end + 1;
  }
  if (!open.empty()) return "never closed: " + open.back();
  return roots == 1 ? "" : "not one root";
}

/// How often `part` occurs.
inline std::size_t CountOf(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != text.npos;
       at = text.find(part, at + part.size()))
    ++count;
  return count;
}

}  // namespace truelux::testing

#endif  // TRUELUX_TESTS_SUPPORT_WELL_FORMED_H_
