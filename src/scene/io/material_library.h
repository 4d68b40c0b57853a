// SPDX-License-Identifier: GPL-3.0-or-later
// The materials of a scene's MTL files.

#ifndef TRUELUX_SCENE_IO_MATERIAL_LIBRARY_H_
#define TRUELUX_SCENE_IO_MATERIAL_LIBRARY_H_

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "truelux/geometry.h"

#include "scene/diagnostic_list.h"
#include "scene/io/number_defect.h"
#include "scene/io/statement.h"

namespace truelux {

/// A material as far as light is concerned.
struct Material {
  Rgb emission{};                 ///< Ke
  std::optional<double> opacity;  ///< d; 1 - Tr without d
  int illumination = 2;           ///< illum; 4, 6, 7 and 9 let light through
};

/// Collects materials first and judges them when it is known which are used:
/// a defect of one that is not used is a note.
class MaterialLibrary {
 public:
  /// Adds the materials of an MTL text. file_name: for diagnostics.
  void Read(std::string_view text, const std::string& file_name);

  /// Tells the defects of all materials. is_used(name): whether a face has it.
  void Report(const std::function<bool(const std::string&)>& is_used);

  /// The first one of that name; null if there is none.
  [[nodiscard]] const Material* Find(const std::string& name) const;

  /// What was told, file by file, in the order of Read.
  [[nodiscard]] const std::vector<DiagnosticList>& diagnostics() const {
    return diagnostics_;
  }

 private:
  struct Defect {
    int line = 0;
    NumberDefect what;
  };

  /// What stands between a newmtl and the next.
  struct Definition {
    Material material;
    std::size_t file = 0;  ///< index into diagnostics_
    int line = 0;          ///< of newmtl
    std::vector<Defect> defects;
  };

  Definition* Begin(const Statement& statement);
  void ReportDefects(const Definition& definition, bool is_used);
  void ReportRepetition(const std::string& name, const Definition& first,
                        const Definition& later, bool is_used);
  void ReportAs(const Definition& definition, const Defect& defect,
                bool is_used);

  static void Take(const Statement& statement, Definition& definition);
  static void TakeEmission(const Statement& statement, Definition& definition);

  std::vector<DiagnosticList> diagnostics_;
  std::vector<std::string> names_;  ///< in the order of their first newmtl
  std::unordered_map<std::string, std::vector<Definition>> materials_;
};

}  // namespace truelux

#endif  // TRUELUX_SCENE_IO_MATERIAL_LIBRARY_H_
