// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cmd_render.h"

#include <algorithm>
#include <cstdint>
#include <deque>
#include <memory>

#include "cli/loading.h"
#include "image/extra_picture.h"
#include "image/picture.h"
#include "image/picture_view.h"
#include "image/pixel_table.h"
#include "image/pixels_on_faces.h"
#include "image/render_pixels.h"
#include "run/interrupt.h"
#include "run/messages.h"
#include "run/output_file.h"
#include "run/progress.h"
#include "text/receiver_sample.h"

namespace truelux {
namespace {

RenderedPixels RenderShowingProgress(const Oracle& oracle,
                                     const PixelReceivers& receivers,
                                     const PixelWishes& wishes, int threads) {
  const auto count = static_cast<std::uint64_t>(receivers.width()) *
                     static_cast<std::uint64_t>(receivers.height());
  Progress progress(count, "pixels");
  return RenderPixels(oracle, receivers, wishes, threads, progress);
}

void WritePicture(OutputFile& file, const IrradianceImage& image,
                  const PictureStyle& style) {
  const Picture picture = PictureOf(image, style);
  Print(picture.notes);
  file.Write(picture.bytes);
}

/// What --on-face makes of the receivers; null without it.
std::unique_ptr<PixelReceivers> OnOtherFaces(const Scene& scene,
                                             const PixelReceivers& shown,
                                             const RenderRequest& request) {
  if (!request.on_face) return nullptr;
  FaceWords words(scene);
  const FaceChoice choice = OnFaceOf(request.on_face, words);
  Progress progress(static_cast<std::uint64_t>(shown.height()), "rows");
  auto pixels = std::make_unique<PixelsOnFaces>(scene, shown, choice,
                                                request.threads, progress);
  NoteFoundFaces(pixels->found());
  return pixels;
}

/// Names are given at the very end, when nothing can fail but the naming.
void Commit(std::deque<OutputFile>& files) {
  for (OutputFile& file : files)
    file.Finish();
  StopIfInterrupted();
  for (OutputFile& file : files)
    file.Commit();
}

/// No black picture without a word.
void NoteDarkness(const Scene& scene, const PixelReceivers& receivers,
                  const IrradianceImage& image) {
  const auto is_dark = [](const Rgb& value) { return value == Rgb{}; };
  if (!std::ranges::all_of(image.values.pixels(), is_dark)) return;
  ReceiverSample sample;
  for (int y = 0; y < receivers.height(); ++y) {
    for (int x = 0; x < receivers.width(); ++x) {
      if (const auto receiver = receivers.At(x, y)) sample.Take(*receiver);
    }
  }
  if (!sample.kept().empty()) NoteDarkness(scene, sample.kept());
}

}  // namespace

ExitStatus RunRender(const RenderArguments& arguments) {
  const RenderRequest request = ParseRenderRequest(arguments);
  CheckOutputs(request.outputs);
  // Opened before the long work, so that a bad path is known at once.
  std::deque<OutputFile> files;
  for (const OutputPath& output : request.outputs)
    files.emplace_back(output.path);

  const Oracle oracle(LoadScene(request.scene, request.outputs),
                      request.options);
  const PictureFrame frame = FrameOf(oracle.scene(), request.subject);
  Print(frame.notes);
  const std::unique_ptr<PixelReceivers> shown =
      ReceiversOf(oracle.scene(), frame, request.size);
  const std::unique_ptr<PixelReceivers> other =
      OnOtherFaces(oracle.scene(), *shown, request);
  const PixelReceivers& receivers = other ? *other : *shown;
  const RenderedPixels pixels =
      RenderShowingProgress(oracle, receivers, request.wishes, request.threads);

  NoteDarkness(oracle.scene(), receivers, pixels.image);
  auto file = files.begin();
  WritePicture(*file++, pixels.image, request.style);
  if (request.receivers_out)
    WritePixelReceivers(*file++, receivers, pixels.image);
  if (request.values) WritePixelValues(*file++, pixels, request.options.method);
  for (const ExtraPicture extra : request.also) {
    StopIfInterrupted();
    (file++)->Write(ExtraPictureOf(extra, pixels, request.style.channel));
  }
  Commit(files);
  return ExitStatus::kDone;
}

}  // namespace truelux
