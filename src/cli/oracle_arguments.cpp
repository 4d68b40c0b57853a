// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/oracle_arguments.h"

#include <fmt/format.h>

#include "cli/option_values.h"
#include "run/messages.h"
#include "run/parallel.h"
#include "text/results.h"

namespace truelux {

OptionRow MethodOption(std::string& word) {
  word = Name(OracleOptions().method);
  return {.name = "--method",
          .target = &word,
          .help =
              "certified: the nearest binary64; double: the same visibility,\n"
              "summed in double, with a proven bound",
          .show_default = true,
          .choices = {Name(Method::kCertified), Name(Method::kDouble)}};
}

OptionRow EngineOption(std::string& word) {
  word = Name(OracleOptions().engine);
  return {.name = "--engine",
          .target = &word,
          .help =
              "how visibility is found; all give the same results, but\n"
              "arrangement is slow, and so is angular-spans, which sums "
              "over\n"
              "the same map vertex by vertex",
          .show_default = true,
          .choices = {Name(Engine::kContour), Name(Engine::kArrangement),
                      Name(Engine::kAngularSpans)}};
}

OptionRow EmissionOption(std::string& word) {
  word = Name(OracleOptions().emission);
  return {.name = "--emission",
          .target = &word,
          .help =
              "what Ke is: radiant exitance M [W/m^2], or\n"
              "radiance L [W/m^2/sr], M = pi L",
          .show_default = true,
          .choices = {Name(Emission::kExitance), Name(Emission::kRadiance)}};
}

OptionRow ThreadsOption(std::string& word) {
  word = std::to_string(DefaultThreads());
  // Its default belongs to the computer, not into a manual page.
  return {.name = "--threads",
          .target = &word,
          .value = "N",
          .help = fmt::format("number of threads, up to {}; by default one per "
                              "processor",
                              kMaxThreads)};
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
  const auto wanted =
      static_cast<int>(WholeNumberValue("--threads", word, 1, kMaxThreads));
  const int had = ThreadsToHave(wanted);
  if (had < wanted) {
    PrintNote(fmt::format("the system gives {} of {} threads", had, wanted));
  }
  return had;
}

}  // namespace truelux
