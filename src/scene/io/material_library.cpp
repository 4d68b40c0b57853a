// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/io/material_library.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

namespace truelux {
namespace {

/// Ke's three numbers, or nothing after reporting why.
std::optional<Rgb> ReadEmission(const Statement& statement,
                                DiagnosticList& diagnostics) {
  const std::optional<Numbers> numbers =
      ReadNumbers(statement.rest, statement.line, diagnostics);
  if (!numbers) return std::nullopt;
  if (numbers->count != 3) {
    diagnostics.Error(
        statement.line,
        "Ke has " + std::to_string(numbers->count) + " numbers, expected 3");
    return std::nullopt;
  }
  const Rgb emission{numbers->values[0], numbers->values[1],
                     numbers->values[2]};
  if (std::ranges::any_of(emission, [](double e) { return e < 0; })) {
    diagnostics.Error(statement.line, "Ke is negative, expected numbers >= 0");
    return std::nullopt;
  }
  return emission;
}

}  // namespace

void MaterialLibrary::Read(std::string_view text, DiagnosticList& diagnostics) {
  StatementReader reader(text);
  Material ignored;
  Material* current = nullptr;
  bool noted_map = false;
  while (const std::optional<Statement> statement = reader.Next()) {
    if (statement->keyword == "newmtl") {
      current = NewMaterial(*statement, diagnostics);
      if (current == nullptr) current = &ignored;
    } else if (statement->keyword == "Ke") {
      if (current == nullptr) {
        diagnostics.Error(statement->line, "Ke before any newmtl");
        continue;
      }
      const auto emission = ReadEmission(*statement, diagnostics);
      if (emission) current->emission = *emission;
    } else if (statement->keyword == "map_Ke" && !noted_map) {
      noted_map = true;
      diagnostics.Note(statement->line,
                       "map_Ke is ignored, a face emits its Ke everywhere");
    }
  }
}

/// Null after reporting a defect.
Material* MaterialLibrary::NewMaterial(const Statement& statement,
                                       DiagnosticList& diagnostics) {
  if (statement.rest.empty()) {
    diagnostics.Error(statement.line, "newmtl without a name");
    return nullptr;
  }
  const auto [entry, is_new] =
      materials_.try_emplace(std::string(statement.rest));
  if (!is_new) {
    diagnostics.Error(statement.line, "material " + Quoted(statement.rest) +
                                          " is already defined at " +
                                          entry->second.place);
    return nullptr;
  }
  entry->second.place =
      diagnostics.file() + ":" + std::to_string(statement.line);
  return &entry->second;
}

const Material* MaterialLibrary::Find(std::string_view name) const {
  const auto found = materials_.find(std::string(name));
  return found == materials_.end() ? nullptr : &found->second;
}

}  // namespace truelux
