// SPDX-License-Identifier: GPL-3.0-or-later
#include "truelux/render.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "truelux/picture.h"

#include "bindings.h"
#include "errors.h"
#include "interruptible.h"
#include "oracle_options.h"
#include "progress.h"

namespace py = pybind11;

namespace truelux::python {
namespace {

using Triple = std::array<double, 3>;

Point3 PointOf(const Triple& t) {
  return {t[0], t[1], t[2]};
}

/// An array of one number a pixel, or of three.
py::array_t<double> ArrayOf(const Raster<Rgb>& raster) {
  py::array_t<double> array({py::ssize_t{raster.height()},
                             py::ssize_t{raster.width()}, py::ssize_t{3}});
  double* out = array.mutable_data();
  for (const Rgb& pixel : raster.pixels())
    for (const double channel : pixel)
      *out++ = channel;
  return array;
}

/// f(pixel), one a pixel.
template <class Out, class T, class F>
py::array_t<Out> ArrayBy(const Raster<T>& raster, const F& f) {
  py::array_t<Out> array(
      {py::ssize_t{raster.height()}, py::ssize_t{raster.width()}});
  Out* out = array.mutable_data();
  for (const T& pixel : raster.pixels())
    *out++ = f(pixel);
  return array;
}

py::array_t<double> Triples(const Raster<Receiver>& receivers, bool normals) {
  Raster<Rgb> values(receivers.width(), receivers.height());
  for (std::size_t i = 0; i < receivers.pixels().size(); ++i) {
    const auto& [p, n, face] = receivers.pixels()[i];
    values.pixels()[i] = normals ? Rgb{n.x, n.y, n.z} : Rgb{p.x, p.y, p.z};
  }
  return ArrayOf(values);
}

/// The arrays of what was wished for, by name.
py::dict Arrays(const Rendering& rendering) {
  const RenderedPixels& pixels = rendering.pixels;
  py::dict arrays;
  arrays["irradiance"] = ArrayOf(pixels.image.values);
  arrays["covered"] = ArrayBy<bool>(pixels.image.covered,
                                    [](std::uint8_t c) { return c != 0; });
  arrays["points"] = Triples(rendering.receivers, false);
  arrays["normals"] = Triples(rendering.receivers, true);
  arrays["on_face"] = ArrayBy<std::int64_t>(
      rendering.receivers, [](const Receiver& r) { return r.on_face; });
  if (!pixels.bounds.empty()) arrays["bound"] = ArrayOf(pixels.bounds);
  if (!pixels.differences.empty())
    arrays["difference"] = ArrayOf(pixels.differences);
  if (!pixels.arcs.empty()) {
    arrays["arcs"] = ArrayBy<std::int64_t>(
        pixels.arcs, [](std::int32_t arcs) { return arcs; });
  }
  if (!pixels.classes.empty()) {
    arrays["shadow_class"] = ArrayBy<std::uint8_t>(
        pixels.classes,
        [](ShadowClass c) { return static_cast<std::uint8_t>(c); });
  }
  if (!pixels.gradients.empty()) arrays["gradient"] = ArrayOf(pixels.gradients);
  if (pixels.kinks && !pixels.kinks->is_left_out)
    arrays["kinks"] = ArrayOf(pixels.kinks->lengths);
  return arrays;
}

/// What was rendered, with what false colours need for contours.
struct RenderedScene {
  Rendering rendering;
  PreparedScene scene;
  Choice choice;
  std::optional<std::string> surface;  ///< that all pixels lie on
};

/// surface: a name; or nothing, and camera: eye, target, up, fov.
RenderedScene RenderScene(
    const SharedScene& scene, const Choice& choice,
    const std::optional<std::string>& surface,
    const std::tuple<Triple, Triple, Triple, double>& camera, int width,
    int height, const std::optional<std::string>& on_face,
    const std::vector<std::string>& also, bool bound, const py::object& told) {
  RenderOptions options;
  options.on_face = on_face;
  options.threads = choice.ThreadCount();
  options.progress = HookOf(told);
  options.wishes.bounds = bound;
  for (const ExtraPicture extra : kExtraPictures) {
    if (std::find(also.begin(), also.end(), Name(extra)) != also.end())
      Wish(extra, options.wishes);
  }
  PictureSubject subject;
  if (surface) {
    subject = *surface;
  } else {
    const auto& [eye, target, up, fov] = camera;
    subject = Camera{PointOf(eye), PointOf(target), {up[0], up[1], up[2]}, fov};
  }
  Rendering rendering = Checked([&] {
    const Interruptible interruptible;
    const Oracle oracle(scene.prepared, choice.Options(interruptible.flag()));
    return Render(oracle, subject, {width, height}, options);
  });
  return {std::move(rendering), scene.prepared, choice,
          on_face ? std::nullopt : surface};
}

/// The bytes of the picture's file, and notes.
std::pair<py::bytes, py::list> PictureBytes(
    const RenderedScene& rendered, bool is_exr,
    const std::vector<std::pair<std::string, std::string>>& texts,
    std::optional<double> white, bool false_colour, bool isolux,
    const std::optional<std::string>& channel) {
  PictureStyle style;
  style.is_exr = is_exr;
  for (const auto& [name, text] : texts)
    style.texts.push_back({name, text});
  style.white = white;
  style.false_colour = false_colour;
  style.isolux = isolux;
  style.channel = ChannelOf(channel);
  const IrradianceImage& image = rendered.rendering.pixels.image;
  if (false_colour && isolux && rendered.surface) {
    style.contours = Checked([&] {
      const Interruptible interruptible;
      const Oracle oracle(rendered.scene,
                          rendered.choice.Options(interruptible.flag()));
      return PictureContoursOf(oracle, *rendered.surface, image, style,
                               rendered.choice.ThreadCount());
    });
  }
  Picture picture;
  {
    const py::gil_scoped_release unlocked;
    picture = PictureOf(image, style);
  }
  return {py::bytes(picture.bytes), MessagesOf(picture.notes)};
}

/// which: a name of kExtraPictures.
py::bytes ExtraBytes(const RenderedScene& rendered, const std::string& which,
                     const std::optional<std::string>& channel) {
  for (const ExtraPicture extra : kExtraPictures) {
    if (which == Name(extra)) {
      return py::bytes(
          ExtraPictureOf(extra, rendered.rendering.pixels, ChannelOf(channel)));
    }
  }
  throw std::logic_error("an extra picture without a name");
}

}  // namespace

void BindRender(py::module_& module) {
  py::class_<RenderedScene>(module, "Rendering")
      .def("arrays", [](const RenderedScene& r) { return Arrays(r.rendering); })
      .def("notes",
           [](const RenderedScene& r) { return MessagesOf(r.rendering.notes); })
      .def("picture", PictureBytes)
      .def("extra", ExtraBytes);
  module.def("render", RenderScene);
  std::vector<std::string> names;
  for (int k = 0; k < kShadowClassCount; ++k)
    names.emplace_back(Name(static_cast<ShadowClass>(k)));
  module.attr("SHADOW_CLASSES") = names;
  std::vector<std::string> extras;
  for (const ExtraPicture extra : kExtraPictures)
    extras.emplace_back(Name(extra));
  module.attr("EXTRA_PICTURES") = extras;
}

}  // namespace truelux::python
