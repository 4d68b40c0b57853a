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
  const void* pixels = picture.pixels().data();
  png_alloc_size_t size = 0;
  std::string bytes;
  // Compresses twice: the first time only to learn the size.
  if (png_image_write_get_memory_size(image, size, 0, pixels, 0, nullptr) !=
      0) {
    bytes.resize(size);
    if (png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels, 0,
                                  nullptr) != 0) {
      return bytes;
    }
  }
  throw std::runtime_error(std::string("PNG: ") + image.message);
}

}  // namespace truelux
