// SPDX-License-Identifier: GPL-3.0-or-later
// The materials of a scene's MTL files.

#ifndef TRUELUX_SCENE_IO_MATERIAL_LIBRARY_H_
#define TRUELUX_SCENE_IO_MATERIAL_LIBRARY_H_

#include <string>
#include <string_view>
#include <unordered_map>

#include "truelux/geometry.h"

#include "scene/diagnostic_list.h"
#include "scene/io/statement.h"

namespace truelux {

/// A material as far as light is concerned.
struct Material {
  Rgb emission{};     ///< Ke
  std::string place;  ///< "file:line" of its newmtl
};

class MaterialLibrary {
 public:
  /// Adds the materials of an MTL text; defects go to the list of its file.
  void Read(std::string_view text, DiagnosticList& diagnostics);

  /// Null if there is none of that name.
  [[nodiscard]] const Material* Find(std::string_view name) const;

 private:
  Material* NewMaterial(const Statement& statement,
                        DiagnosticList& diagnostics);

  std::unordered_map<std::string, Material> materials_;
};

}  // namespace truelux

#endif  // TRUELUX_SCENE_IO_MATERIAL_LIBRARY_H_
