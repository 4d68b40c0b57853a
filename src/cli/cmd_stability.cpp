// SPDX-License-Identifier: GPL-3.0-or-later
// truelux stability: how many digits each formula keeps in each arithmetic.

#include <algorithm>
#include <cstdint>
#include <fmt/format.h>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "baselines/regimes.h"
#include "baselines/stability_study.h"
#include "cli/commands.h"
#include "cli/option_table.h"
#include "cli/option_values.h"
#include "cli/output_paths.h"
#include "run/exit_status.h"
#include "run/interrupt.h"
#include "run/output_file.h"
#include "run/progress.h"
#include "run/user_error.h"
#include "study/stability_tables.h"

namespace truelux {
namespace {

/// The words of the command line, before they are looked at.
struct StabilityArguments {
  std::string cases;
  std::string seed;
  std::string only;
  std::optional<std::string> csv;
};

constexpr const char* kDescription =
    "Digits that each formula keeps, regime by regime";

constexpr const char* kHelp =
    "Evaluates every closed formula on families of random cases, each with\n"
    "one difficulty at a known size, in float, double, double with a proven\n"
    "bound, double-double and MPFR with 128 bits, and compares with Lambert's\n"
    "sum in 400 bits. The tables are written to standard output as Markdown;\n"
    "docs/stability.md explains them. MPFR takes the first tenth of the cases\n"
    "only. Every proven bound is checked: one that does not hold makes the\n"
    "exit status 1.\n";

constexpr const char* kExamples =
    "Examples:\n"
    "  truelux stability > stability.md\n"
    "  truelux stability --cases 20 --only sliver\n"
    "  truelux stability --only 'conjunction missed' --csv near.csv\n"
    "  truelux stability --cases 1500 | grep '^Bounds checked'\n";

constexpr std::int64_t kMaxCases = 1000000;
constexpr std::int64_t kMaxSeed = std::int64_t{1} << 53;

std::vector<Regime> RegimesNamed(const std::string& only) {
  std::vector<Regime> regimes = Regimes();
  std::erase_if(regimes, [&only](const Regime& regime) {
    return regime.name.find(only) == std::string::npos;
  });
  if (regimes.empty()) {
    throw UsageError(
        fmt::format("--only: no regime has '{}' in its name; they "
                    "are the rows of docs/stability.md",
                    only));
  }
  return regimes;
}

/// A file beside the tables on standard output.
std::optional<OutputFile> OpenCsv(const std::optional<std::string>& word) {
  const std::string path = PathValue("--csv", word);
  if (path.empty()) return std::nullopt;
  if (path == "-") {
    throw UsageError("--csv: the tables are written to standard output");
  }
  CheckOutputs({{"the tables", ""}, {"--csv", path}});
  return std::optional<OutputFile>(std::in_place, path);
}

/// kComparisonFailed: a printed bound does not hold.
ExitStatus RunStability(const StabilityArguments& arguments) {
  StabilityOptions options;
  options.cases = static_cast<int>(
      WholeNumberValue("--cases", arguments.cases, 1, kMaxCases));
  options.seed = static_cast<std::uint64_t>(
      WholeNumberValue("--seed", arguments.seed, 0, kMaxSeed));
  options.slow_cases = std::max(1, options.cases / 10);
  const std::vector<Regime> regimes = RegimesNamed(arguments.only);
  std::optional<OutputFile> csv = OpenCsv(arguments.csv);
  OutputFile output("");

  std::vector<RegimeStability> results;
  {
    Progress progress(
        regimes.size() * static_cast<std::uint64_t>(options.cases), "cases");
    for (const Regime& regime : regimes) {
      results.push_back(MeasureStability(regime, options, [&progress] {
        StopIfInterrupted();
        progress.Advance();
      }));
    }
  }
  if (csv) {
    csv->Write(StabilityCsv(results));
    csv->Finish();
  }
  output.Write(StabilityMarkdown(options, results));
  output.Finish();
  StopIfInterrupted();
  if (csv) csv->Commit();
  for (const RegimeStability& result : results) {
    if (!result.violations.empty()) return ExitStatus::kComparisonFailed;
  }
  return ExitStatus::kDone;
}

std::vector<OptionRow> OptionsOf(StabilityArguments& arguments) {
  return {
      {.name = "--cases",
       .target = &arguments.cases,
       .value = "N",
       .help = "random cases of each regime",
       .show_default = true},
      {.name = "--seed",
       .target = &arguments.seed,
       .value = "N",
       .help = "other cases; the same seed gives the same errors",
       .show_default = true},
      {.name = "--only",
       .target = &arguments.only,
       .value = "TEXT",
       .help = "only regimes that have TEXT in their names"},
      {.name = "--csv",
       .target = &arguments.csv,
       .value = "FILE",
       .help = "all numbers as a table"},
  };
}

}  // namespace

Command StabilityCommand() {
  const StabilityOptions defaults;
  const auto arguments = std::make_shared<StabilityArguments>();
  arguments->cases = std::to_string(defaults.cases);
  arguments->seed = std::to_string(defaults.seed);
  return {.name = "stability",
          .summary = kDescription,
          .details = kHelp,
          .examples = kExamples,
          .options = OptionsOf(*arguments),
          .run = [arguments] { return RunStability(*arguments); }};
}

}  // namespace truelux
