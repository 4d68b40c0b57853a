// SPDX-License-Identifier: GPL-3.0-or-later
// What the materials of an OBJ make of its faces.

#ifndef TRUELUX_SCENE_IO_FACE_MATERIAL_H_
#define TRUELUX_SCENE_IO_FACE_MATERIAL_H_

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "truelux/geometry.h"
#include "truelux/io.h"

#include "scene/diagnostic_list.h"
#include "scene/io/material_library.h"
#include "scene/io/obj_parser.h"

namespace truelux {

/// What becomes of the faces behind one usemtl statement.
struct FaceMaterial {
  Rgb emission{};
  std::string left_out;  ///< the reason, if they are left out
};

/// Looks the materials of an OBJ up, and tells which are missing and which are
/// taken as opaque.
class MaterialResolver {
 public:
  /// What the arguments refer to must outlive the object.
  MaterialResolver(const ObjContents& obj, const MaterialLibrary& library,
                   const ReadOptions& options, DiagnosticList& diagnostics);

  /// Whether a face without defect has a material.
  [[nodiscard]] bool IsUsed(const std::string& name) const {
    return used_.contains(name);
  }

  /// One entry per usemtl statement of the OBJ.
  std::vector<FaceMaterial> Resolve();

 private:
  [[nodiscard]] FaceMaterial Of(const std::string& name) const;
  [[nodiscard]] std::vector<std::pair<int, std::string>> UsedByLine() const;
  void ReportUnknown();
  void ReportOpaque();

  const ObjContents& obj_;
  const MaterialLibrary& library_;
  const ReadOptions& options_;
  DiagnosticList& diagnostics_;
  std::map<std::string, int> used_;  ///< with the line of its first usemtl
};

}  // namespace truelux

#endif  // TRUELUX_SCENE_IO_FACE_MATERIAL_H_
