// SPDX-License-Identifier: GPL-3.0-or-later
// Images of OpenEXR as arrays, for maps of positions, normals and irradiances.

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <cstddef>
#include <exception>
#include <map>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <string>
#include <vector>

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

/// All channels by their names, shape (height, width), as binary32.
std::map<std::string, Channel> ReadExr(const std::string& path) {
  try {
    Imf::InputFile file(path.c_str());
    const Imath::Box2i window = file.header().dataWindow();
    const int width = window.max.x - window.min.x + 1;
    const int height = window.max.y - window.min.y + 1;
    std::map<std::string, Channel> channels;
    Imf::FrameBuffer buffer;
    const Imf::ChannelList& list = file.header().channels();
    for (auto c = list.begin(); c != list.end(); ++c) {
      if (c.channel().xSampling != 1 || c.channel().ySampling != 1) continue;
      Channel pixels({py::ssize_t{height}, py::ssize_t{width}});
      buffer.insert(c.name(), SliceOf(pixels.mutable_data(), window, width));
      channels.emplace(c.name(), std::move(pixels));
    }
    file.setFrameBuffer(buffer);
    file.readPixels(window.min.y, window.max.y);
    return channels;
  } catch (const std::exception& defect) {
    throw InputError({path + ": " + defect.what()});
  }
}

/// channels: at least one, all of one shape that is not empty.
void WriteExr(const std::string& path,
              std::map<std::string, Channel> channels) {
  const auto height = static_cast<int>(channels.begin()->second.shape(0));
  const auto width = static_cast<int>(channels.begin()->second.shape(1));
  Imf::Header header(width, height);
  header.compression() = Imf::ZIP_COMPRESSION;
  Imf::FrameBuffer buffer;
  for (auto& [name, pixels] : channels) {
    header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    buffer.insert(name,
                  SliceOf(pixels.mutable_data(), header.dataWindow(), width));
  }
  try {
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(buffer);
    file.writePixels(height);
  } catch (const std::exception& defect) {
    throw InputError({path + ": " + defect.what()});
  }
}

}  // namespace

void BindExr(py::module_& module) {
  module.def("read_exr", ReadExr);
  module.def("write_exr", WriteExr);
}

}  // namespace truelux::python
