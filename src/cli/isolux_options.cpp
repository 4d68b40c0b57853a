// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <vector>

#include "cli/cmd_isolux.h"
#include "cli/commands.h"
#include "cli/input_arguments.h"
#include "cli/isolux_request.h"
#include "cli/option_table.h"
#include "cli/oracle_arguments.h"

namespace truelux {
namespace {

constexpr const char* kDescription =
    "Contours of irradiance on a flat surface, each vertex certified";

constexpr const char* kFilesHelp =
    "A vertex comes with its transversal, the segment from at - half_width\n"
    "across to at + half_width across: E was found, certified, below the "
    "level\n"
    "at the first end and above it at the second, so that the contour passes\n"
    "there. What is larger is on the left of a contour as seen from the lit\n"
    "side. Contours that were not found lie in open triangles, which .json "
    "and\n"
    "the pictures show; notes on standard error say how many there are.\n"
    "\n"
    "An output is written by its ending:\n"
    "  .csv   contour,level,closed,vertex,x,y,z,half_width,across_x,across_y,\n"
    "         across_z,certified,on,chord; chord is how far the contour is at\n"
    "         most from the chord that begins at the vertex\n"
    "  .json  all there is: levels, contours, lines, open triangles, areas\n"
    "  .svg   a plan with a legend, the levels in gaps of the lines, and the\n"
    "         objects above the surface as they are seen from above\n"
    "  .dxf   for CAD, release 12: a layer a level, LEVEL_0_5 for 0.5, and\n"
    "         OUTLINE, JUMPS, KINKS, OPEN, in the scene's frame\n"
    "  .obj   a mesh whose edges follow all these lines, E as vt E 0\n"
    "  .ply   the same with E,E_r,E_g,E_b at vertices\n"
    "  .vtu   the same for VTK and ParaView; notes say how wrong it is to\n"
    "         interpolate in the mesh, beside a uniform one\n"
    "docs/isolux.md tells what is proven and how.\n";

constexpr const char* kExamples =
    "Examples:\n"
    "  truelux isolux room.obj --surface floor -o floor.svg\n"
    "  truelux isolux room.obj --surface floor --levels 0.1,0.2,0.5 \\\n"
    "      -o floor.dxf -o floor.json --lines lines.csv\n"
    "  truelux isolux room.obj --surface floor --count 0 --lines lines.csv \\\n"
    "      --extrema extrema.csv\n";

std::vector<OptionRow> OptionsOf(IsoluxArguments& arguments) {
  return {
      SceneArgument(arguments.scene),
      {.name = "--surface",
       .target = &arguments.surface,
       .value = "NAME",
       .help = "the object or group; its faces must be exactly coplanar",
       .required = true},
      {.name = "--levels",
       .target = &arguments.levels,
       .value = "E,...",
       .help = "the levels [W/m^2], ascending and above 0"},
      {.name = "--count",
       .target = &arguments.count,
       .value = "N",
       .help =
           "instead of them: so many between the least and the largest\n"
           "value that is met, by default 10; 0: no contours, only --lines\n"
           "and --extrema"},
      {.name = "--channel",
       .target = &arguments.channel,
       .help = "what contours are of; by default luminance, 0.2126 r +\n"
               "0.7152 g + 0.0722 b, or, if all faces emit grey, their one\n"
               "value",
       .choices = {"luminance", "r", "g", "b"}},
      {.name = "-o,--output",
       .target = &arguments.outputs,
       .value = "FILE",
       .help = "where to write, by the endings above; may be given more than\n"
               "once; - is standard output, a table, and the default"},
      {.name = "--lines",
       .target = &arguments.lines,
       .value = "FILE.csv",
       .help = "the lines across which irradiance or its gradient jumps:\n"
               "kind,x0,y0,z0,x1,y1,z1, then b_r,b_g,b_b of kinks, and of\n"
               "jumps E to the left and right left_r .. right_b, then faces\n"
               "and edges by the numbers of the OBJ file"},
      {.name = "--extrema",
       .target = &arguments.extrema,
       .value = "FILE.csv",
       .help =
           "maxima, minima and saddles, those at walls and outlines\n"
           "included: kind,x,y,z,E,least,most,radius,on; the extremum is\n"
           "proven to be from least to most, within the radius. Further\n"
           "ones are in the regions of kind undecided, or where it is dark"},
      {.name = "--chord",
       .target = &arguments.chord,
       .value = "T",
       .help = "how far contours may be from their chords [length];\n"
               "0: 1e-3 of the surface's longer side",
       .show_default = true},
      {.name = "--half-width",
       .target = &arguments.half_width,
       .value = "W",
       .help = "half the length of transversals [length]; 0: 1e-9 of it",
       .show_default = true},
      {.name = "--smallest",
       .target = &arguments.smallest,
       .value = "L",
       .help = "triangles of the search get no smaller [length];\n"
               "0: 2^-18 of it",
       .show_default = true},
      {.name = "--most-triangles",
       .target = &arguments.most_triangles,
       .value = "N",
       .help = "so many of them at most, by default 4 million"},
      {.name = "--mesh-error",
       .target = &arguments.mesh_error,
       .value = "E",
       .help =
           "triangles of the mesh are divided until interpolation is wrong\n"
           "by no more at three points of each [W/m^2]; by default 1/100\n"
           "of the difference between the largest and the least value"},
      {.name = "--mesh-smallest",
       .target = &arguments.mesh_smallest,
       .value = "L",
       .help = "with sides up to this they are not divided [length]; by\n"
               "default 2^-12 of the surface's longer side"},
      {.name = "--mesh-vertices",
       .target = &arguments.mesh_vertices,
       .value = "N",
       .help = "nor if there are so many vertices; by default 300 000"},
      MethodOption(arguments.method),
      EmissionOption(arguments.emission),
      ThreadsOption(arguments.threads),
  };
}

}  // namespace

Command IsoluxCommand() {
  const auto arguments = std::make_shared<IsoluxArguments>();
  return {.name = "isolux",
          .summary = kDescription,
          .details = kFilesHelp,
          .examples = kExamples,
          .options = WithSceneOptions(OptionsOf(*arguments), arguments->scene),
          .run = [arguments] { return RunIsolux(*arguments); }};
}

}  // namespace truelux
