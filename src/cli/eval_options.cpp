#include <CLI/CLI.hpp>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "truelux/formulas.h"
#include "truelux/irradiance.h"

#include "cli/cmd_eval.h"
#include "cli/evaluation.h"
#include "cli/input_arguments.h"
#include "report/results.h"

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

/// An option whose default is the value that `word` has now.
CLI::Option* AddWord(CLI::App& command, const char* name, std::string& word,
                     const char* help) {
  return command.add_option(name, word, help)->capture_default_str();
}

/// The same for an option that takes one of some words.
void AddChoice(CLI::App& command, const char* name, std::string& word,
               const std::vector<std::string_view>& choices, const char* help) {
  const std::vector<std::string> words(choices.begin(), choices.end());
  AddWord(command, name, word, help)
      ->check(CLI::IsMember(words).description(""))
      ->type_name(CLI::detail::join(words, "|"));
}

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
  const OracleOptions defaults;
  arguments.method = Name(defaults.method);
  arguments.engine = Name(defaults.engine);
  arguments.emission = Name(defaults.emission);
  arguments.threads = std::to_string(DefaultThreads());
  AddChoice(command, "--method", arguments.method,
            {Name(Method::kCertified), Name(Method::kDouble)},
            "certified: the nearest binary64; double: the same visibility,\n"
            "summed in double, with a proven bound");
  AddChoice(command, "--engine", arguments.engine,
            {Name(Engine::kContour), Name(Engine::kArrangement),
             Name(Engine::kAngularSpans)},
            "how visibility is found; all give the same results, but\n"
            "arrangement is slow, and so is angular-spans, which sums over\n"
            "the same map vertex by vertex");
  AddChoice(command, "--emission", arguments.emission,
            {Name(Emission::kExitance), Name(Emission::kRadiance)},
            "what Ke is: radiant exitance M [W/m^2], or\n"
            "radiance L [W/m^2/sr], M = pi L");
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
  AddWord(command, "--threads", arguments.threads,
          "number of threads; by default one per processor")
      ->type_name("N");
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
