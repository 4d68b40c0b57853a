// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/io/read_scene.h"

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "truelux/io.h"

#include "scene/diagnostic_list.h"
#include "scene/io/material_library.h"
#include "scene/io/obj_parser.h"
#include "scene/io/statement.h"

namespace truelux {
namespace {

/// Whether a file is text, after reporting that it is not.
bool IsText(const TextFile& file, DiagnosticList& diagnostics) {
  const std::optional<BinaryByte> byte = FindBinaryByte(file.text);
  if (!byte) return true;
  diagnostics.Error(byte->line, "binary data (a byte " +
                                    std::to_string(byte->value) +
                                    "), expected text");
  return false;
}

/// The MTL files of one OBJ.
class LibraryLoader {
 public:
  LibraryLoader(const FileOpener& open, std::filesystem::path folder,
                DiagnosticList& obj_diagnostics)
      : open_(open),
        folder_(std::move(folder)),
        obj_diagnostics_(obj_diagnostics) {}

  /// One mtllib statement: a name, or several names with blanks between.
  void Load(const ObjReference& reference) {
    if (TryLoad(reference.name, reference.line)) return;
    std::vector<std::string> missing;
    std::string_view rest = reference.name;
    std::size_t count = 0;
    while (!rest.empty()) {
      const std::string name(TakeWord(rest));
      if (!TryLoad(name, reference.line)) missing.push_back(name);
      ++count;
    }
    // A single name with blanks is likelier than several that all are missing.
    if (missing.size() == count) missing = {reference.name};
    for (const std::string& name : missing) {
      ReportUnread(name, "it does not exist", reference.line);
    }
  }

  [[nodiscard]] const MaterialLibrary& library() const { return library_; }

  /// Whether all files could be read.
  [[nodiscard]] bool complete() const { return complete_; }

  [[nodiscard]] const std::vector<DiagnosticList>& diagnostics() const {
    return diagnostics_;
  }

 private:
  /// Returns false if there is no such file. A file named twice, be it by
  /// "a.mtl" and "./a.mtl", is read once.
  bool TryLoad(const std::string& name, int line) {
    const std::filesystem::path path = folder_ / name;
    if (loaded_.contains(path.lexically_normal())) return true;
    const TextFile file = open_(path);
    if (file.status == TextFile::Status::kMissing) return false;
    loaded_.insert(path.lexically_normal());
    if (file.status == TextFile::Status::kUnreadable) {
      ReportUnread(name, file.reason, line);
      return true;
    }
    DiagnosticList& diagnostics = diagnostics_.emplace_back(path.string());
    if (IsText(file, diagnostics)) {
      library_.Read(file.text, diagnostics);
    } else {
      complete_ = false;
    }
    return true;
  }

  void ReportUnread(const std::string& name, const std::string& reason,
                    int line) {
    complete_ = false;
    obj_diagnostics_.Error(line, "MTL file '" + (folder_ / name).string() +
                                     "' cannot be read: " + reason);
  }

