// SPDX-License-Identifier: GPL-3.0-or-later
#include "image/pixel_table.h"

#include <fmt/format.h>
#include <string>
#include <utility>

#include "run/interrupt.h"
#include "text/receivers.h"
#include "text/results.h"

namespace truelux {
namespace {

/// append(text, x, y) adds the row of a pixel with a receiver.
template <class Append>
void WriteTable(OutputFile& file, std::string header,
                const IrradianceImage& image, const Append& append) {
  std::string text = std::move(header) + "\n";
  for (int y = 0; y < image.covered.height(); ++y) {
    for (int x = 0; x < image.covered.width(); ++x) {
      if (image.covered.At(x, y) != 0) append(text, x, y);
    }
    file.Write(text);
    text.clear();
    StopIfInterrupted();
  }
}

void AppendReceiver(std::string& text, int x, int y, const Receiver& receiver) {
  const Point3& p = receiver.position;
  const Vector3& n = receiver.normal;
  for (const double number : {p.x, p.y, p.z, n.x, n.y, n.z}) {
    AppendNumber(text, number);
    text += ',';
  }
  text += fmt::format("{},{},{}\n", receiver.on_face, x, y);
}

}  // namespace

void WritePixelReceivers(OutputFile& file, const PixelReceivers& receivers,
                         const IrradianceImage& image) {
  WriteTable(file,
             fmt::format("{},{},px,py", fmt::join(kReceiverColumns, ","),
                         kOnFaceColumn),
             image, [&](std::string& text, int x, int y) {
               AppendReceiver(text, x, y, *receivers.At(x, y));
             });
}

void WritePixelValues(OutputFile& file, const RenderedPixels& pixels,
                      Method method) {
  WriteTable(file, fmt::format("px,py{}", ResultHeader(method)), pixels.image,
             [&](std::string& text, int x, int y) {
               text += fmt::format("{},{}", x, y);
               Irradiance irradiance;
               irradiance.value = pixels.image.values.At(x, y);
               if (!pixels.bounds.empty())
                 irradiance.bound = pixels.bounds.At(x, y);
               AppendResult(text, irradiance, method);
               text += '\n';
             });
}

}  // namespace truelux
