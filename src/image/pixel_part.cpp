// SPDX-License-Identifier: GPL-3.0-or-later
#include "image/pixel_part.h"

#include <cerrno>
#include <charconv>
#include <cstring>
#include <string_view>
#include <type_traits>

#include "run/user_error.h"

namespace truelux {
namespace {

/// Calls visit(raster) for every raster that has pixels.
template <class Pixels, class Visit>
void ForEachRaster(Pixels& pixels, const Visit& visit) {
  const auto visit_filled = [&](auto& raster) {
    if (!raster.empty()) visit(raster);
  };
  visit_filled(pixels.image.values);
  visit_filled(pixels.image.covered);
  visit_filled(pixels.bounds);
  visit_filled(pixels.differences);
  visit_filled(pixels.arcs);
  visit_filled(pixels.classes);
  visit_filled(pixels.gradients);
}

std::string BytesOf(const TileArea& area, const RenderedPixels& pixels) {
  std::string bytes;
  ForEachRaster(pixels, [&](const auto& raster) {
    for (int y = area.top; y < area.bottom; ++y) {
      for (int x = area.left; x < area.right; ++x) {
        const auto& value = raster.At(x, y);
        static_assert(
            std::is_trivially_copyable_v<std::remove_cvref_t<decltype(value)>>);
        bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
      }
    }
  });
  return bytes;
}

/// Whether the bytes are just as many as the tile has.
bool SetBytes(const TileArea& area, std::string_view bytes,
              RenderedPixels& pixels) {
  bool fits = true;
  ForEachRaster(pixels, [&](auto& raster) {
    for (int y = area.top; y < area.bottom; ++y) {
      for (int x = area.left; x < area.right; ++x) {
        auto& value = raster.At(x, y);
        fits = fits && bytes.size() >= sizeof value;
        if (!fits) return;
        std::memcpy(&value, bytes.data(), sizeof value);
        bytes.remove_prefix(sizeof value);
      }
    }
  });
  return fits && bytes.empty();
}

std::size_t TileOf(const std::string& note) {
  std::size_t tile = 0;
  std::from_chars(note.data(), note.data() + note.size(), tile);
  return tile;
}

}  // namespace

PixelPart::PixelPart(const std::string& path, const std::string& key,
                     TileGrid grid)
    : grid_(grid), file_(path, key, [this](const std::string& note) {
        Count(TileOf(note));
      }) {}

void PixelPart::Count(std::size_t tile) {
  tiles_.push_back(tile);
  if (tile >= grid_.size()) return;
  const TileArea area = grid_[tile];
  done_ += static_cast<std::uint64_t>(area.right - area.left) *
           static_cast<std::uint64_t>(area.bottom - area.top);
}

std::vector<bool> PixelPart::Restore(RenderedPixels& pixels) const {
  std::vector<bool> restored(grid_.size(), false);
  std::size_t block = 0;
  file_.ForEach([&](std::string_view bytes) {
    const std::size_t tile = tiles_[block++];
    if (tile >= restored.size() || !SetBytes(grid_[tile], bytes, pixels))
      throw UserError(file_.path(), "cannot read", EIO);
    restored[tile] = true;
  });
  return restored;
}

void PixelPart::Take(std::size_t tile, const RenderedPixels& pixels) {
  const std::string bytes = BytesOf(grid_[tile], pixels);
  const std::scoped_lock lock(mutex_);
  file_.Append(bytes, std::to_string(tile));
  Count(tile);
}

}  // namespace truelux