  const FileOpener& open_;
  std::filesystem::path folder_;
  DiagnosticList& obj_diagnostics_;
  MaterialLibrary library_;
  bool complete_ = true;
  std::set<std::filesystem::path> loaded_;
  std::vector<DiagnosticList> diagnostics_;
};

/// The emission for each usemtl statement.
std::vector<Rgb> ResolveMaterials(const std::vector<ObjReference>& references,
                                  const LibraryLoader& loader,
                                  DiagnosticList& diagnostics) {
  std::vector<Rgb> emissions;
  for (const ObjReference& reference : references) {
    const Material* material = loader.library().Find(reference.name);
    emissions.push_back(material != nullptr ? material->emission : Rgb{});
    // What a file that cannot be read defines is not known.
    if (material != nullptr || !loader.complete()) continue;
    diagnostics.Error(reference.line,
                      "unknown material " + Quoted(reference.name) +
                          ", expected one that an MTL file defines");
  }
  return emissions;
}

bool HasDefectiveVertex(const ObjContents& obj, const ObjFace& face) {
  for (int i = 0; i < face.corner_count; ++i) {
    const auto corner = face.first_corner + static_cast<std::size_t>(i);
    const auto vertex = static_cast<std::size_t>(obj.corners[corner]);
    const Point3& position = obj.positions[vertex];
    if (std::isnan(position.x)) return true;
  }
  return false;
}

/// Adds every face that no defect was reported of so far.
void AddFaces(const ObjContents& obj, const std::vector<Rgb>& emissions,
              SceneBuilder& builder) {
  int group = 0;
  for (const ObjFace& face : obj.faces) {
    if (!face.usable || HasDefectiveVertex(obj, face)) continue;
    if (face.group != group) {
      group = face.group;
      builder.SetGroup(obj.groups[static_cast<std::size_t>(group)]);
    }
    const auto begin =
        obj.corners.begin() + static_cast<std::ptrdiff_t>(face.first_corner);
    std::vector<Point3> ring;
    ring.reserve(static_cast<std::size_t>(face.corner_count));
    for (auto corner = begin; corner != begin + face.corner_count; ++corner) {
      ring.push_back(obj.positions[static_cast<std::size_t>(*corner)]);
    }
    const Rgb emission =
        face.material < 0 ? Rgb{}
                          : emissions[static_cast<std::size_t>(face.material)];
    builder.AddFace(std::move(ring), emission, face.line);
  }
}

/// The scene of an OBJ text; nothing if the lists hold an error.
Result<Scene> BuildScene(const ObjContents& obj, const LibraryLoader& loader,
                         DiagnosticList& diagnostics) {
  SceneBuilder builder(diagnostics.file());
  AddFaces(obj, ResolveMaterials(obj.materials, loader, diagnostics), builder);
  Result<Scene> result = builder.Build();
  for (Diagnostic& d : result.diagnostics) {
    // If every face was rejected, the scene is not also reported as empty.
    const bool is_empty = result.ok() && result.value->faces().empty();
    if (is_empty && !obj.faces.empty()) break;
    diagnostics.Add(std::move(d));
  }
  result.diagnostics = diagnostics.Sorted();
  bool has_errors = diagnostics.has_errors();
  for (const DiagnosticList& list : loader.diagnostics()) {
    has_errors = has_errors || list.has_errors();
    const std::vector<Diagnostic> sorted = list.Sorted();
    result.diagnostics.insert(result.diagnostics.end(), sorted.begin(),
                              sorted.end());
  }
  if (has_errors) result.value.reset();
  return result;
}

}  // namespace

Result<Scene> ReadSceneWith(const FileOpener& open,
                            const std::filesystem::path& obj) {
  DiagnosticList diagnostics(obj.string());
  const TextFile file = open(obj);
  if (file.status != TextFile::Status::kRead) {
    diagnostics.Error(0, "cannot be read: " + file.reason);
  }
  if (diagnostics.has_errors() || !IsText(file, diagnostics)) {
    return {std::nullopt, diagnostics.Sorted()};
  }
  const ObjContents contents = ParseObj(file.text, diagnostics);
  LibraryLoader loader(open, obj.parent_path(), diagnostics);
  for (const ObjReference& library : contents.libraries)
    loader.Load(library);
  return BuildScene(contents, loader, diagnostics);
}

SceneAndFiles ReadSceneAndFiles(const std::filesystem::path& obj) {
  std::vector<std::filesystem::path> files;
  const FileOpener open = [&files](const std::filesystem::path& path) {
    files.push_back(path);
    return ReadTextFile(path);
  };
  Result<Scene> scene = ReadSceneWith(open, obj);
  return {std::move(scene), std::move(files)};
}

Result<Scene> ReadScene(const std::filesystem::path& obj) {
  return ReadSceneWith(ReadTextFile, obj);
}

}  // namespace truelux
