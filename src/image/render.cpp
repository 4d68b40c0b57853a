// SPDX-License-Identifier: GPL-3.0-or-later
#include "truelux/render.h"

#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "image/picture_contours.h"
#include "image/picture_view.h"
#include "image/pixels_on_faces.h"
#include "image/render_frame.h"
#include "run/parallel.h"
#include "text/face_choice.h"

namespace truelux {
namespace {

void Check(const Oracle& oracle, const RenderOptions& options) {
  CheckThreads(options.threads);
  if (options.wishes.differences &&
      oracle.options().engine == Engine::kAngularSpans) {
    throw std::invalid_argument(
        "differences: they are of two sums over arcs; the engine angular-spans "
        "has none");
  }
}

/// What on_face makes of the receivers; null without it.
std::unique_ptr<PixelReceivers> OnOtherFaces(const Scene& scene,
                                             const PixelReceivers& shown,
                                             const RenderOptions& options,
                                             const Watch& watch,
                                             std::vector<Diagnostic>& notes) {
  if (!options.on_face) return nullptr;
  FaceWords words(scene);
  std::string defect = "the text is empty";
  const auto choice = options.on_face->empty()
                          ? std::nullopt
                          : words.Parse(*options.on_face, defect);
  if (!choice) throw std::invalid_argument("on_face: " + defect);
  auto pixels = std::make_unique<PixelsOnFaces>(scene, shown, *choice,
                                                options.threads, watch);
  const std::string found = FoundFacesText(pixels->found());
  if (!found.empty())
    notes.push_back({Severity::kNote, "", 0, "on_face: " + found});
  return pixels;
}

Raster<Receiver> AllOf(const PixelReceivers& receivers) {
  Raster<Receiver> all(receivers.width(), receivers.height());
  for (int y = 0; y < receivers.height(); ++y) {
    for (int x = 0; x < receivers.width(); ++x) {
      if (const auto receiver = receivers.At(x, y)) all.At(x, y) = *receiver;
    }
  }
  return all;
}

}  // namespace

Rendering Render(const Oracle& oracle, const PictureSubject& subject,
                 const PictureSize& size, const RenderOptions& options) {
  Check(oracle, options);
  const Watch watch = {.stop = oracle.options().stop, .hook = options.progress};
  PictureFrame frame = FrameOf(oracle.scene(), subject);
  if (size.width < 1 || size.height < 0)
    throw std::invalid_argument("size: expected at least one pixel");
  Rendering rendering;
  rendering.notes = std::move(frame.notes);
  const auto shown = ReceiversOf(oracle.scene(), frame, size);
  const auto other =
      OnOtherFaces(oracle.scene(), *shown, options, watch, rendering.notes);
  const PixelReceivers& receivers = other ? *other : *shown;
  rendering.pixels = RenderFrame(oracle, frame, receivers, options.wishes,
                                 options.threads, nullptr, watch);
  rendering.receivers = AllOf(receivers);
  return rendering;
}

std::vector<PictureContour> PictureContoursOf(const Oracle& oracle,
                                              const std::string& surface,
                                              const IrradianceImage& image,
                                              const PictureStyle& style,
                                              int threads,
                                              const ProgressHook& progress) {
  CheckThreads(threads);
  return FindPictureContours(oracle, surface, image, style, threads,
                             {.stop = oracle.options().stop, .hook = progress});
}

}  // namespace truelux
