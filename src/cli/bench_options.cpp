#include <CLI/CLI.hpp>
#include <string>

#include "cli/cmd_bench.h"
#include "cli/input_arguments.h"

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

void AddInputs(CLI::App& command, BenchArguments& arguments) {
  AddSceneArgument(command, arguments.scene);
  AddReceiversArgument(command, arguments.receivers).required();
  command
      .add_option("-o,--output", arguments.output,
                  "the report; the tables go beside it")
      ->type_name("REPORT.html")
      ->required();
}

void AddLimits(CLI::App& command, BenchArguments& arguments) {
  arguments.count = "1000";
  arguments.seed = "1";
  command
      .add_option("--receivers", arguments.count,
                  "use at most so many receivers, evenly picked")
      ->capture_default_str()
      ->type_name("N");
  command
      .add_option("--seconds", arguments.seconds,
                  "processor time per method; what it leaves no time for is\n"
                  "left out (default: 10, with --quick 1)")
      ->type_name("S");
  command.add_option("--seed", arguments.seed, "of random samples")
      ->capture_default_str()
      ->type_name("N");
  command.add_flag("--quick", arguments.quick,
                   "fewer methods and less time for each");
  command.add_flag("--arrangement", arguments.arrangement,
                   "the arrangement engine on large scenes, too");
}

}  // namespace

void AddBenchCommand(CLI::App& app, BenchArguments& arguments) {
  CLI::App& command = *app.add_subcommand("bench", kDescription);
  AddInputs(command, arguments);
  AddLimits(command, arguments);
  command.footer(std::string(kReportHelp) + "\n" + kExamples + "\n" +
                 kExitStatusHelp);
}

}  // namespace truelux
