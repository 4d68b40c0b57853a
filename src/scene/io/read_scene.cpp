// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/io/read_scene.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/stop.h"
#include "scene/covered_emitters.h"
#include "scene/diagnostic_list.h"
#include "scene/io/face_material.h"
#include "scene/io/library_search.h"
#include "scene/io/material_library.h"
#include "scene/io/obj_parser.h"
#include "scene/io/quoted.h"
#include "scene/io/statement.h"

namespace truelux {
namespace {

/// Reads the MTL files that an OBJ names. What is wrong with the files
/// themselves is a note: only a material that is missing is an error.
void LoadLibraries(const std::vector<ObjReference>& references,
                   LibrarySearch& search, MaterialLibrary& materials,
                   DiagnosticList& diagnostics) {
  std::set<std::filesystem::path> loaded;
  std::set<std::string> looked_for;
  for (const ObjReference& reference : references) {
    if (!looked_for.insert(reference.name).second) continue;
    std::vector<std::string> missing;
    for (const FoundLibrary& library : search.Find(reference.name, missing)) {
      const auto note = [&](const std::string& what) {
        diagnostics.Note(reference.line,
                         "MTL file " + Quoted(library.name) + ' ' + what);
      };
      if (!loaded.insert(library.path.lexically_normal()).second) continue;
      if (!library.is_literal) {
        note("does not exist by this name; " + Quoted(library.path.string()) +
             " is read for it");
      }
      const TextFile& file = search.Open(library.path);
      if (file.status != TextFile::Status::kRead) {
        note("cannot be read: " + file.reason);
        continue;
      }
      const std::string_view text = WithoutTail(file.text);
      if (const auto defect = FindTextDefect(text)) {
        note("cannot be read: " + defect->what);
      } else {
        materials.Read(text, library.path.string());
      }
    }
    for (const std::string& name : missing) {
      diagnostics.Note(reference.line,
                       "MTL file " + Quoted(name) + " does not exist");
    }
  }
}

/// Adds the faces. One that a defect was reported of is left out; so it keeps
/// its number, if defects are no errors.
void AddFaces(const ObjContents& obj,
              const std::vector<FaceMaterial>& materials,
              const ReadOptions& options, SceneBuilder& builder) {
  const FaceMaterial none;
  int group = 0;
  for (const ObjFace& face : obj.faces) {
    StopIfAsked(options.stop);
    if (face.group != group) {
      group = face.group;
      builder.SetGroup(obj.groups[static_cast<std::size_t>(group)]);
    }
    const FaceMaterial& material =
        face.material < 0 ? none
                          : materials[static_cast<std::size_t>(face.material)];
    if (face.defect != FaceDefect::kNone) {
      builder.LeaveOutFace(Name(face.defect), face.line);
      continue;
    }
    if (!material.left_out.empty()) {
      builder.LeaveOutFace(material.left_out, face.line);
      continue;
    }
    const auto begin =
        obj.corners.begin() + static_cast<std::ptrdiff_t>(face.first_corner);
    std::vector<Point3> ring;
    ring.reserve(static_cast<std::size_t>(face.corner_count));
    std::vector<int> numbers;
    numbers.reserve(ring.capacity());
    for (auto corner = begin; corner != begin + face.corner_count; ++corner) {
      ring.push_back(obj.positions[static_cast<std::size_t>(*corner)]);
      numbers.push_back(*corner + 1);
    }
    builder.SetVertexNumbers(std::move(numbers));
    builder.AddFace(std::move(ring), material.emission, face.line);
  }
}

/// What is hidden by another face in its own plane is easily overlooked.
void NoteCovered(const Scene& scene, DiagnosticList& diagnostics) {
  const CoveredEmitters emitters = CoveredEmittersOf(scene);
  const std::vector<CoveredEmitter>& covered = emitters.found;
  if (covered.empty()) return;
  const auto line_of = [&](int face) {
    return scene.faces()[static_cast<std::size_t>(face)].line;
  };
  const bool is_one = covered.size() == 1;
  diagnostics.Note(
      line_of(covered.front().face),
      (emitters.is_all ? "" : "at least ") + std::to_string(covered.size()) +
          (is_one ? " face that emits is" : " faces that emit are") +
          " covered, wholly or in part, by an earlier one in the same plane, "
          "which is seen instead (" +
          FirstTen(covered.size(),
                   [&](std::size_t i) {
                     return "line " + std::to_string(line_of(covered[i].face)) +
                            " by line " +
                            std::to_string(line_of(covered[i].cover));
                   }) +
          ")");
}

/// The scene of an OBJ text; nothing if the lists hold an error.
Result<Scene> BuildScene(const ObjContents& obj,
                         const std::vector<FaceMaterial>& materials,
                         const MaterialLibrary& library,
                         const ReadOptions& options,
                         DiagnosticList& diagnostics) {
  SceneBuilder builder(diagnostics.file());
  builder.SetLenient(options.lenient);
  builder.SetTwoSided(options.two_sided);
  AddFaces(obj, materials, options, builder);
  Result<Scene> result = builder.Build();
  // What the parser reported of faces is not reported again.
  const bool parser_failed = diagnostics.has_errors();
  for (Diagnostic& d : result.diagnostics) {
    if (parser_failed && d.severity == Severity::kNote) continue;
    diagnostics.Add(std::move(d));
  }
  if (result.ok() && !parser_failed) NoteCovered(*result.value, diagnostics);
  result.diagnostics = diagnostics.Sorted();
  bool has_errors = diagnostics.has_errors();
  for (const DiagnosticList& list : library.diagnostics()) {
    has_errors = has_errors || list.has_errors();
    const std::vector<Diagnostic> sorted = list.Sorted();
    result.diagnostics.insert(result.diagnostics.end(), sorted.begin(),
                              sorted.end());
  }
  if (has_errors) result.value.reset();
  return result;
}

/// Whether an OBJ text without faces is an MTL file.
bool LooksLikeMaterials(std::string_view text) {
  StatementReader reader(text);
  while (const std::optional<Statement> statement = reader.Next()) {
    if (statement->keyword == "newmtl") return true;
  }
  return false;
}

}  // namespace

Result<Scene> ReadSceneWith(const SceneFiles& files,
                            const std::filesystem::path& obj,
                            const ReadOptions& options) {
  DiagnosticList diagnostics(obj.string());
  const TextFile file = files.open(obj);
  if (file.status != TextFile::Status::kRead) {
    diagnostics.Error(0, "cannot be read: " + file.reason);
    return {std::nullopt, diagnostics.Sorted()};
  }
  const std::string_view text = WithoutTail(file.text);
  if (const auto defect = FindTextDefect(text)) {
    diagnostics.Error(defect->line, defect->what);
    return {std::nullopt, diagnostics.Sorted()};
  }
  const ObjContents contents = ParseObj(text, options, diagnostics);
  if (contents.faces.empty() && contents.positions.empty() &&
      LooksLikeMaterials(text)) {
    DiagnosticList only(obj.string());
    only.Error(0,
               "this is an MTL file (it has newmtl and neither v nor f), "
               "expected the OBJ file that names it");
    return {std::nullopt, only.Sorted()};
  }
  LibrarySearch search(files, obj.parent_path());
  MaterialLibrary library;
  LoadLibraries(contents.libraries, search, library, diagnostics);
  MaterialResolver resolver(contents, library, options, diagnostics);
  library.Report(
      [&resolver](const std::string& name) { return resolver.IsUsed(name); });
  const std::vector<FaceMaterial> materials = resolver.Resolve();
  return BuildScene(contents, materials, library, options, diagnostics);
}

SceneAndFiles ReadSceneAndFiles(const std::filesystem::path& obj,
                                const ReadOptions& options) {
  std::vector<std::filesystem::path> paths;
  const SceneFiles files{[&](const std::filesystem::path& path) {
                           paths.push_back(path);
                           return ReadTextFile(path, options.stop);
                         },
                         ListFolder};
  Result<Scene> scene = ReadSceneWith(files, obj, options);
  return {std::move(scene), std::move(paths)};
}

Result<Scene> ReadScene(const std::filesystem::path& obj,
                        const ReadOptions& options) {
  return ReadSceneAndFiles(obj, options).scene;
}

}  // namespace truelux
