// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <string>
#include <vector>

#include "cli/cmd_inspect.h"
#include "cli/commands.h"
#include "cli/input_arguments.h"
#include "cli/option_table.h"
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

std::vector<OptionRow> OptionsOf(InspectArguments& arguments) {
  return {
      SceneArgument(arguments.scene),
      {.name = "--at",
       .target = &arguments.at,
       .value = "x,y,z",
       .help = "the receiver: its point",
       .required = true},
      {.name = "--normal",
       .target = &arguments.normal,
       .value = "nx,ny,nz",
       .help = "its normal",
       .required = true},
      OnFaceOption(arguments.on_face),
      {.name = "-o,--output",
       .target = &arguments.output,
       .value = "VIEW.svg",
       .help = "the picture; - is standard output"},
      {.name = "--json",
       .target = &arguments.json,
       .value = "FILE.json",
       .help = "regions, arcs, vertices, and each source's form factor and\n"
               "solid angle; - is standard output"},
      {.name = "--projection",
       .target = &arguments.projection,
       .help = "nusselt: a disc in which area is irradiance; gnomonic: an "
               "image\n"
               "plane with straight edges, cut 80 degrees from the normal",
       .show_default = true,
       .choices = {Name(ViewProjection::kNusselt),
                   Name(ViewProjection::kGnomonic)}},
      {.name = "--size",
       .target = &arguments.size,
       .value = "PIXELS",
       .help = "width of the picture with its legend",
       .show_default = true},
      EmissionOption(arguments.emission),
  };
}

}  // namespace

Command InspectCommand() {
  const auto arguments = std::make_shared<InspectArguments>();
  arguments->projection = Name(ViewPicture().projection);
  arguments->size = std::to_string(ViewPicture().width);
  return {.name = "inspect",
          .summary = kDescription,
          .details = kViewHelp,
          .examples = kExamples,
          .options = WithSceneOptions(OptionsOf(*arguments), arguments->scene),
          .run = [arguments] { return RunInspect(*arguments); }};
}

}  // namespace truelux
