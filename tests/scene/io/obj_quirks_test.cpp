// SPDX-License-Identifier: GPL-3.0-or-later
// Exporters write much that changes nothing. Scenes with random quirks of that
// kind are the scene without them, and what is remarked on are notes.

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "support/scene_text.h"

namespace truelux {
namespace {

/// A scene while it is written: lines of the OBJ and of the MTL.
struct Draft {
  std::vector<std::string> vertices;
  std::vector<std::string> before_faces;
  std::vector<std::string> faces;
  std::vector<std::string> after_faces;
  std::vector<std::string> materials;
  std::string library = "mtllib scene.mtl";
  std::string end;
  std::string line_end = "\n";
};

Draft Plain() {
  Draft draft;
  for (const char* v : {"0 0 0", "2 0 0", "2 2 0", "0 2 0", "0 0 3", "2 0 3",
                        "2 2 3", "0 2 4"}) {
    draft.vertices.push_back(std::string("v ") + v);
  }
  draft.faces = {"usemtl lamp", "f 5 8 7 6", "f 1 2 6",
                 "usemtl wall", "f 1 2 3 4", "f 3 4 8"};
  draft.materials = {"newmtl lamp", "Ke 3 3 3", "newmtl wall"};
  return draft;
}

std::string TextOf(const Draft& draft) {
  std::string text;
  const auto add = [&](const std::string& line) {
    text += line + draft.line_end;
  };
  add(draft.library);
  for (const auto* lines : {&draft.vertices, &draft.before_faces, &draft.faces,
                            &draft.after_faces}) {
    for (const std::string& line : *lines)
      add(line);
  }
  return text + draft.end;
}

std::string MaterialTextOf(const Draft& draft) {
  std::string text;
  for (const std::string& line : draft.materials)
    text += line + draft.line_end;
  return text + draft.end;
}

/// Appends something to every corner of a face.
void AppendToCorners(std::string& face, const std::string& what) {
  if (!face.starts_with("f ")) return;
  std::string changed = "f";
  std::size_t at = 2;
  while (at < face.size()) {
    const std::size_t end = std::min(face.find(' ', at), face.size());
    std::string corner = face.substr(at, end - at);
    changed += " " + corner.substr(0, corner.find('/')) + what;
    at = end + 1;
  }
  face = changed;
}

struct Quirk {
  const char* name;
  std::function<void(Draft&)> apply;
};

Quirk Before(const char* name, std::string line) {
  return {name, [line = std::move(line)](Draft& draft) {
            draft.before_faces.push_back(line);
          }};
}

Quirk After(const char* name, std::string line) {
  return {name, [line = std::move(line)](Draft& draft) {
            draft.after_faces.push_back(line);
          }};
}

Quirk Corners(const char* name, std::string what) {
  return {name, [what = std::move(what)](Draft& draft) {
            for (std::string& face : draft.faces)
              AppendToCorners(face, what);
          }};
}

Quirk Vertex(const char* name, std::string what) {
  return {name, [what = std::move(what)](Draft& draft) {
            draft.vertices[3] = "v 0 2 0" + what;
          }};
}

Quirk Material(const char* name, std::vector<std::string> lines) {
  return {name, [lines = std::move(lines)](Draft& draft) {
            draft.materials.insert(draft.materials.end(), lines.begin(),
                                   lines.end());
          }};
}

std::vector<Quirk> AllQuirks() {
  return {
      Before("normal nan", "vn nan nan nan"),
      Before("normal -nan(ind)", "vn -nan(ind) 0 1"),
      Before("normal of two", "vn 0 1"),
      Before("texture inf", "vt inf 0"),
      Before("texture of four", "vt 0 0 0 0"),
      Before("texture empty", "vt"),
      Before("vp words", "vp a b"),
      Before("normal with decimal comma", "vn 0,5 0 1"),
      After("unused vertex nan", "v nan nan nan"),
      After("unused vertex short", "v 1"),
      After("unused vertex comma", "v 1,5 2,5 3"),
      Corners("corner 1//", "//"),
      Corners("corner 1/1/", "/1/"),
      Corners("corner 1/", "/"),
      Corners("corner 1/0/0", "/0/0"),
      Corners("corner 1/99/99", "/99/99"),
      Corners("corner 1/-99", "/-99"),
      Corners("corner 1/x/y", "/x/y"),
      Corners("corner of four parts", "/1/1/1"),
      Vertex("weight", " 0.5"),
      Vertex("weight nan", " nan"),
      Vertex("five numbers", " 1 1"),
      Vertex("seven numbers", " 1 1 1 1"),
      Vertex("colour nan", " 1 nan 1"),
      Vertex("words behind", " # 0 a b"),
      After("face of two", "f 1 2"),
      After("face of none", "f"),
      After("face of duplicates", "f 4 4 5"),
      Before("usemtl without name", "usemtl"),
      {"usemtl with blank",
       [](Draft& draft) {
         draft.faces.insert(draft.faces.begin(), "usemtl ");
       }},
      {"usemtl without definition or face",
       [](Draft& draft) {
         draft.faces.insert(draft.faces.begin(), "usemtl nobody");
       }},
      Before("mtllib without name", "mtllib"),
      Before("mtllib missing", "mtllib gone.mtl"),
      {"mtllib quoted",
       [](Draft& draft) { draft.library = "mtllib \"scene.mtl\""; }},
      {"mtllib backslash",
       [](Draft& draft) { draft.library = "mtllib .\\scene.mtl"; }},
      {"mtllib case", [](Draft& draft) { draft.library = "mtllib SCENE.Mtl"; }},
      {"mtllib absolute",
       [](Draft& draft) { draft.library = "mtllib D:\\a b\\scene.mtl"; }},
      {"NUL at the end",
       [](Draft& draft) { draft.end = std::string(8, '\0'); }},
      {"^Z at the end", [](Draft& draft) { draft.end = "\x1A"; }},
      {"CRLF", [](Draft& draft) { draft.line_end = "\r\n"; }},
      {"newmtl without name",
       [](Draft& draft) {
         draft.materials.insert(draft.materials.begin(), {"newmtl", "Ke 9"});
       }},
      {"Ke before newmtl",
       [](Draft& draft) {
         draft.materials.insert(draft.materials.begin(), "Ke 9 9 9");
       }},
      Material("newmtl twice", {"newmtl lamp", "Ke 3 3 3"}),
      Material("newmtl twice, one number", {"newmtl lamp", "Ke 3"}),
      Material("newmtl twice without Ke", {"newmtl wall", "Kd 1 1 1"}),
      Material("unused material broken", {"newmtl x", "Ke a", "Ke spectral b"}),
      Material("unused material twice",
               {"newmtl y", "Ke 1", "newmtl y", "Ke 2"}),
      Material("broken d", {"newmtl z", "d", "Tr x", "illum 99"}),
  };
}

/// The triangles with what they emit, in order.
std::vector<std::pair<std::array<Point3, 3>, Rgb>> LightOf(const Scene& scene) {
  std::vector<std::pair<std::array<Point3, 3>, Rgb>> light;
  for (const Triangle& t : scene.triangles()) {
    std::array<Point3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = scene.vertices()[static_cast<std::size_t>(t.vertices[k])];
    const Facet& facet = scene.facets()[static_cast<std::size_t>(t.facet)];
    light.emplace_back(
        corners, scene.faces()[static_cast<std::size_t>(facet.face)].emission);
  }
  return light;
}

Result<Scene> Read(const Draft& draft, const ReadOptions& options = {}) {
  return ReadSceneFrom(
      {{"scene.obj", TextOf(draft)}, {"scene.mtl", MaterialTextOf(draft)}},
      "scene.obj", options);
}

TEST(ObjQuirks, ChangeNothing) {
  const Scene plain = *Read(Plain()).value;
  ASSERT_EQ(LightOf(plain).size(), 6U);
  const std::vector<Quirk> quirks = AllQuirks();
  // Each alone, then several at once.
  for (const Quirk& quirk : quirks) {
    Draft draft = Plain();
    quirk.apply(draft);
    const Result<Scene> result = Read(draft);
    ASSERT_TRUE(result.ok()) << quirk.name << "\n"
                             << TextOf(result.diagnostics);
    EXPECT_EQ(LightOf(*result.value), LightOf(plain)) << quirk.name;
  }
  std::mt19937 random(31);
  for (int i = 0; i < 500; ++i) {
    Draft draft = Plain();
    std::string names;
    for (const Quirk& quirk : quirks) {
      if (random() % 4 != 0) continue;
      quirk.apply(draft);
      names += std::string(quirk.name) + "; ";
    }
    ReadOptions options;
    options.lenient = i % 2 == 0;
    const Result<Scene> result = Read(draft, options);
    ASSERT_TRUE(result.ok()) << names << "\n" << TextOf(result.diagnostics);
    ASSERT_EQ(LightOf(*result.value), LightOf(plain)) << names;
    ASSERT_TRUE(result.value->left_out().empty()) << names;
    for (const Diagnostic& d : result.diagnostics)
      ASSERT_EQ(d.severity, Severity::kNote) << d.Text();
  }
}

TEST(ObjQuirks, AreCountedInOneNote) {
  Draft draft = Plain();
  draft.before_faces = {"vn nan 0 0", "vt x", "vn 1 2"};
  AppendToCorners(draft.faces[1], "//");
  EXPECT_EQ(TextOf(Read(draft).diagnostics),
            "scene.obj:10: note: data that truelux does not use (vn, vt, vp, "
            "indices of them, what follows x y z) is not as OBJ asks for (and "
            "3 more such lines)\n"
            "scene.obj:14: note: 1 face is not planar and is split into "
            "triangles, first at line 14\n");
}

/// What makes a face an error, put before the faces.
TEST(ObjQuirks, DefectiveFacesAreLeftOutIfLenient) {
  const std::vector<Quirk> defects = {
      After("index 0", "f 1 2 0"),
      After("index too large", "f 1 2 99"),
      After("index too small", "f 1 2 -99"),
      After("no integer", "f 1 2 x"),
      After("thousands", "f 1 2 1,003"),
      After("bow-tie", "f 1 2 4 3"),
      {"vertex nan",
       [](Draft& draft) {
         draft.after_faces.insert(draft.after_faces.end(),
                                  {"v nan 0 0", "f 1 2 -1"});
       }},
      {"vertex comma",
       [](Draft& draft) {
         draft.after_faces.insert(draft.after_faces.end(),
                                  {"v 1,5 0 0", "f 1 2 -1"});
       }},
  };
  const Scene plain = *Read(Plain()).value;
  ReadOptions options;
  options.lenient = true;
  for (const Quirk& defect : defects) {
    Draft draft = Plain();
    defect.apply(draft);
    draft.after_faces.push_back("f 1 1 1");
    const Result<Scene> strict = Read(draft);
    EXPECT_FALSE(strict.ok()) << defect.name;
    EXPECT_NE(TextOf(strict.diagnostics).find("--lenient"), std::string::npos)
        << TextOf(strict.diagnostics);
    const Result<Scene> lenient = Read(draft, options);
    ASSERT_TRUE(lenient.ok()) << defect.name;
    EXPECT_EQ(LightOf(*lenient.value), LightOf(plain)) << defect.name;
    // The face that is left out keeps its number.
    EXPECT_EQ(lenient.value->faces().size(), 6U) << defect.name;
    ASSERT_EQ(lenient.value->left_out().size(), 1U) << defect.name;
    EXPECT_EQ(lenient.value->left_out()[0].numbers, std::vector<int>{5});
  }
}

}  // namespace
}  // namespace truelux
