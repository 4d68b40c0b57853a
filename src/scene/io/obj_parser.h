// SPDX-License-Identifier: GPL-3.0-or-later
// An OBJ text as arrays, before materials are looked up and polygons checked.

#ifndef TRUELUX_SCENE_IO_OBJ_PARSER_H_
#define TRUELUX_SCENE_IO_OBJ_PARSER_H_

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "truelux/geometry.h"

#include "scene/diagnostic_list.h"

namespace truelux {

/// One f statement.
struct ObjFace {
  std::size_t first_corner = 0;  ///< into ObjContents::corners
  int corner_count = 0;
  int line = 0;
  int material = -1;   ///< into ObjContents::materials; -1: no usemtl so far
  int group = 0;       ///< into ObjContents::groups
  bool usable = true;  ///< false if a defect of it was reported
};

/// A usemtl or mtllib statement.
struct ObjReference {
  std::string name;  ///< the rest of the line
  int line = 0;
};

struct ObjContents {
  std::vector<Point3> positions;  ///< NaN where a defect was reported
  std::vector<int> corners;       ///< into positions; in range if usable
  std::vector<ObjFace> faces;
  std::vector<ObjReference> materials;
  std::vector<ObjReference> libraries;
  std::vector<std::string> groups{""};  ///< "object/group"; may repeat
};

/// Defects, and one note for each kind of statement that is ignored, go to
/// diagnostics.
ObjContents ParseObj(std::string_view text, DiagnosticList& diagnostics);

}  // namespace truelux

#endif  // TRUELUX_SCENE_IO_OBJ_PARSER_H_
