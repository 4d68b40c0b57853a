// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/io/material_library.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "scene/io/quoted.h"

namespace truelux {
namespace {

/// The last number of a statement that nobody asked to be right; nothing if it
/// is none. ("d -halo 0.5" ends in a number, too.)
std::optional<double> LastNumber(std::string_view rest) {
  std::string_view last;
  while (!rest.empty())
    last = TakeWord(rest);
  const Numbers number = ReadNumbers(last);
  if (number.count != 1) return std::nullopt;
  return number.values[0];
}

}  // namespace

void MaterialLibrary::Read(std::string_view text,
                           const std::string& file_name) {
  DiagnosticList& diagnostics = diagnostics_.emplace_back(file_name);
  StatementReader reader(text);
  Definition nameless;
  Definition* current = nullptr;
  bool noted_map = false;
  while (const std::optional<Statement> statement = reader.Next()) {
    if (statement->keyword == "newmtl") {
      current = Begin(*statement);
      if (current == nullptr) current = &nameless;
    } else if (statement->keyword == "map_Ke") {
      if (noted_map) continue;
      noted_map = true;
      diagnostics.Note(statement->line,
                       "map_Ke is ignored, a face emits its Ke everywhere");
    } else if (current != nullptr) {
      Take(*statement, *current);
    } else if (statement->keyword == "Ke") {
      diagnostics.CountNote(statement->line,
                            "Ke before any newmtl belongs to no material and "
                            "is ignored");
    }
  }
}

/// Null for a material without a name, which nobody can use. What is returned
/// is valid until the next Begin.
auto MaterialLibrary::Begin(const Statement& statement) -> Definition* {
  if (statement.rest.empty()) {
    diagnostics_.back().CountNote(
        statement.line, "newmtl without a name: nobody can use the material");
    return nullptr;
  }
  std::string name(statement.rest);
  std::vector<Definition>& definitions = materials_[name];
  if (definitions.empty()) names_.push_back(std::move(name));
  Definition& added = definitions.emplace_back();
  added.file = diagnostics_.size() - 1;
  added.line = statement.line;
  return &added;
}

void MaterialLibrary::Take(const Statement& statement, Definition& definition) {
  Material& material = definition.material;
  if (statement.keyword == "Ke") {
    TakeEmission(statement, definition);
  } else if (statement.keyword == "d") {
    if (const auto d = LastNumber(statement.rest)) material.opacity = d;
  } else if (statement.keyword == "Tr") {
    const auto transparency = LastNumber(statement.rest);
    if (transparency && !material.opacity) material.opacity = 1 - *transparency;
  } else if (statement.keyword == "illum") {
    const auto model = LastNumber(statement.rest);
    if (model && *model >= 0 && *model <= 10) {
      material.illumination = static_cast<int>(*model);
    }
  }
}

/// Ke r g b, or one number for all channels.
void MaterialLibrary::TakeEmission(const Statement& statement,
                                   Definition& definition) {
  const Numbers numbers = ReadNumbers(statement.rest);
  const auto refuse = [&](const NumberDefect& what) {
    definition.defects.push_back({statement.line, what});
  };
  if (numbers.defect == "spectral" || numbers.defect == "xyz") {
    refuse({"Ke " + std::string(numbers.defect) +
                " is not supported, expected Ke r g b",
            false});
    return;
  }
  if (!numbers.defect.empty()) {
    refuse(DefectOfNumber(numbers.defect));
    return;
  }
  if (numbers.count != 1 && numbers.count != 3) {
    refuse({"Ke has " + std::to_string(numbers.count) +
                " numbers, expected 3, or 1 for all channels",
            false});
    return;
  }
  const std::size_t last = numbers.count - 1;
  const Rgb emission{numbers.values[0], numbers.values[last / 2],
                     numbers.values[last]};
  if (std::ranges::any_of(emission, [](double e) { return e < 0; })) {
    refuse({"Ke is negative, expected numbers >= 0", false});
    return;
  }
  definition.material.emission = emission;
}

void MaterialLibrary::Report(
    const std::function<bool(const std::string&)>& is_used) {
  for (const std::string& name : names_) {
    const std::vector<Definition>& definitions = materials_.at(name);
    const bool used = is_used(name);
    for (const Definition& definition : definitions) {
      ReportDefects(definition, used);
      if (&definition != &definitions.front()) {
        ReportRepetition(name, definitions.front(), definition, used);
      }
    }
  }
}

void MaterialLibrary::ReportDefects(const Definition& definition,
                                    bool is_used) {
  for (const Defect& defect : definition.defects)
    ReportAs(definition, defect, is_used);
}

/// The same name again: harmless if it is the same light, and if it is none.
void MaterialLibrary::ReportRepetition(const std::string& name,
                                       const Definition& first,
                                       const Definition& later, bool is_used) {
  if (first.material.emission == later.material.emission) {
    diagnostics_[later.file].CountNote(
        later.line,
        "a material that is defined already is defined again, with the same "
        "Ke");
    return;
  }
  const std::string place =
      diagnostics_[first.file].file() + ":" + std::to_string(first.line);
  ReportAs(later,
           {later.line,
            {"material " + Quoted(name) + " is already defined at " + place +
                 " with another Ke, expected one definition",
             false}},
           is_used);
}

/// An error of a material that is used; else a note.
void MaterialLibrary::ReportAs(const Definition& definition,
                               const Defect& defect, bool is_used) {
  DiagnosticList& diagnostics = diagnostics_[definition.file];
  if (is_used) {
    defect.what.Report(defect.line, diagnostics);
  } else {
    diagnostics.Note(defect.line,
                     defect.what.text + " (of a material that no face uses)");
  }
}

const Material* MaterialLibrary::Find(const std::string& name) const {
  const auto found = materials_.find(name);
  return found == materials_.end() ? nullptr : &found->second.front().material;
}

}  // namespace truelux
