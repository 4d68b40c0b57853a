#include <CLI/CLI.hpp>
#include <string>

#include "cli/cmd_inspect.h"
#include "cli/input_arguments.h"
#include "cli/oracle_arguments.h"
#include "inspect/view_svg.h"

namespace truelux {
namespace {

constexpr const char* kDescription =
    "All that one receiver sees, as a picture and as numbers";

constexpr const char* kViewHelp =
    "Draws the hemisphere above a receiver: what of sources, of blockers and "
    "of\n"
    "nothing is visible where, the edges in between, and the vertices where\n"
    "edges meet: intrinsic, apparent, on the horizon, conjunctive (with the\n"
    "number of edges that coincide exactly). In a browser, regions, arcs and\n"
    "vertices tell under the pointer which faces and edges of the scene they\n"
    "are. The view is exact; only what is drawn and written is rounded. It is\n"
    "made for looking at one receiver: seconds for thousands of triangles.\n";

constexpr const char* kExamples =
    "Examples:\n"
    "  truelux inspect room.obj --at 1,0,2 --normal 0,1,0 -o view.svg\n"
    "  truelux inspect room.obj --at 1,0,2 --normal 0,1,0 --on-face 7 \\\n"
    "      --projection gnomonic -o view.svg --json view.json\n"
    "  truelux inspect room.obj --at 1,0,2 --normal 0,1,0 --json - | jq "
    ".sources\n";

void AddOutputs(CLI::App& command, InspectArguments& arguments) {
  command
      .add_option("-o,--output", arguments.output,
                  "the picture; - is standard output")
      ->type_name("VIEW.svg");
  command
      .add_option("--json", arguments.json,
                  "regions, arcs, vertices, and each source's form factor and\n"
                  "solid angle; - is standard output")
      ->type_name("FILE.json");
  arguments.projection = Name(ViewPicture().projection);
  AddChoice(command, "--projection", arguments.projection,
            {Name(ViewProjection::kNusselt), Name(ViewProjection::kGnomonic)},
            "nusselt: a disc in which area is irradiance; gnomonic: an image\n"
            "plane with straight edges, cut 80 degrees from the normal");
  arguments.size = std::to_string(ViewPicture().width);
  AddWord(command, "--size", arguments.size,
          "width of the picture with its legend")
      .type_name("PIXELS");
}

}  // namespace

void AddInspectCommand(CLI::App& app, InspectArguments& arguments) {
  CLI::App& command = *app.add_subcommand("inspect", kDescription);
  AddSceneArgument(command, arguments.scene);
  command.add_option("--at", arguments.at, "the receiver: its point")
      ->type_name("x,y,z")
      ->required();
  command.add_option("--normal", arguments.normal, "its normal")
      ->type_name("nx,ny,nz")
      ->required();
  command
      .add_option("--on-face", arguments.on_face,
                  "the face on which the point lies, by its number: that face\n"
                  "and all in its plane are not seen")
      ->type_name("N");
  AddOutputs(command, arguments);
  AddEmissionOption(command, arguments.emission);
  command.footer(std::string(kViewHelp) + "\n" + kExamples + "\n" +
                 kExitStatusHelp);
}

}  // namespace truelux
