// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/diagnostic_list.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace truelux {
namespace {

void SortByLine(std::vector<Diagnostic>& diagnostics) {
  std::ranges::stable_sort(diagnostics, {}, &Diagnostic::line);
}

}  // namespace

DiagnosticList::DiagnosticList(std::string file) : file_(std::move(file)) {}

void DiagnosticList::Error(int line, std::string message) {
  Add({Severity::kError, file_, line, std::move(message)});
}

void DiagnosticList::Note(int line, std::string message) {
  Add({Severity::kNote, file_, line, std::move(message)});
}

void DiagnosticList::Add(Diagnostic diagnostic) {
  Kept& kept = diagnostic.severity == Severity::kError ? errors_ : notes_;
  Keep(kept, std::move(diagnostic));
}

void DiagnosticList::CountError(int line, std::string_view what) {
  Count(Severity::kError, line, what);
}

void DiagnosticList::CountNote(int line, std::string_view what) {
  Count(Severity::kNote, line, what);
}

void DiagnosticList::Count(Severity severity, int line, std::string_view what) {
  const auto found = std::ranges::find_if(counted_, [&](const Counted& c) {
    return c.first.severity == severity && c.first.message == what;
  });
  if (found == counted_.end()) {
    counted_.push_back({{severity, file_, line, std::string(what)}, 1});
    return;
  }
  found->first.line = std::min(found->first.line, line);
  ++found->count;
}

bool DiagnosticList::has_errors() const {
  return errors_.total > 0 ||
         std::ranges::any_of(counted_, [](const Counted& counted) {
           return counted.first.severity == Severity::kError;
         });
}

/// Lets the list grow to twice the limit before cutting it, so that millions
/// of defects cost neither memory nor a sort each.
void DiagnosticList::Keep(Kept& kept, Diagnostic diagnostic) {
  ++kept.total;
  kept.first.push_back(std::move(diagnostic));
  if (kept.first.size() < 2 * kLimit) return;
  SortByLine(kept.first);
  kept.first.resize(kLimit);
}

std::vector<Diagnostic> DiagnosticList::Sorted() const {
  std::vector<Diagnostic> all;
  std::vector<Diagnostic> endings;
  const auto append = [&](const Kept& kept, Severity severity,
                          const std::string& what) {
    std::vector<Diagnostic> first = kept.first;
    SortByLine(first);
    if (first.size() > kLimit) first.resize(kLimit);
    if (first.size() < kept.total) {
      const std::size_t more = kept.total - first.size();
      endings.push_back(
          {severity, file_, 0,
           std::to_string(more) + " more " + what + " not shown"});
    }
    all.insert(all.end(), first.begin(), first.end());
  };
  for (const Counted& counted : counted_) {
    all.push_back(counted.first);
    if (counted.count > 1) {
      all.back().message +=
          " (and " + std::to_string(counted.count - 1) + " more such lines)";
    }
  }
  append(errors_, Severity::kError, "errors");
  append(notes_, Severity::kNote, "notes");
  SortByLine(all);
  all.insert(all.end(), endings.begin(), endings.end());
  return all;
}

std::string FirstTen(std::size_t count,
                     const std::function<std::string(std::size_t)>& name) {
  constexpr std::size_t kMost = 10;
  std::string text;
  for (std::size_t i = 0; i < std::min(count, kMost); ++i)
    text += (i > 0 ? ", " : "") + name(i);
  if (count > kMost) text += " and " + std::to_string(count - kMost) + " more";
  return text;
}

}  // namespace truelux
