#include <CLI/CLI.hpp>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "truelux/formulas.h"

#include "cli/cmd_eval.h"
#include "cli/input_arguments.h"
#include "cli/oracle_arguments.h"

namespace truelux {
namespace {

constexpr const char* kDescription = "Irradiance at receivers in a scene";

constexpr const char* kInputHelp =
    "The results are irradiances [W/m^2]: the binary64 numbers nearest to the\n"
    "true values, each written as the shortest decimal that reads back to the\n"
    "same number.\n"
    "\n"
    "RECEIVERS.csv has a header with at least the columns x,y,z,nx,ny,nz, in\n"
    "any order: a point and the normal of the surface there. A column on_face\n"
    "may name the face (number of its f line, from 1) on which the point lies\n"
    "up to rounding: that face and all faces in its plane are ignored there.\n"
    "All columns are copied to the output, followed by E_r,E_g,E_b and, with\n"
    "--method double, bound_r,bound_g,bound_b, proven bounds on the errors\n"
    "(nan and inf where --formula does not apply).\n";

constexpr const char* kExamples =
    "Examples:\n"
    "  truelux eval room.obj floor.csv -o irradiance.csv\n"
    "  truelux eval room.obj - < floor.csv | head\n"
    "  truelux eval room.obj --at 1,0.5,-2 --normal 0,1,0\n";

/// The formulas' names, some on each line.
std::string WordsOf(std::span<const Formula> formulas) {
  constexpr std::size_t kLineLength = 56;
  std::string text;
  std::size_t line = 0;
  for (const Formula formula : formulas) {
    const std::string_view name = Name(formula);
    if (!text.empty()) {
      const bool is_full = text.size() + name.size() + 2 - line > kLineLength;
      text += is_full ? ",\n" : ", ";
      if (is_full) line = text.size();
    }
    text += name;
  }
  return text;
}

void AddInputs(CLI::App& command, EvalArguments& arguments) {
  AddSceneArgument(command, arguments.scene);
  AddReceiversArgument(command, arguments.receivers);
  command.add_option("--at", arguments.at, "one receiver: its point")
      ->type_name("x,y,z");
  command.add_option("--normal", arguments.normal, "with --at: its normal")
      ->type_name("nx,ny,nz");
  command
      .add_option("--on-face", arguments.on_face,
                  "with --at: the face on which the point lies")
      ->type_name("N");
}

void AddOutputs(CLI::App& command, EvalArguments& arguments) {
  command
      .add_option("-o,--output", arguments.output,
                  "where to write; by default standard output")
      ->type_name("OUT.csv");
  command
      .add_option("--stats", arguments.stats,
                  "times, and how often each predicate and evaluation stage\n"
                  "answered, as JSON")
      ->type_name("FILE.json");
}

void AddChoices(CLI::App& command, EvalArguments& arguments) {
  AddMethodOption(command, arguments.method);
  AddEngineOption(command, arguments.engine);
  AddEmissionOption(command, arguments.emission);
  command
      .add_option("--formula", arguments.formula,
                  "with --method double: the formula that is summed, one of\n" +
                      WordsOf(AllFormulas()) + ";\nby default auto")
      ->type_name("NAME");
  command
      .add_option("--half-side", arguments.half_side,
                  "with --formula image-plane or directions: what is visible\n"
                  "is cut to |x|, |y| <= R on the plane at distance 1; by\n"
                  "default 2^20")
      ->type_name("R");
  AddThreadsOption(command, arguments.threads);
}

}  // namespace

void AddEvalCommand(CLI::App& app, EvalArguments& arguments) {
  CLI::App& command = *app.add_subcommand("eval", kDescription);
  AddInputs(command, arguments);
  AddOutputs(command, arguments);
  AddChoices(command, arguments);
  command.footer(std::string(kInputHelp) + "\n" + kExamples + "\n" +
                 kExitStatusHelp);
}

}  // namespace truelux
