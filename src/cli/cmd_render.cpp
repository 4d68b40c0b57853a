// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cmd_render.h"

#include <algorithm>
#include <deque>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "truelux/picture.h"
#include "truelux/render.h"
#include "truelux/stop.h"

#include "cli/loading.h"
#include "cli/part_key.h"
#include "image/picture_contours.h"
#include "image/picture_view.h"
#include "image/pixel_part.h"
#include "image/pixel_table.h"
#include "image/pixels_on_faces.h"
#include "image/render_frame.h"
#include "image/tile_grid.h"
#include "run/interrupt.h"
#include "run/messages.h"
#include "run/output_file.h"
#include "run/user_error.h"
#include "run/watch.h"
#include "text/receiver_sample.h"

namespace truelux {
namespace {

/// All files that are written, also what --resume keeps.
OutputPaths Outputs(const RenderRequest& request) {
  OutputPaths outputs = request.outputs;
  if (!request.part.empty()) outputs.push_back({"--resume", request.part});
  return outputs;
}

std::string DoneText(const PixelPart& part, const PixelReceivers& receivers) {
  return fmt::format("{} of {} pixels", part.done(), receivers.size());
}

/// What is left of an interrupted run.
void NoteKept(const PixelPart* part, const PixelReceivers& receivers) {
  PrintNote(part == nullptr
                ? "nothing was kept; --resume keeps what is done"
                : fmt::format("{} keeps {}; the same command goes on",
                              part->path(), DoneText(*part, receivers)));
}

RenderedPixels RenderShowingProgress(const Oracle& oracle,
                                     const PictureFrame& frame,
                                     const PixelReceivers& receivers,
                                     const RenderRequest& request,
                                     PixelPart* part) {
  if (part != nullptr && part->done() > 0) {
    PrintNote(fmt::format("{} has {} already", part->path(),
                          DoneText(*part, receivers)));
  }
  try {
    return RenderFrame(oracle, frame, receivers, request.wishes,
                       request.threads, part, UserAtTerminal());
  } catch (const Stopped&) {
    NoteKept(part, receivers);
    throw;
  }
}

/// The arguments of pictures are options here.
template <class F>
auto ByOptions(const F& f) {
  try {
    return f();
  } catch (const std::invalid_argument& error) {
    throw UserError(std::string("--") + error.what());
  }
}

void WritePicture(OutputFile& file, const IrradianceImage& image,
                  const PictureStyle& style) {
  const Picture picture = PictureOf(image, style);
  Print(picture.notes);
  file.Write(picture.bytes);
}

/// With the contours of a surface, if its picture shows some. Pixels on other
/// faces, or of a camera, do not lie on one surface.
PictureStyle StyleWithContours(const Oracle& oracle,
                               const RenderRequest& request,
                               const IrradianceImage& image) {
  PictureStyle style = request.style;
  const auto* surface = std::get_if<std::string>(&request.subject);
  if (style.false_colour && style.isolux && surface != nullptr &&
      !request.on_face) {
    style.contours = FindPictureContours(oracle, *surface, image, style,
                                         request.threads, UserAtTerminal());
  }
  return style;
}

/// What --on-face makes of the receivers; null without it.
std::unique_ptr<PixelReceivers> OnOtherFaces(const Scene& scene,
                                             const PixelReceivers& shown,
                                             const RenderRequest& request) {
  if (!request.on_face) return nullptr;
  FaceWords words(scene);
  const FaceChoice choice = OnFaceOf(request.on_face, words);
  auto pixels = std::make_unique<PixelsOnFaces>(
      scene, shown, choice, request.threads, UserAtTerminal());
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
  CheckOutputs(Outputs(request));
  // Opened before the long work, so that a bad path is known at once.
  std::deque<OutputFile> files;
  for (const OutputPath& output : request.outputs)
    files.emplace_back(output.path);

  std::vector<std::filesystem::path> scene_files;
  const Oracle oracle(LoadScene(request.scene, Outputs(request), &scene_files),
                      request.options);
  const PictureFrame frame =
      ByOptions([&] { return FrameOf(oracle.scene(), request.subject); });
  Print(frame.notes);
  const std::unique_ptr<PixelReceivers> shown = ByOptions(
      [&] { return ReceiversOf(oracle.scene(), frame, request.size); });
  const std::unique_ptr<PixelReceivers> other =
      OnOtherFaces(oracle.scene(), *shown, request);
  const PixelReceivers& receivers = other ? *other : *shown;
  std::optional<PixelPart> part;
  if (!request.part.empty())
    part.emplace(request.part, PartKey(request, scene_files),
                 TileGrid(receivers.width(), receivers.height()));
  const RenderedPixels pixels = RenderShowingProgress(
      oracle, frame, receivers, request, part ? &*part : nullptr);

  NoteDarkness(oracle.scene(), receivers, pixels.image);
  auto file = files.begin();
  WritePicture(*file++, pixels.image,
               StyleWithContours(oracle, request, pixels.image));
  if (request.receivers_out)
    WritePixelReceivers(*file++, receivers, pixels.image);
  if (request.values) WritePixelValues(*file++, pixels, request.options.method);
  for (const ExtraPicture extra : request.also) {
    StopIfInterrupted();
    (file++)->Write(ExtraPictureOf(extra, pixels, request.style.channel));
  }
  Commit(files);
  if (part) part->Remove();
  return ExitStatus::kDone;
}

}  // namespace truelux
