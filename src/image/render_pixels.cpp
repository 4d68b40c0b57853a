// SPDX-License-Identifier: GPL-3.0-or-later
#include "image/render_pixels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <oneapi/tbb/parallel_for.h>
#include <optional>
#include <utility>
#include <vector>

#include "base/receiver_block.h"
#include "run/interrupt.h"
#include "run/parallel.h"

namespace truelux {
namespace {

/// A side of the square tiles that are handed to the oracle: a whole tile is
/// one block of receivers.
constexpr int kTile = kReceiverBlockSide;
constexpr std::size_t kTilePixels = std::size_t{kTile} * kTile;

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
           const PixelWishes& wishes, Progress& progress)
      : oracle_(oracle),
        receivers_(receivers),
        wishes_(wishes),
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
    if (wishes.arcs) result_.arcs = Raster<std::int32_t>(w, h, 0);
    if (wishes.classes) {
      result_.classes = Raster<ShadowClass>(w, h, ShadowClass::kNothing);
    }
  }

  RenderedPixels Run(int threads) {
    const auto tiles = [](int side) {
      return static_cast<std::size_t>((side + kTile - 1) / kTile);
    };
    const std::size_t across = tiles(receivers_.width());
    const std::size_t count = across * tiles(receivers_.height());
    WithThreads(threads, [&] {
      tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
        StopIfInterrupted();
        Tile tile = MakeTile(static_cast<int>(i % across) * kTile,
                             static_cast<int>(i / across) * kTile);
        Render(tile);
      });
    });
    return std::move(result_);
  }

 private:
  [[nodiscard]] Tile MakeTile(int left, int top) {
    Tile tile;
    tile.pixels.reserve(kTilePixels);
    tile.receivers.reserve(kTilePixels);
    const int right = std::min(left + kTile, receivers_.width());
    const int bottom = std::min(top + kTile, receivers_.height());
    for (int y = top; y < bottom; ++y) {
      for (int x = left; x < right; ++x) {
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
      StopIfInterrupted();
    });
    if (other_) Compare(tile);
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
      StopIfInterrupted();
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
      StopIfInterrupted();
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
  Progress& progress_;
  /// Whether contours are described, which takes longest.
  bool is_long_;
  RenderedPixels result_;
};

}  // namespace

RenderedPixels RenderPixels(const Oracle& oracle,
                            const PixelReceivers& receivers,
                            const PixelWishes& wishes, int threads,
                            Progress& progress) {
  return Renderer(oracle, receivers, wishes, progress).Run(threads);
}

}  // namespace truelux
