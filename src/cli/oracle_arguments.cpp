#include "cli/oracle_arguments.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/option_values.h"
#include "run/parallel.h"
#include "text/results.h"

namespace truelux {

CLI::Option& AddWord(CLI::App& command, const char* name, std::string& word,
                     const std::string& help) {
  return *command.add_option(name, word, help)->capture_default_str();
}

CLI::Option& AddChoice(CLI::App& command, const char* name, std::string& word,
                       const std::vector<std::string_view>& choices,
                       const std::string& help) {
  const std::vector<std::string> words(choices.begin(), choices.end());
  return *AddWord(command, name, word, help)
              .check(CLI::IsMember(words).description(""))
              ->type_name(CLI::detail::join(words, "|"));
}

void AddMethodOption(CLI::App& command, std::string& word) {
  word = Name(OracleOptions().method);
  AddChoice(command, "--method", word,
            {Name(Method::kCertified), Name(Method::kDouble)},
            "certified: the nearest binary64; double: the same visibility,\n"
            "summed in double, with a proven bound");
}

void AddEngineOption(CLI::App& command, std::string& word) {
  word = Name(OracleOptions().engine);
  AddChoice(command, "--engine", word,
            {Name(Engine::kContour), Name(Engine::kArrangement),
             Name(Engine::kAngularSpans)},
            "how visibility is found; all give the same results, but\n"
            "arrangement is slow, and so is angular-spans, which sums over\n"
            "the same map vertex by vertex");
}

void AddEmissionOption(CLI::App& command, std::string& word) {
  word = Name(OracleOptions().emission);
  AddChoice(command, "--emission", word,
            {Name(Emission::kExitance), Name(Emission::kRadiance)},
            "what Ke is: radiant exitance M [W/m^2], or\n"
            "radiance L [W/m^2/sr], M = pi L");
}

void AddThreadsOption(CLI::App& command, std::string& word) {
  word = std::to_string(DefaultThreads());
  // Its default belongs to the computer, not into a manual page.
  command
      .add_option("--threads", word,
                  fmt::format("number of threads, up to {}; by default one per "
                              "processor",
                              kMaxThreads))
      ->type_name("N");
}

Method MethodOf(const std::string& word) {
  return word == Name(Method::kDouble) ? Method::kDouble : Method::kCertified;
}

Engine EngineOf(const std::string& word) {
  for (const Engine engine : {Engine::kArrangement, Engine::kAngularSpans}) {
    if (word == Name(engine)) return engine;
  }
  return Engine::kContour;
}

Emission EmissionOf(const std::string& word) {
  return word == Name(Emission::kRadiance) ? Emission::kRadiance
                                           : Emission::kExitance;
}

int ThreadsOf(const std::string& word) {
  return static_cast<int>(WholeNumberValue("--threads", word, 1, kMaxThreads));
}

}  // namespace truelux
