// SPDX-License-Identifier: GPL-3.0-or-later
#include "suites.h"

#include <cstddef>
#include <fmt/format.h>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>

#include "methods.h"
#include "run/announce.h"
#include "scenes.h"
#include "tables.h"

namespace truelux::bench {
namespace {

/// Beyond this the arrangement engine takes too long to be waited for.
constexpr std::size_t kArrangementTriangles = 300;

/// So many receivers at most by blockers, which takes long on large meshes.
constexpr std::size_t kMostByBlockers = 128;

/// How much is measured on a scene.
struct Choice {
  std::vector<int> samples;         ///< of shadow rays, in Sobol's order
  std::vector<int> stream_samples;  ///< of shadow rays, in rows
  std::vector<int> rows;            ///< of the scanline quadrature
  bool arrangement = false;
  bool polygon_set = false;
  bool contour_paths = false;  ///< these, instead of sums in double
};

const std::vector<int> kAllSamples = {64, 256, 1024, 4096, 16384};

const Choice kFull = {
    kAllSamples, kAllSamples, {256, 2048, 32768}, true, false};
const Choice kMedium = {
    {256, 1024, 4096}, {1024, 4096}, {256, 2048}, true, false};
const Choice kShort = {{1024}, {1024}, {}, false, false};
const Choice kShortAndPolygonSet = {{1024}, {1024}, {2048}, false, true};
const Choice kMeshes = {{1024}, {}, {}, false, false, true};

/// Meshes that --meshes FOLDER has.
constexpr const char* kFileMeshes[] = {"teapot", "torus3", "bunny_lowres"};

/// A scene that is made only if it is wanted.
struct Recipe {
  std::string name;
  std::function<BenchScene()> make;
  const Choice* choice = nullptr;
};

/// Scenes whose methods take turns with each other.
using Suite = std::vector<Recipe>;

void AppendSampled(const BenchScene& scene, const Choice& choice,
                   std::uint64_t seed, std::vector<Contender>& methods) {
  if (!ShadowRaysAvailable()) return;
  const auto rays = std::make_shared<const ShadowRays>(scene.scene);
  for (const int count : choice.samples) {
    methods.push_back(SampledContender(scene.scene, rays, SamplePattern::kSobol,
                                       count, seed));
  }
  for (const int count : choice.stream_samples) {
    methods.push_back(SampledContender(
        scene.scene, rays, SamplePattern::kRowOrdered, count, seed));
  }
}

Task MakeTask(const BenchScene& scene, const Choice& choice,
              const Options& options) {
  Task task{&scene, {CertifiedMethod(scene)}};
  if (choice.contour_paths) {
    task.methods.push_back(
        ContourPathMethod(scene, ContourPath::kBlockers, kBlockersName));
    task.methods.back().max_receivers = kMostByBlockers;
    task.methods.push_back(
        ContourPathMethod(scene, ContourPath::kChain, kChainName));
  } else {
    task.methods.push_back(DoubleMethod(scene));
    task.methods.push_back(UnfilteredMethod(scene));
  }
  AppendSampled(scene, choice, options.seed, task.methods);
  for (const int rows : choice.rows)
    task.methods.push_back(ScanlineContender(scene.scene, rows));
  if (choice.arrangement &&
      scene.scene.triangles().size() <= kArrangementTriangles) {
    task.methods.push_back(
        ArrangementMethod(scene, options.Size<std::size_t>(1, 4)));
  }
  if (choice.polygon_set) task.methods.push_back(PolygonSetMethod(scene));
  return task;
}

/// How the two ways of the contour engine compare, and its choice with shadow
/// rays.
std::string PathRemark(const std::vector<Measurement>& of_scene) {
  const Measurement& certified = of_scene.front();
  const auto ratio_to = [&](const std::string& method) -> std::string {
    const Measurement* other = Find(of_scene, certified.scene, method);
    if (other == nullptr) return "-";
    return fmt::format("{:.3g}", Ratio(certified, *other));
  };
  return fmt::format(
      "certified / {0}: {1}; certified / {2}: {3}; certified / {4}: {5}",
      SampledName(SamplePattern::kSobol, 1024),
      ratio_to(SampledName(SamplePattern::kSobol, 1024)), kBlockersName,
      ratio_to(kBlockersName), kChainName, ratio_to(kChainName));
}

/// What the table of a scene does not say by itself.
std::vector<std::string> Remarks(const BenchScene& scene, const Choice& choice,
                                 const std::vector<Measurement>& of_scene) {
  std::vector<std::string> remarks;
  if (choice.contour_paths) remarks.push_back(PathRemark(of_scene));
  if (choice.arrangement &&
      scene.scene.triangles().size() > kArrangementTriangles) {
    remarks.push_back(
        fmt::format("arrangement engine: left out, more than {} triangles",
                    kArrangementTriangles));
  }
  if (!ShadowRaysAvailable())
    remarks.emplace_back("Embree: left out, not found when this was built");
  return remarks;
}

Recipe LampsRecipe(int count, bool shared_edges, const Options& options) {
  return {fmt::format("{}_lamps_{}", shared_edges ? "mesh" : "separate", count),
          [=] {
            return MakeLamps(count, shared_edges, options.Size(4, 20),
                             options.seed);
          },
          &kShort};
}

std::vector<Suite> AllSuites(const Options& options) {
  const std::uint64_t seed = options.seed;
  std::vector<Suite> suites;
  Suite slabs;
  for (const int count : {10, 100, 1000}) {
    slabs.push_back(
        {fmt::format("slab_{}", count),
         [=] { return MakeSlab(count, options.Size(20, 200), seed); }, &kFull});
  }
  suites.push_back(slabs);
  suites.push_back(
      {{"room", [=] { return MakeRoom(options.Size(20, 200), seed); },
        &kFull}});
  suites.push_back(
      {{"lattice",
        [=] { return MakeLattice(false, options.Size(10, 40), seed); }, &kFull},
       {"one_ulp",
        [=] { return MakeLattice(true, options.Size(10, 40), seed); },
        &kFull}});
  suites.push_back(
      {{"sphere_3120",
        [=] { return MakeSphere(40, options.Size(5, 25), seed); }, &kMedium}});
  suites.push_back(
      {{"sphere_69564",
        [=] { return MakeSphere(187, options.Size(2, 10), seed); }, &kMedium}});
  Suite outward;
  for (const int count : {1, 10, 100, 1000, 10000, 100000, 1000000}) {
    outward.push_back(
        {fmt::format("outward_{}", count),
         [=] { return MakeOutward(count, options.Size(4, 20), seed); },
         &kShort});
  }
  suites.push_back(outward);
  Suite overlapping;
  for (const int count : {1, 10, 100, 1000}) {
    overlapping.push_back(
        {fmt::format("overlapping_{}", count),
         [=] { return MakeOverlapping(count, options.Size(2, 10), seed); },
         &kShortAndPolygonSet});
  }
  suites.push_back(overlapping);
  Suite lamps;
  for (const int count : {1, 10, 100, 1000}) {
    lamps.push_back(LampsRecipe(count, false, options));
    lamps.push_back(LampsRecipe(count, true, options));
  }
  suites.push_back(lamps);
  return suites;
}

/// One by one, since several would not fit into memory; but the lamps take
/// turns.
std::vector<Suite> MeshSuites(const Options& options) {
  const std::uint64_t seed = options.seed;
  std::vector<Suite> suites;
  const auto add = [&suites](const std::string& name,
                             std::function<BenchScene()> make) {
    suites.push_back({{name, std::move(make), &kMeshes}});
  };
  for (const int n : {40, 187, 388}) {
    add(fmt::format("meshes_sphere_{}", 2 * n * (n - 1)),
        [=] { return MakeSmoothSphere(n, options.Size(4, 20), seed); });
  }
  add("meshes_bumpy_300312", [=] {
    BenchScene bumpy = MakeSphere(388, options.Size(2, 8), seed);
    bumpy.name = "meshes_bumpy_300312";
    return bumpy;
  });
  // An edge is 0.01 long. Scans that have been smoothed are rough by a hundredth
  // of that, raw ones by a tenth.
  add("meshes_scan_70688",
      [=] { return MakeScan(94, 1e-4, options.Size(4, 20), seed); });
  add("meshes_scan_70688_grid",
      [=] { return MakeScanGrid(94, 1e-4, options.Size(8, 32), seed); });
  add("meshes_rough_scan_70688",
      [=] { return MakeScan(94, 1e-3, options.Size(4, 20), seed); });
  add("meshes_room",
      [=] { return MakeFurnishedRoom(30, options.Size(20, 100), seed); });
  add("meshes_voxels", [=] { return MakeVoxels(options.Size(10, 40), seed); });
  add("meshes_leaves_20000",
      [=] { return MakeFoliage(20000, options.Size(2, 10), seed); });
  suites.push_back(
      {{"meshes_lamp_1",
        [=] { return MakeMeshLamp(1, 1, options.Size(4, 20), seed); },
        &kMeshes},
       {"meshes_lamp_1000",
        [=] { return MakeMeshLamp(40, 25, options.Size(2, 10), seed); },
        &kMeshes},
       {"meshes_lamp_10000",
        [=] { return MakeMeshLamp(125, 80, options.Size(1, 3), seed); },
        &kMeshes}});
  if (!options.meshes.empty()) {
    for (const char* name : kFileMeshes) {
      add(fmt::format("meshes_{}", name),
          [=] { return MakeFileMesh(options.meshes, name, 24); });
    }
  }
  return suites;
}

/// Says so if scenes are asked for that are in files.
void PrintMissingFiles(const Options& options) {
  if (!options.meshes.empty()) return;
  for (const char* name : kFileMeshes) {
    if (options.Wants(fmt::format("meshes_{}", name)))
      fmt::print("\nmeshes_{0}: left out, no --meshes FOLDER with {0}.obj\n",
                 name);
  }
}

void Run(const Suite& suite, const Limits& limits, const Options& options,
         std::vector<Measurement>& all) {
  std::vector<BenchScene> scenes;
  std::vector<const Choice*> choices;
  for (const Recipe& recipe : suite) {
    if (!options.Wants(recipe.name)) continue;
    Announce("making " + recipe.name);
    scenes.push_back(recipe.make());
    choices.push_back(recipe.choice);
  }
  std::vector<Task> tasks;
  for (std::size_t i = 0; i < scenes.size(); ++i)
    tasks.push_back(MakeTask(scenes[i], *choices[i], options));
  const std::vector<Measurement> measured = Measure(tasks, limits);
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    std::vector<Measurement> of_scene;
    for (const Measurement& m : measured) {
      if (m.scene == scenes[i].name) of_scene.push_back(m);
    }
    PrintScene(scenes[i], of_scene, Remarks(scenes[i], *choices[i], of_scene));
    all.insert(all.end(), of_scene.begin(), of_scene.end());
  }
}

}  // namespace

std::vector<Measurement> RunSuites(const Options& options) {
  std::vector<Measurement> all;
  const Limits limits{options.Size(3, 7), options.Size(4.0, 120.0)};
  for (const Suite& suite : AllSuites(options))
    Run(suite, limits, options, all);
  if (!options.WantsMeshes()) return all;
  const Limits mesh_limits{options.Size(3, 5), options.Size(4.0, 60.0)};
  for (const Suite& suite : MeshSuites(options))
    Run(suite, mesh_limits, options, all);
  PrintMissingFiles(options);
  return all;
}

}  // namespace truelux::bench
