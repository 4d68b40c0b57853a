// SPDX-License-Identifier: GPL-3.0-or-later
#include "image.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <limits>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
#include <span>
#include <stdexcept>
#include <string>

#include "truelux/io.h"
#include "truelux/irradiance.h"

#include "baselines/timing.h"
#include "measure.h"
#include "run/announce.h"
#include "scenes.h"

namespace truelux::bench {
namespace {

namespace fs = std::filesystem;

constexpr int kBoxes = 32;
constexpr int kFullSide = 512;
constexpr std::size_t kBlock = 256;

/// The receivers of a grid by what they see of the source, in their order.
struct Kinds {
  std::vector<Receiver> lit;
  std::vector<Receiver> penumbra;
  std::vector<Receiver> umbra;
};

/// No arc: umbra. As bright as without blockers, to the last bit: lit.
Kinds Classify(const std::vector<Receiver>& receivers,
               const std::vector<Irradiance>& results) {
  const Oracle lamp(GridLamp());
  Kinds kinds;
  for (std::size_t i = 0; i < receivers.size(); ++i) {
    if (results[i].statistics.arcs == 0) {
      kinds.umbra.push_back(receivers[i]);
    } else if (results[i].value == lamp.Evaluate(receivers[i]).value) {
      kinds.lit.push_back(receivers[i]);
    } else {
      kinds.penumbra.push_back(receivers[i]);
    }
  }
  return kinds;
}

/// Processor time of the whole call [s], the median of a few.
double SecondsFor(const Oracle& oracle, std::span<const Receiver> receivers) {
  std::array<double, 3> seconds{};
  for (double& s : seconds) {
    const double begin = ThreadSeconds();
    const auto results = oracle.Evaluate(receivers);
    s = ThreadSeconds() - begin;
  }
  return Median({seconds.begin(), seconds.end()});
}

void PrintKind(const char* name, const Oracle& oracle,
               const std::vector<Receiver>& receivers) {
  if (receivers.empty()) return;
  const auto count = static_cast<double>(receivers.size());
  fmt::print("{:<24} {:>9} {:>14.4g}\n", name, receivers.size(),
             1e6 * SecondsFor(oracle, receivers) / count);
  std::fflush(stdout);
}

/// Time that passes [s] when blocks of receivers are shared out to threads.
double SecondsOnThreads(const Oracle& oracle,
                        std::span<const Receiver> receivers, int threads) {
  const auto thread_count = static_cast<std::size_t>(threads);
  // The control allows more threads than there are cores, if so wished.
  const tbb::global_control control(
      tbb::global_control::max_allowed_parallelism, thread_count);
  tbb::task_arena arena(threads);
  const std::size_t blocks = (receivers.size() + kBlock - 1) / kBlock;
  const double begin = WallSeconds();
  arena.execute([&] {
    tbb::parallel_for(std::size_t{0}, blocks, [&](std::size_t i) {
      const std::size_t first = i * kBlock;
      const auto results = oracle.Evaluate(
          receivers.subspan(first, std::min(kBlock, receivers.size() - first)));
    });
  });
  return WallSeconds() - begin;
}

/// By the least times, since whatever else runs on the machine takes a core
/// away from two threads but not from one.
BarRow TwoThreads(const Oracle& oracle, std::span<const Receiver> receivers,
                  int rounds) {
  double one = std::numeric_limits<double>::infinity();
  double two = one;
  for (int round = 0; round < rounds; ++round) {
    Announce(fmt::format("two threads against one, round {}", round + 1));
    one = std::min(one, SecondsOnThreads(oracle, receivers, 1));
    two = std::min(two, SecondsOnThreads(oracle, receivers, 2));
  }
  return {"grid: two threads / one", two / one, 1 / 1.8, 1 / 1.95, ""};
}

/// A folder that is gone when it is no longer needed.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name =
        (fs::temp_directory_path() / "truelux-bench-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
      throw std::runtime_error("cannot make a temporary folder: " + name);
    path_ = name;
  }

  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }

  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

}  // namespace

std::vector<BarRow> MeasureGrid(const Options& options) {
  const int side = options.Size(96, kFullSide);
  const std::string name = fmt::format("grid_{0}x{0}", side);
  if (!options.Wants(name)) return {};
  Announce("making " + name);
  const BenchScene grid = MakeGrid(kBoxes, side, options.seed);
  const Oracle oracle(grid.scene);
  Announce(name);
  const Kinds kinds = Classify(grid.receivers, oracle.Evaluate(grid.receivers));
  const double seconds = SecondsFor(oracle, grid.receivers);
  Announce("");
  fmt::print("\n{}: {} triangles, certified, one thread: {:.3g} s\n", name,
             grid.scene.triangles().size(), seconds);
  fmt::print("{:<24} {:>9} {:>14}\n", "kind", "receivers", "us/receiver");
  PrintKind("lit", oracle, kinds.lit);
  PrintKind("penumbra", oracle, kinds.penumbra);
  PrintKind("umbra", oracle, kinds.umbra);

  const double scale = static_cast<double>(kFullSide) / side;
  BarRow row{fmt::format("grid_{0}x{0}: seconds on one thread", kFullSide),
             seconds * scale * scale,
             10,
             {},
             ""};
  if (side != kFullSide) row.what += fmt::format(", from {0}x{0}", side);
  return {row, TwoThreads(oracle, grid.receivers, options.Size(7, 3))};
}

std::vector<BarRow> MeasureLoading(const Options& options) {
  constexpr int kTriangles = 1000000;
  if (!options.Wants("loading")) return {};
  Announce("writing a large scene");
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "terrain.obj";
  {
    std::ofstream file(path);
    file << TerrainObj(kTriangles);
    file.close();
    if (!file) throw std::runtime_error("cannot write " + path.string());
  }
  Announce("reading a large scene");
  const double begin = WallSeconds();
  const Result<Scene> scene = ReadScene(path);
  const double read = WallSeconds();
  if (!scene.ok()) throw std::runtime_error(scene.diagnostics[0].Text());
  const Oracle oracle(*scene.value);
  const double end = WallSeconds();
  Announce("");
  fmt::print("\nloading: {} triangles, {:.3g} s to read, {:.3g} s to index\n",
             scene.value->triangles().size(), read - begin, end - read);
  std::fflush(stdout);
  return {
      {"loading: seconds for a million triangles", end - begin, 10, {}, ""}};
}

}  // namespace truelux::bench
