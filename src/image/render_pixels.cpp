// SPDX-License-Identifier: GPL-3.0-or-later
#include "image/render_pixels.h"

#include <cmath>
#include <cstddef>
#include <oneapi/tbb/parallel_for.h>
#include <optional>
#include <utility>
#include <vector>

#include "truelux/derivatives.h"

#include "explain/shadow_class.h"
#include "image/tile_grid.h"
#include "run/parallel.h"

namespace truelux {
namespace {

constexpr std::size_t kTilePixels = std::size_t{kTileSide} * kTileSide;

/// The pixels of one tile that have receivers.
struct Tile {
  struct Pixel {
    int x;
    int y;
  };

  std::vector<Pixel> pixels;
  std::vector<Receiver> receivers;
  /// What the evaluation says of each; nothing: the contour has to tell.
  std::vector<std::optional<ShadowClass>> classes;
};

OracleOptions OtherMethod(OracleOptions options) {
  options.method =
      options.method == Method::kDouble ? Method::kCertified : Method::kDouble;
  return options;
}

class Renderer {
 public:
  Renderer(const Oracle& oracle, const PixelReceivers& receivers,
           const PixelWishes& wishes, PixelPart* part, Progress& progress)
      : oracle_(oracle),
        receivers_(receivers),
        wishes_(wishes),
        part_(part),
        progress_(progress),
        is_long_(wishes.arcs || wishes.classes) {
    const int w = receivers.width();
    const int h = receivers.height();
    result_.image.values = Raster<Rgb>(w, h);
    result_.image.covered = Raster<std::uint8_t>(w, h, 0);
    if (wishes.bounds) result_.bounds = Raster<Rgb>(w, h);
    if (wishes.differences) {
      other_.emplace(oracle.prepared(), OtherMethod(oracle.options()));
      result_.differences = Raster<Rgb>(w, h);
    }
    if (wishes.gradients) result_.gradients = Raster<Rgb>(w, h);
    if (wishes.arcs) result_.arcs = Raster<std::int32_t>(w, h, 0);
    if (wishes.classes) {
      result_.classes = Raster<ShadowClass>(w, h, ShadowClass::kNothing);
    }
  }

  RenderedPixels Run(int threads) {
    const TileGrid grid(receivers_.width(), receivers_.height());
    std::vector<bool> done;
    if (part_ != nullptr) {
      done = part_->Restore(result_);
      progress_.Advance(part_->done());
    }
    WithThreads(threads, [&] {
      tbb::parallel_for(std::size_t{0}, grid.size(), [&](std::size_t i) {
        if (part_ != nullptr && done[i]) return;
        progress_.StopIfAsked();
        Tile tile = MakeTile(grid[i]);
        Render(tile);
        if (part_ != nullptr) part_->Take(i, result_);
      });
    });
    return std::move(result_);
  }

 private:
  [[nodiscard]] Tile MakeTile(const TileArea& area) {
    Tile tile;
    tile.pixels.reserve(kTilePixels);
    tile.receivers.reserve(kTilePixels);
    for (int y = area.top; y < area.bottom; ++y) {
      for (int x = area.left; x < area.right; ++x) {
        if (const auto receiver = receivers_.At(x, y)) {
          tile.pixels.push_back({x, y});
          tile.receivers.push_back(*receiver);
        } else {
          progress_.Advance();
        }
      }
    }
    return tile;
  }

  void Render(Tile& tile) {
    oracle_.Evaluate(tile.receivers, [&](std::size_t i, const Irradiance& e) {
      const auto [x, y] = tile.pixels[i];
      result_.image.values.At(x, y) = e.value;
      result_.image.covered.At(x, y) = 1;
      if (wishes_.bounds) result_.bounds.At(x, y) = e.bound;
      tile.classes.push_back(DarkClassOf(e.statistics));
      if (!is_long_) progress_.Advance();
      progress_.StopIfAsked();
    });
    if (other_) Compare(tile);
    if (wishes_.gradients) FindGradients(tile);
    if (is_long_) Describe(tile);
  }

  void Compare(const Tile& tile) {
    other_->Evaluate(tile.receivers, [&](std::size_t i, const Irradiance& e) {
      const auto [x, y] = tile.pixels[i];
      const Rgb& value = result_.image.values.At(x, y);
      Rgb& difference = result_.differences.At(x, y);
      for (std::size_t k = 0; k < 3; ++k) {
        // Two infinities agree.
        difference[k] =
            value[k] == e.value[k] ? 0 : std::fabs(value[k] - e.value[k]);
      }
      progress_.StopIfAsked();
    });
  }

  /// 0 where a receiver lies on a face that is not its own.
  void FindGradients(const Tile& tile) {
    oracle_.Derivatives(
        tile.receivers, {.sphere = false, .jacobian = false},
        [&](std::size_t i, const Derivatives& derivatives) {
          const auto [x, y] = tile.pixels[i];
          for (std::size_t k = 0; k < 3; ++k) {
            const Vector3& g = derivatives.channels[k].tangential;
            result_.gradients.At(x, y)[k] = std::hypot(g.x, g.y, g.z);
          }
          progress_.StopIfAsked();
        });
  }

  /// The class if the evaluation found that nothing is visible.
  [[nodiscard]] std::optional<ShadowClass> DarkClassOf(
      const Statistics& statistics) const {
    // Sums over vertices count no arcs.
    if (oracle_.options().engine == Engine::kAngularSpans) return std::nullopt;
    if (statistics.sources == 0) return ShadowClass::kNoSource;
    if (statistics.arcs == 0) return ShadowClass::kUmbra;
    return std::nullopt;
  }

  void Describe(const Tile& tile) {
    for (std::size_t i = 0; i < tile.pixels.size(); ++i) {
      progress_.Advance();
      progress_.StopIfAsked();
      const auto [x, y] = tile.pixels[i];
      if (tile.classes[i]) {
        if (wishes_.classes) result_.classes.At(x, y) = *tile.classes[i];
        continue;  // no arcs, either
      }
      const VisibleContour contour = oracle_.Contour(tile.receivers[i]);
      if (wishes_.arcs) {
        result_.arcs.At(x, y) = static_cast<std::int32_t>(contour.arcs.size());
      }
      if (wishes_.classes) {
        result_.classes.At(x, y) =
            ShadowClassOf(oracle_.scene(), tile.receivers[i], contour);
      }
    }
  }

  const Oracle& oracle_;
  const PixelReceivers& receivers_;
  const PixelWishes& wishes_;
  std::optional<Oracle> other_;  ///< if differences are wished for
  PixelPart* part_;              ///< may be null
  Progress& progress_;
  /// Whether contours are described, which takes longest.
  bool is_long_;
  RenderedPixels result_;
};

}  // namespace

RenderedPixels RenderPixels(const Oracle& oracle,
                            const PixelReceivers& receivers,
                            const PixelWishes& wishes, int threads,
                            PixelPart* part, Progress& progress) {
  return Renderer(oracle, receivers, wishes, part, progress).Run(threads);
}

}  // namespace truelux
