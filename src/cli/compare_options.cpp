#include <CLI/CLI.hpp>
#include <string>

#include "cli/cmd_compare.h"
#include "cli/input_arguments.h"
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
    "columns are ignored, so that the output of truelux eval will do.\n"
    "\n"
    "Prints a table of errors against the certified values, the ten worst\n"
    "receivers, each with what is hard about it, and, if a receiver fails,\n"
    "whether a classic mistake explains the candidate: a constant factor, Ke\n"
    "read as radiance, flipped normals, emission from both sides or from the\n"
    "wrong one, no clipping at the horizon, an object left out, no shadows;\n"
    "or unbiased noise.\n"
    "\n"
    "A receiver fails if |value - E| > T E in some channel or, where E = 0,\n"
    "if |value| > T times the largest E of the table; nan always fails.\n";

constexpr const char* kExamples =
    "Examples:\n"
    "  truelux compare room.obj mine.csv\n"
    "  truelux compare room.obj mine.csv --tolerance 0.01 --json errors.json\n"
    "  truelux compare room.obj ltc.csv --quantity form-factor\n"
    "  truelux eval room.obj floor.csv --method double |\n"
    "      truelux compare room.obj - --tolerance 1e-12\n";

void AddOutputs(CLI::App& command, CompareArguments& arguments) {
  command
      .add_option("-o,--output", arguments.output,
                  "where to write; by default standard output")
      ->type_name("REPORT.txt");
  command
      .add_option("--json", arguments.json,
                  "the same facts; - is standard output, if -o is not")
      ->type_name("FILE.json");
}

void AddMeaning(CLI::App& command, CompareArguments& arguments) {
  arguments.quantity = Name(Quantity::kIrradiance);
  AddChoice(command, "--quantity", arguments.quantity,
            {Name(Quantity::kIrradiance), Name(Quantity::kFormFactor)},
            "what the values are: irradiance, or form-factor, the irradiance\n"
            "if every face that emits had M = 1");
  command
      .add_option("--channel", arguments.channel,
                  "compare one channel, in column E or in its own")
      ->type_name("r|g|b");
  arguments.tolerance = "1e-6";
  AddWord(command, "--tolerance", arguments.tolerance,
          "largest relative error that passes")
      .type_name("T");
}

}  // namespace

void AddCompareCommand(CLI::App& app, CompareArguments& arguments) {
  CLI::App& command = *app.add_subcommand("compare", kDescription);
  AddSceneArgument(command, arguments.scene);
  command
      .add_option("CANDIDATE.csv", arguments.candidate,
                  "receivers with the candidate's values; - is standard input")
      ->type_name("FILE")
      ->required();
  AddOutputs(command, arguments);
  AddMeaning(command, arguments);
  AddEmissionOption(command, arguments.emission);
  AddThreadsOption(command, arguments.threads);
  command.footer(std::string(kCompareHelp) + "\n" + kExamples + "\n" +
                 kExitStatusHelp);
}

}  // namespace truelux
