#include "image/png_image.h"

#include <cstdio>
#include <cstdlib>
#include <png.h>
#include <stdexcept>

namespace truelux {
namespace {

static_assert(sizeof(Rgba8) == 4, "pixels go to the library as they are");

/// A stdio stream into memory.
class MemoryFile {
 public:
  MemoryFile() : file_(open_memstream(&bytes_, &size_)) {
    if (file_ == nullptr) throw std::runtime_error("no memory for a picture");
  }

  ~MemoryFile() {
    Close();
    std::free(bytes_);
  }

  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  [[nodiscard]] std::FILE* file() { return file_; }

  /// Ends writing.
  std::string Take() {
    if (!Close()) throw std::runtime_error("no memory for a picture");
    return {bytes_, size_};
  }

 private:
  bool Close() {
    const bool is_good = file_ == nullptr || std::fclose(file_) == 0;
    file_ = nullptr;
    return is_good;
  }

  char* bytes_ = nullptr;
  std::size_t size_ = 0;
  std::FILE* file_;
};

}  // namespace

std::string PngImage(const Raster<Rgba8>& picture) {
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(picture.width());
  image.height = static_cast<png_uint_32>(picture.height());
  image.format = PNG_FORMAT_RGBA;
  MemoryFile file;
  if (png_image_write_to_stdio(&image, file.file(), 0, picture.pixels().data(),
                               0, nullptr) == 0) {
    throw std::runtime_error(std::string("PNG: ") + image.message);
  }
  return file.Take();
}

}  // namespace truelux
