// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <vector>

#include "cli/cmd_render.h"
#include "cli/commands.h"
#include "cli/input_arguments.h"
#include "cli/option_table.h"
#include "cli/oracle_arguments.h"

namespace truelux {
namespace {

constexpr const char* kDescription =
    "Pictures of a scene, one irradiance a pixel";

constexpr const char* kFilesHelp =
    "Of a surface: its axes are u = v1 - v0 and v = v_last - v0 of its first\n"
    "face, its extent the least and greatest coordinates of its corners along\n"
    "them. The first row is at the greatest v; pixels off the surface are\n"
    "transparent. Through a camera: each pixel shows the first face along its\n"
    "ray, from the side that the camera sees; where there is none it is\n"
    "transparent.\n"
    "\n"
    "An EXR file holds E [W/m^2] as binary32: the certified binary64 rounded\n"
    "once more. --values has all its digits. A PNG is a picture: E by the\n"
    "white level and the sRGB curve, or with --false-colour one channel by\n"
    "colours of even steps, with a scale beside it and isolux lines.\n"
    "--receivers-out has what eval and compare need to repeat every pixel.\n"
    "A pixel lies on the face that it shows, unless --on-face names another.\n";

constexpr const char* kExamples =
    "Examples:\n"
    "  truelux render room.obj --surface floor -o floor.exr --values "
    "floor.csv\n"
    "  truelux render room.obj --surface floor --size 512 -o floor.png \\\n"
    "      --false-colour --also class\n"
    "  truelux render room.obj --eye 0,1,5 --target 0,1,0 --up 0,1,0 --fov 40 "
    "\\\n"
    "      --size 640x480 -o room.png\n";

std::vector<OptionRow> ViewOptions(RenderArguments& arguments) {
  return {
      {.name = "--surface",
       .target = &arguments.surface,
       .value = "NAME",
       .help = "the object or group that is pictured; its faces must be\n"
               "exactly coplanar"},
      {.name = "--eye",
       .target = &arguments.eye,
       .value = "x,y,z",
       .help = "a camera: where it is"},
      {.name = "--target",
       .target = &arguments.target,
       .value = "x,y,z",
       .help = "the point in the middle of its picture"},
      {.name = "--up",
       .target = &arguments.up,
       .value = "x,y,z",
       .help = "what is up in its picture"},
      {.name = "--fov",
       .target = &arguments.fov,
       .value = "DEGREES",
       .help = "the angle from the lower to the upper edge [degrees]"},
      OnFaceOption(arguments.on_face),
      {.name = "--size",
       .target = &arguments.size,
       .value = "WxH|W",
       .help = "pixels; W alone makes a surface's pixels square, and a "
               "camera's\n"
               "picture",
       .show_default = true},
  };
}

std::vector<OptionRow> OutputOptions(RenderArguments& arguments) {
  return {
      {.name = "-o,--output",
       .target = &arguments.output,
       .value = "FILE.exr|FILE.png",
       .help = "the picture, by its ending",
       .required = true},
      {.name = "--values",
       .target = &arguments.values,
       .value = "FILE.csv",
       .help = "the values of all pixels, as eval writes them"},
      {.name = "--receivers-out",
       .target = &arguments.receivers_out,
       .value = "FILE.csv",
       .help = "the receivers of all pixels, as eval reads them"},
      {.name = "--also",
       .target = &arguments.also,
       .help =
           "a further picture FILE_error.png, FILE_arcs.png,\n"
           "FILE_class.png or FILE_gradient.png: |double - certified|, the\n"
           "number of arcs of the visible contour, or lit, umbra, penumbra,\n"
           "conjunctive, or the length of the tangential gradient, of a\n"
           "surface with lines where the gradient jumps; may be given for\n"
           "each",
       .choices = {"error", "arcs", "class", "gradient"}},
      {.name = "--resume",
       .target = &arguments.resume,
       .help =
           "keep the pixels that are done in FILE.part, of the picture's\n"
           "name, and go on from it if it is there; give it from the first\n"
           "run on"},
  };
}

std::vector<OptionRow> ColourOptions(RenderArguments& arguments) {
  return {
      {.name = "--exposure",
       .target = &arguments.exposure,
       .value = "STOPS",
       .help = "of a PNG: white is 2^-STOPS W/m^2"},
      {.name = "--white",
       .target = &arguments.white,
       .value = "E",
       .help = "of a PNG: the irradiance shown as white, or at the top of\n"
               "the scale [W/m^2]; by default the 99 % quantile, and the\n"
               "largest value of a scale"},
      {.name = "--false-colour",
       .target = &arguments.false_colour,
       .help = "of a PNG: one channel by colour, with a scale and isolux\n"
               "lines"},
      {.name = "--no-isolux",
       .target = &arguments.no_isolux,
       .help = "with --false-colour: no lines"},
      {.name = "--channel",
       .target = &arguments.channel,
       .help = "with --false-colour and --also error: what is shown; by\n"
               "default luminance, 0.2126 r + 0.7152 g + 0.0722 b, and of\n"
               "errors the largest",
       .choices = {"luminance", "r", "g", "b"}},
  };
}

std::vector<OptionRow> OptionsOf(RenderArguments& arguments) {
  std::vector<OptionRow> all = {SceneArgument(arguments.scene)};
  for (const std::vector<OptionRow>& rows :
       {ViewOptions(arguments), OutputOptions(arguments),
        ColourOptions(arguments)}) {
    all.insert(all.end(), rows.begin(), rows.end());
  }
  all.push_back(MethodOption(arguments.method));
  all.push_back(EngineOption(arguments.engine));
  all.push_back(EmissionOption(arguments.emission));
  all.push_back(ThreadsOption(arguments.threads));
  return all;
}

}  // namespace

Command RenderCommand() {
  const auto arguments = std::make_shared<RenderArguments>();
  arguments->size = "512";
  return {.name = "render",
          .summary = kDescription,
          .details = kFilesHelp,
          .examples = kExamples,
          .options = WithSceneOptions(OptionsOf(*arguments), arguments->scene),
          .run = [arguments] { return RunRender(*arguments); }};
}

}  // namespace truelux
