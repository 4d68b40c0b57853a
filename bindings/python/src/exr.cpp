// SPDX-License-Identifier: GPL-3.0-or-later
// Images of OpenEXR as arrays, for maps of positions, normals and irradiances.

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <string>
#include <utility>
#include <vector>

#include "truelux/picture.h"

#include "bindings.h"
#include "errors.h"

namespace py = pybind11;

namespace truelux::python {
namespace {

using Channel = py::array_t<float, py::array::c_style>;

/// Where OpenEXR finds pixel (x, y) of an array: origin + x step + y row. The
/// window's first pixel is at the array's first entry.
Imf::Slice SliceOf(float* pixels, const Imath::Box2i& window, int width) {
  const std::ptrdiff_t first =
      window.min.x + std::ptrdiff_t{window.min.y} * width;
  return {Imf::FLOAT,
          reinterpret_cast<char*>(pixels) -
              first * static_cast<std::ptrdiff_t>(sizeof(float)),
          sizeof(float), sizeof(float) * static_cast<std::size_t>(width)};
}

/// All channels by their names, shape (height, width), as binary32; and the
/// window's first pixel (x, y).
std::pair<py::dict, std::pair<int, int>> ReadExr(const std::string& path) {
  try {
    Imf::InputFile file(path.c_str());
    const Imath::Box2i window = file.header().dataWindow();
    const int width = window.max.x - window.min.x + 1;
    const int height = window.max.y - window.min.y + 1;
    py::dict channels;
    Imf::FrameBuffer buffer;
    const Imf::ChannelList& list = file.header().channels();
    for (auto c = list.begin(); c != list.end(); ++c) {
      if (c.channel().xSampling != 1 || c.channel().ySampling != 1) continue;
      Channel pixels({py::ssize_t{height}, py::ssize_t{width}});
      buffer.insert(c.name(), SliceOf(pixels.mutable_data(), window, width));
      channels[TextOf(c.name())] = std::move(pixels);
    }
    file.setFrameBuffer(buffer);
    file.readPixels(window.min.y, window.max.y);
    return {std::move(channels), {window.min.x, window.min.y}};
  } catch (const std::exception& defect) {
    throw InputError({path + ": " + defect.what()});
  }
}

/// The bytes of a file with R, G, B, shape (height, width, 3), and A.
py::bytes ExrBytes(
    const py::array_t<double, py::array::c_style>& values,
    const py::array_t<bool, py::array::c_style>& covered,
    const std::vector<std::pair<std::string, std::string>>& texts) {
  const auto height = static_cast<int>(covered.shape(0));
  const auto width = static_cast<int>(covered.shape(1));
  IrradianceImage image{Raster<Rgb>(width, height),
                        Raster<std::uint8_t>(width, height)};
  for (std::size_t i = 0; i < image.values.pixels().size(); ++i) {
    image.covered.pixels()[i] = covered.data()[i] ? 1 : 0;
    for (std::size_t c = 0; c < 3; ++c)
      image.values.pixels()[i][c] = values.data()[3 * i + c];
  }
  PictureStyle style;
  style.is_exr = true;
  for (const auto& [name, text] : texts)
    style.texts.push_back({name, text});
  return py::bytes(PictureOf(image, style).bytes);
}

}  // namespace

void BindExr(py::module_& module) {
  module.def("read_exr", ReadExr);
  module.def("exr_bytes", ExrBytes);
}

}  // namespace truelux::python
