// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <vector>

#include "cli/cmd_gradient.h"
#include "cli/commands.h"
#include "cli/input_arguments.h"
#include "cli/option_table.h"
#include "cli/oracle_arguments.h"

namespace truelux {
namespace {

constexpr const char* kDescription =
    "Derivatives of irradiance: gradients, Jacobians, kinks";

constexpr const char* kColumnsHelp =
    "Writes the rows of RECEIVERS.csv, each followed by E_r,E_g,E_b [W/m^2],\n"
    "status_r,status_g,status_b and the columns that --of asks for, each the\n"
    "binary64 nearest to the true value:\n"
    "  gradient    grad_r_x ..   dE/dr, the normal fixed [W/m^3]\n"
    "  tangential  tgrad_r_x ..  its part in the plane of the receiver's face\n"
    "  normal      dn_r_x ..     dE/dn [W/m^2 per radian]\n"
    "  vector      V_r_x ..      vector irradiance over the hemisphere "
    "[W/m^2]\n"
    "  jacobian    J_r_xy ..     dV_x/dy, and Jsphere_r_xy of L [W/m^3]\n"
    "  sphere      L_r_x ..      light field vector, over the sphere [W/m^2]\n"
    "  flux        flux_r        net flux n.L [W/m^2]\n"
    "status is C1 where the gradient exists and is continuous; kink where\n"
    "one-sided derivatives differ: then the gradient is their mean, and with\n"
    "the rows of --kinks E'(r; d) = grad.d + sum of b |m.d|; discontinuous\n"
    "where a receiver lies on a face that is not its own: then only E is\n"
    "there. With --method double numbers are summed in double, and each has\n"
    "a column more with a proven bound (bound_E_r .., bound_grad_r_x ..);\n"
    "zeros need not be exact then. docs/derivatives.md has the formulas.\n";

constexpr const char* kExamples =
    "Examples:\n"
    "  truelux gradient room.obj receivers.csv -o gradients.csv\n"
    "  truelux gradient room.obj receivers.csv --of gradient,normal \\\n"
    "      --kinks kinks.csv -o gradients.csv\n";

std::vector<OptionRow> OptionsOf(GradientArguments& arguments) {
  OptionRow receivers = ReceiversArgument(arguments.receivers);
  receivers.required = true;
  return {
      SceneArgument(arguments.scene),
      receivers,
      OnFaceOption(arguments.on_face),
      {.name = "--of",
       .target = &arguments.of,
       .value = "GROUP,...",
       .help = "which columns",
       .show_default = true},
      {.name = "-o,--output",
       .target = &arguments.output,
       .value = "OUT.csv",
       .help = "where to write; by default standard output"},
      {.name = "--kinks",
       .target = &arguments.kinks,
       .value = "FILE.csv",
       .help = "a row for each plane across which a gradient jumps:\n"
               "receiver,channel,mx,my,mz,b,cause"},
      {.name = "--vertices",
       .target = &arguments.vertices,
       .value = "FILE.csv",
       .help = "dE/dv of all vertices by their numbers in the OBJ file\n"
               "[W/m^3]: receiver,channel,vertex,axis,value,left,right;\n"
               "left and right where they differ, jump where E jumps; those\n"
               "that are 0 are left out"},
      {.name = "--vertex-gradient",
       .target = &arguments.vertex_gradient,
       .value = "FILE.csv",
       .help = "vertex,x,y,z: the sum over receivers and channels of weight\n"
               "times dE/dv, with weights from the columns weight_r, weight_g\n"
               "and weight_b of RECEIVERS.csv"},
      {.name = "--stats",
       .target = &arguments.stats,
       .value = "FILE.json",
       .help = "times, and how often each predicate and evaluation stage\n"
               "answered for E, as JSON"},
      MethodOption(arguments.method),
      EmissionOption(arguments.emission),
      ThreadsOption(arguments.threads),
  };
}

}  // namespace

Command GradientCommand() {
  const auto arguments = std::make_shared<GradientArguments>();
  arguments->of = "gradient";
  return {.name = "gradient",
          .summary = kDescription,
          .details = kColumnsHelp,
          .examples = kExamples,
          .options = WithSceneOptions(OptionsOf(*arguments), arguments->scene),
          .run = [arguments] { return RunGradient(*arguments); }};
}

}  // namespace truelux
