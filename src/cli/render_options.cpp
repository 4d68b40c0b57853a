#include <CLI/CLI.hpp>
#include <string>

#include "cli/cmd_render.h"
#include "cli/input_arguments.h"
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
    "--receivers-out has what eval and compare need to repeat every pixel.\n";

constexpr const char* kExamples =
    "Examples:\n"
    "  truelux render room.obj --surface floor -o floor.exr --values "
    "floor.csv\n"
    "  truelux render room.obj --surface floor --size 512 -o floor.png \\\n"
    "      --false-colour --also class\n"
    "  truelux render room.obj --eye 0,1,5 --target 0,1,0 --up 0,1,0 --fov 40 "
    "\\\n"
    "      --size 640x480 -o room.png\n";

void AddView(CLI::App& command, RenderArguments& arguments) {
  command
      .add_option("--surface", arguments.surface,
                  "the object or group that is pictured; its faces must be\n"
                  "exactly coplanar")
      ->type_name("NAME");
  command.add_option("--eye", arguments.eye, "a camera: where it is")
      ->type_name("x,y,z");
  command
      .add_option("--target", arguments.target,
                  "the point in the middle of its picture")
      ->type_name("x,y,z");
  command.add_option("--up", arguments.up, "what is up in its picture")
      ->type_name("x,y,z");
  command
      .add_option("--fov", arguments.fov,
                  "the angle from the lower to the upper edge [degrees]")
      ->type_name("DEGREES");
  arguments.size = "512";
  AddWord(command, "--size", arguments.size,
          "pixels; W alone makes a surface's pixels square, and a camera's\n"
          "picture")
      .type_name("WxH|W");
}

void AddOutputs(CLI::App& command, RenderArguments& arguments) {
  command
      .add_option("-o,--output", arguments.output, "the picture, by its ending")
      ->type_name("FILE.exr|FILE.png")
      ->required();
  command
      .add_option("--values", arguments.values,
                  "the values of all pixels, as eval writes them")
      ->type_name("FILE.csv");
  command
      .add_option("--receivers-out", arguments.receivers_out,
                  "the receivers of all pixels, as eval reads them")
      ->type_name("FILE.csv");
  command
      .add_option(
          "--also", arguments.also,
          "a further picture FILE_error.png, FILE_arcs.png or\n"
          "FILE_class.png: |double - certified|, the number of arcs of\n"
          "the visible contour, or lit, umbra, penumbra, conjunctive;\n"
          "may be given for each")
      ->type_name("error|arcs|class")
      ->check(CLI::IsMember({"error", "arcs", "class"}).description(""))
      ->expected(1)
      ->take_all();
}

void AddColours(CLI::App& command, RenderArguments& arguments) {
  command
      .add_option("--exposure", arguments.exposure,
                  "of a PNG: white is 2^-STOPS W/m^2")
      ->type_name("STOPS");
  command
      .add_option("--white", arguments.white,
                  "of a PNG: the irradiance shown as white, or at the top of\n"
                  "the scale [W/m^2]; by default the 99 % quantile, and the\n"
                  "largest value of a scale")
      ->type_name("E");
  command.add_flag("--false-colour", arguments.false_colour,
                   "of a PNG: one channel by colour, with a scale and isolux\n"
                   "lines");
  command.add_flag("--no-isolux", arguments.no_isolux,
                   "with --false-colour: no lines");
  command
      .add_option("--channel", arguments.channel,
                  "with --false-colour and --also error: what is shown; by\n"
                  "default luminance, 0.2126 r + 0.7152 g + 0.0722 b, and of\n"
                  "errors the largest")
      ->type_name("luminance|r|g|b")
      ->check(CLI::IsMember({"luminance", "r", "g", "b"}).description(""));
}

}  // namespace

void AddRenderCommand(CLI::App& app, RenderArguments& arguments) {
  CLI::App& command = *app.add_subcommand("render", kDescription);
  AddSceneArgument(command, arguments.scene);
  AddView(command, arguments);
  AddOutputs(command, arguments);
  AddColours(command, arguments);
  AddMethodOption(command, arguments.method);
  AddEngineOption(command, arguments.engine);
  AddEmissionOption(command, arguments.emission);
  AddThreadsOption(command, arguments.threads);
  command.footer(std::string(kFilesHelp) + "\n" + kExamples + "\n" +
                 kExitStatusHelp);
}

}  // namespace truelux
