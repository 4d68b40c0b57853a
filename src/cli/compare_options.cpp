// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <vector>

#include "cli/cmd_compare.h"
#include "cli/commands.h"
#include "cli/input_arguments.h"
#include "cli/option_table.h"
#include "cli/oracle_arguments.h"
#include "compare/candidate_report.h"

namespace truelux {
namespace {

constexpr const char* kDescription =
    "Holds another program's values against the truth";

constexpr const char* kCompareHelp =
    "CANDIDATE.csv is a table of receivers as for truelux eval, on_face\n"
    "included, with the values that another program found there: E_r,E_g,E_b\n"
    "[W/m^2], or one column E where the scene's three channels agree or\n"
    "--channel names one; with --quantity form-factor one column F. Further\n"
    "columns are ignored, so that the output of truelux eval will do. With\n"
    "grad_r_x .. grad_b_z [W/m^3], or grad_x,grad_y,grad_z of one channel, as\n"
    "truelux gradient writes them, gradients are compared.\n"
    "\n"
    "Prints a table of errors against the certified values, the ten worst\n"
    "receivers, each with what is hard about it, and, if a receiver fails,\n"
    "whether a classic mistake explains the candidate: a constant factor, Ke\n"
    "read as radiance, flipped normals, emission from both sides or from the\n"
    "wrong one, no clipping at the horizon, an object left out, no shadows;\n"
    "or unbiased noise. Of gradients: the wrong sign or unit of length, the\n"
    "unshadowed irradiance's, visibility taken as constant, the source's "
    "depth\n"
    "for a blocker's edge, differences across a kink.\n"
    "\n"
    "A receiver fails if |value - E| > T E in some channel or, where E = 0,\n"
    "if |value| > T times the largest E of the table; nan always fails.\n"
    "Gradients likewise, by the lengths of vectors; at a kink the nearest of\n"
    "the gradients there counts, and where E is discontinuous none does.\n";

constexpr const char* kExamples =
    "Examples:\n"
    "  truelux compare room.obj mine.csv\n"
    "  truelux compare room.obj mine.csv --tolerance 0.01 --json errors.json\n"
    "  truelux compare room.obj ltc.csv --quantity form-factor\n"
    "  truelux eval room.obj floor.csv --method double |\n"
    "      truelux compare room.obj - --tolerance 1e-12\n";

std::vector<OptionRow> OptionsOf(CompareArguments& arguments) {
  return {
      SceneArgument(arguments.scene),
      {.name = "CANDIDATE.csv",
       .target = &arguments.candidate,
       .value = "FILE",
       .help = "receivers with the candidate's values; - is standard input",
       .required = true},
      OnFaceOption(arguments.on_face),
      {.name = "-o,--output",
       .target = &arguments.output,
       .value = "REPORT.txt",
       .help = "where to write; by default standard output"},
      {.name = "--json",
       .target = &arguments.json,
       .value = "FILE.json",
       .help = "the same facts; - is standard output, if -o is not"},
      {.name = "--quantity",
       .target = &arguments.quantity,
       .help = "what the values are: irradiance; gradient; or form-factor, "
               "the\n"
               "irradiance if every face that emits had M = 1; by default\n"
               "gradient if the table has such columns, else irradiance",
       .choices = {Name(Quantity::kIrradiance), Name(Quantity::kGradient),
                   Name(Quantity::kFormFactor)}},
      {.name = "--channel",
       .target = &arguments.channel,
       .value = "r|g|b",
       .help = "compare one channel, in column E or in its own"},
      {.name = "--tolerance",
       .target = &arguments.tolerance,
       .value = "T",
       .help = "largest relative error that passes",
       .show_default = true},
      EmissionOption(arguments.emission),
      ThreadsOption(arguments.threads),
  };
}

}  // namespace

Command CompareCommand() {
  const auto arguments = std::make_shared<CompareArguments>();
  arguments->tolerance = "1e-6";
  return {.name = "compare",
          .summary = kDescription,
          .details = kCompareHelp,
          .examples = kExamples,
          .options = WithSceneOptions(OptionsOf(*arguments), arguments->scene),
          .run = [arguments] { return RunCompare(*arguments); }};
}

}  // namespace truelux
