// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "truelux/formulas.h"

#include "cli/cmd_eval.h"
#include "cli/commands.h"
#include "cli/input_arguments.h"
#include "cli/option_table.h"
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
    "may say what --on-face does, for one receiver: the face on which the "
    "point\n"
    "lies up to rounding (the number of its f line, from 1; NAME; auto). That\n"
    "face and all faces in its plane are ignored there. All columns are "
    "copied\n"
    "to the output, followed with --on-face by on_face_found, the number of "
    "the\n"
    "face that was taken, then by E_r,E_g,E_b and, with --method double,\n"
    "bound_r,bound_g,bound_b, proven bounds on the errors (nan and inf where\n"
    "--formula does not apply).\n";

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

std::vector<OptionRow> OptionsOf(EvalArguments& arguments) {
  return {
      SceneArgument(arguments.scene),
      ReceiversArgument(arguments.receivers),
      {.name = "--at",
       .target = &arguments.at,
       .value = "x,y,z",
       .help = "one receiver: its point"},
      {.name = "--normal",
       .target = &arguments.normal,
       .value = "nx,ny,nz",
       .help = "with --at: its normal"},
      OnFaceOption(arguments.on_face),
      {.name = "-o,--output",
       .target = &arguments.output,
       .value = "OUT.csv",
       .help = "where to write; by default standard output"},
      {.name = "--resume",
       .target = &arguments.resume,
       .help = "keep what is done in OUT.csv.part, and go on from it if it\n"
               "is there; give it from the first run on"},
      {.name = "--stats",
       .target = &arguments.stats,
       .value = "FILE.json",
       .help = "times, and how often each predicate and evaluation stage\n"
               "answered, as JSON"},
      MethodOption(arguments.method),
      EngineOption(arguments.engine),
      EmissionOption(arguments.emission),
      {.name = "--formula",
       .target = &arguments.formula,
       .value = "NAME",
       .help = "with --method double: the formula that is summed, one of\n" +
               WordsOf(AllFormulas()) + ";\nby default auto"},
      {.name = "--half-side",
       .target = &arguments.half_side,
       .value = "R",
       .help = "with --formula image-plane or directions: what is visible\n"
               "is cut to |x|, |y| <= R on the plane at distance 1; by\n"
               "default 2^20"},
      ThreadsOption(arguments.threads),
  };
}

}  // namespace

Command EvalCommand() {
  const auto arguments = std::make_shared<EvalArguments>();
  return {.name = "eval",
          .summary = kDescription,
          .details = kInputHelp,
          .examples = kExamples,
          .options = WithSceneOptions(OptionsOf(*arguments), arguments->scene),
          .run = [arguments] { return RunEval(*arguments); }};
}

}  // namespace truelux
