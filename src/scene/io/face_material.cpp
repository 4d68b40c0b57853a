// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/io/face_material.h"

#include <algorithm>
#include <cstddef>

#include "scene/io/quoted.h"

namespace truelux {
namespace {

bool Emits(const Material& material) {
  return material.emission != Rgb{};
}

/// Why a material is not opaque; "" if it is.
std::string ClearBecause(const Material& material) {
  if (material.opacity && *material.opacity < 1) {
    return "d " + NumberInText(*material.opacity);
  }
  const int model = material.illumination;
  const bool is_glass = model == 4 || model == 6 || model == 7 || model == 9;
  return is_glass ? "illum " + std::to_string(model) : "";
}

/// "3 materials", or "1 material" if they are one.
std::string Counted(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " material" : " materials");
}

std::string FirstTenOf(const std::vector<std::string>& names) {
  return FirstTen(names.size(), [&](std::size_t i) { return names[i]; });
}

}  // namespace

MaterialResolver::MaterialResolver(const ObjContents& obj,
                                   const MaterialLibrary& library,
                                   const ReadOptions& options,
                                   DiagnosticList& diagnostics)
    : obj_(obj),
      library_(library),
      options_(options),
      diagnostics_(diagnostics) {
  std::vector<bool> has_face(obj.materials.size());
  for (const ObjFace& face : obj.faces) {
    if (face.material >= 0 && face.defect == FaceDefect::kNone) {
      has_face[static_cast<std::size_t>(face.material)] = true;
    }
  }
  for (std::size_t i = 0; i < has_face.size(); ++i) {
    const ObjReference& reference = obj.materials[i];
    if (has_face[i] && !reference.name.empty()) {
      used_.emplace(reference.name, reference.line);
    }
  }
}

std::vector<FaceMaterial> MaterialResolver::Resolve() {
  ReportUnknown();
  if (!options_.opaque_from) ReportOpaque();
  std::vector<FaceMaterial> result;
  result.reserve(obj_.materials.size());
  for (const ObjReference& reference : obj_.materials)
    result.push_back(Of(reference.name));
  return result;
}

FaceMaterial MaterialResolver::Of(const std::string& name) const {
  const Material* const material = name.empty() ? nullptr : library_.Find(name);
  if (material == nullptr) return {};
  FaceMaterial result{material->emission, ""};
  const bool is_clear = options_.opaque_from && material->opacity &&
                        *material->opacity < *options_.opaque_from;
  if (is_clear && !Emits(*material)) {
    result.left_out = "material " + Quoted(name) + " lets light through, d " +
                      NumberInText(*material->opacity) + " < " +
                      NumberInText(*options_.opaque_from);
  }
  return result;
}

/// In the order of the lines where they are used first.
std::vector<std::pair<int, std::string>> MaterialResolver::UsedByLine() const {
  std::vector<std::pair<int, std::string>> result;
  for (const auto& [name, line] : used_)
    result.emplace_back(line, name);
  std::ranges::sort(result);
  return result;
}

void MaterialResolver::ReportUnknown() {
  std::vector<std::string> names;
  int first_line = 0;
  for (const auto& [line, name] : UsedByLine()) {
    if (library_.Find(name) != nullptr) continue;
    if (!options_.lenient) {
      diagnostics_.Error(line, "unknown material " + Quoted(name) +
                                   ", expected one that an MTL file defines "
                                   "(--lenient takes its faces as blockers)");
      continue;
    }
    if (names.empty()) first_line = line;
    names.push_back(Quoted(name));
  }
  if (names.empty()) return;
  diagnostics_.Note(first_line,
                    Counted(names.size()) +
                        " that no MTL file defines: the faces only block (" +
                        FirstTenOf(names) + ")");
}

void MaterialResolver::ReportOpaque() {
  std::vector<std::string> names;
  int first_line = 0;
  for (const auto& [line, name] : UsedByLine()) {
    const Material* const material = library_.Find(name);
    if (material == nullptr || Emits(*material)) continue;
    const std::string why = ClearBecause(*material);
    if (why.empty()) continue;
    if (names.empty()) first_line = line;
    names.push_back(Quoted(name) + ", " + why);
  }
  if (names.empty()) return;
  diagnostics_.Note(first_line,
                    Counted(names.size()) +
                        " that would let light through, taken as opaque (" +
                        FirstTenOf(names) +
                        "); --opaque-from leaves such faces out");
}

}  // namespace truelux
