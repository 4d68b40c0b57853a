#include "cli/cmd_render.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <fmt/format.h>
#include <memory>
#include <string>
#include <vector>

#include "cli/loading.h"
#include "cli/render_pictures.h"
#include "cli/render_view.h"
#include "image/pixel_table.h"
#include "image/render_pixels.h"
#include "run/interrupt.h"
#include "run/messages.h"
#include "run/output_file.h"
#include "run/progress.h"

namespace truelux {
namespace {

/// Writes a table of pixels: append(text, x, y) adds the row of a pixel with a
/// receiver.
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

void WriteReceivers(OutputFile& file, const PixelReceivers& receivers,
                    const IrradianceImage& image) {
  WriteTable(file, PixelReceiverHeader(), image,
             [&](std::string& text, int x, int y) {
               AppendPixelReceiver(text, x, y, *receivers.At(x, y));
             });
}

void WriteValues(OutputFile& file, const RenderedPixels& pixels,
                 Method method) {
  WriteTable(file, PixelValueHeader(method), pixels.image,
             [&](std::string& text, int x, int y) {
               const Rgb bound =
                   pixels.bounds.empty() ? Rgb{} : pixels.bounds.At(x, y);
               AppendPixelValue(text, x, y, pixels.image.values.At(x, y), bound,
                                method);
             });
}

PixelWishes WishesOf(const RenderRequest& request, const Oracle& oracle) {
  PixelWishes wishes;
  wishes.bounds =
      request.options.method == Method::kDouble && !request.values.empty();
  wishes.arcs = request.Wants(ExtraImage::kArcs);
  wishes.classes = request.Wants(ExtraImage::kClass);
  if (request.Wants(ExtraImage::kError)) {
    OracleOptions options = request.options;
    options.method = options.method == Method::kDouble ? Method::kCertified
                                                       : Method::kDouble;
    wishes.other.emplace(oracle.scene(), options);
  }
  return wishes;
}

void NoteOverflows(const IrradianceImage& image) {
  const auto count =
      std::ranges::count_if(image.values.pixels(), [](const Rgb& value) {
        return std::ranges::any_of(value,
                                   [](double e) { return std::isinf(e); });
      });
  if (count == 0) return;
  PrintNote(
      fmt::format("{} pixel{} an irradiance too large for binary64, taken as "
                  "infinite",
                  count, count == 1 ? " has" : "s have"));
}

}  // namespace

ExitStatus RunRender(const RenderArguments& arguments) {
  const RenderRequest request = ParseRenderRequest(arguments);
  const OutputPaths outputs = request.Outputs();
  CheckOutputs(outputs);
  // Opened before the long work, so that a bad path is known at once.
  std::deque<OutputFile> files;
  for (const OutputPath& output : outputs)
    files.emplace_back(output.path);

  const Oracle oracle(LoadScene(request.scene, outputs), request.options);
  const std::unique_ptr<PixelReceivers> receivers =
      ReceiversOf(request, oracle.scene());
  const PixelWishes wishes = WishesOf(request, oracle);
  RenderedPixels pixels;
  {
    const auto count = static_cast<std::uint64_t>(receivers->width()) *
                       static_cast<std::uint64_t>(receivers->height());
    Progress progress(count, "pixels");
    pixels =
        RenderPixels(oracle, *receivers, wishes, request.threads, progress);
  }
  NoteOverflows(pixels.image);

  auto file = files.begin();
  (file++)->Write(PictureOf(request, pixels));
  if (!request.receivers_out.empty())
    WriteReceivers(*file++, *receivers, pixels.image);
  if (!request.values.empty())
    WriteValues(*file++, pixels, request.options.method);
  for (const ExtraImage image : request.also) {
    StopIfInterrupted();
    (file++)->Write(ExtraPictureOf(request, image, pixels));
  }
  // Names are given at the very end, when nothing can fail but the naming.
  for (OutputFile& output : files)
    output.Finish();
  StopIfInterrupted();
  for (OutputFile& output : files)
    output.Commit();
  return ExitStatus::kDone;
}

}  // namespace truelux
