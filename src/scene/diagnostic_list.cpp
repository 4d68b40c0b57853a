// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/diagnostic_list.h"

#include <algorithm>
#include <cstddef>
#include <string>
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
  append(errors_, Severity::kError, "errors");
  append(notes_, Severity::kNote, "notes");
  SortByLine(all);
  all.insert(all.end(), endings.begin(), endings.end());
  return all;
}

}  // namespace truelux
