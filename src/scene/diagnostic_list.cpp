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
  const bool is_error = diagnostic.severity == Severity::kError;
  has_errors_ = has_errors_ || is_error;
  Keep(is_error ? errors_ : notes_, std::move(diagnostic));
}

void DiagnosticList::CountError(int line, std::string_view what) {
  has_errors_ = true;
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

}  // namespace truelux
