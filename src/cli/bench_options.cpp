// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/cmd_bench.h"
#include "cli/commands.h"
#include "cli/input_arguments.h"
#include "cli/option_table.h"

namespace truelux {
namespace {

constexpr const char* kDescription =
    "Many methods on the receivers of one scene, as a report";

constexpr const char* kReportHelp =
    "Compares truelux with shadow rays, a scanline quadrature and others on "
    "the\n"
    "same receivers: processor time of one thread per receiver, and error\n"
    "against the certified irradiance (Ke read as exitance). Writes\n"
    "\n"
    "  REPORT.html           charts and tables on one page, for any browser\n"
    "  REPORT.csv            one row per method\n"
    "  REPORT_receivers.csv  one row per receiver\n"
    "\n"
    "SCENE.obj and RECEIVERS.csv are those of truelux eval.\n";

constexpr const char* kExamples =
    "Examples:\n"
    "  truelux bench room.obj floor.csv -o report.html\n"
    "  truelux bench room.obj floor.csv -o report.html --quick\n"
    "  truelux bench city.obj - -o city.html --receivers 50 < streets.csv\n";

OptionRow RequiredReceivers(std::optional<std::string>& receivers) {
  OptionRow row = ReceiversArgument(receivers);
  row.required = true;
  return row;
}

std::vector<OptionRow> OptionsOf(BenchArguments& arguments) {
  return {
      SceneArgument(arguments.scene),
      RequiredReceivers(arguments.receivers),
      OnFaceOption(arguments.on_face),
      {.name = "-o,--output",
       .target = &arguments.output,
       .value = "REPORT.html",
       .help = "the report; the tables go beside it",
       .required = true},
      {.name = "--receivers",
       .target = &arguments.count,
       .value = "N",
       .help = "use at most so many receivers, evenly picked",
       .show_default = true},
      {.name = "--seconds",
       .target = &arguments.seconds,
       .value = "S",
       .help = "processor time per method; what it leaves no time for is\n"
               "left out (default: 10, with --quick 1)"},
      {.name = "--seed",
       .target = &arguments.seed,
       .value = "N",
       .help = "of random samples",
       .show_default = true},
      {.name = "--quick",
       .target = &arguments.quick,
       .help = "fewer methods and less time for each"},
      {.name = "--arrangement",
       .target = &arguments.arrangement,
       .help = "the arrangement engine on large scenes, too"},
  };
}

}  // namespace

Command BenchCommand() {
  const auto arguments = std::make_shared<BenchArguments>();
  arguments->count = "1000";
  arguments->seed = "1";
  return {.name = "bench",
          .summary = kDescription,
          .details = kReportHelp,
          .examples = kExamples,
          .options = WithSceneOptions(OptionsOf(*arguments), arguments->scene),
          .run = [arguments] { return RunBench(*arguments); }};
}

}  // namespace truelux
