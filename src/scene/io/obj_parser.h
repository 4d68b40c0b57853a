// SPDX-License-Identifier: GPL-3.0-or-later
// An OBJ text as arrays, before materials are looked up and polygons checked.

#ifndef TRUELUX_SCENE_IO_OBJ_PARSER_H_
#define TRUELUX_SCENE_IO_OBJ_PARSER_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "truelux/geometry.h"
#include "truelux/io.h"

#include "scene/diagnostic_list.h"

namespace truelux {

/// Why a face cannot be taken.
enum class FaceDefect : std::uint8_t {
  kNone,
  kNoIndex,     ///< "a vertex that is no integer": of a corner
  kOutOfRange,  ///< "a vertex that does not exist"
  kNoPosition,  ///< "a vertex whose coordinates are no numbers"
};

/// The words in quotes above.
std::string_view Name(FaceDefect defect);

/// One f statement.
struct ObjFace {
  std::size_t first_corner = 0;  ///< into ObjContents::corners
  int corner_count = 0;
  int line = 0;
  int material = -1;  ///< into ObjContents::materials; -1: no usemtl so far
  int group = 0;      ///< into ObjContents::groups
  FaceDefect defect = FaceDefect::kNone;
};

/// A usemtl or mtllib statement.
struct ObjReference {
  std::string name;  ///< the rest of the line; usemtl: "" is no material
  int line = 0;
};

struct ObjContents {
  std::vector<Point3> positions;  ///< NaN where there is a defect
  std::vector<int> corners;       ///< into positions; in range if no defect
  std::vector<ObjFace> faces;
  std::vector<ObjReference> materials;
  std::vector<ObjReference> libraries;
  std::vector<std::string> groups{""};  ///< "object/group"; may repeat
};

/// Defects, and one note for each kind of statement or data that is ignored, go
/// to diagnostics. lenient: defects of faces, and of the vertices that faces
/// use, are no errors; the faces have them in ObjFace::defect only.
ObjContents ParseObj(std::string_view text, const ReadOptions& options,
                     DiagnosticList& diagnostics);

}  // namespace truelux

#endif  // TRUELUX_SCENE_IO_OBJ_PARSER_H_
