// SPDX-License-Identifier: GPL-3.0-or-later
#include "image/png_image.h"

#include <png.h>
#include <stdexcept>

namespace truelux {
namespace {

static_assert(sizeof(Rgba8) == 4, "pixels go to the library as they are");

}  // namespace

std::string PngImage(const Raster<Rgba8>& picture) {
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(picture.width());
  image.height = static_cast<png_uint_32>(picture.height());
  image.format = PNG_FORMAT_RGBA;
  // The library knows a bound on the size, so that it compresses once.
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0,
                                picture.pixels().data(), 0, nullptr) == 0) {
    throw std::runtime_error(std::string("PNG: ") + image.message);
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace truelux
