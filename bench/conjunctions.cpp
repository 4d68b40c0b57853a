// SPDX-License-Identifier: GPL-3.0-or-later
// How often vertex tracing, as published, is wrong where edges and vertices
// coincide in the image. The truth is the certified value.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <fmt/format.h>
#include <string>
#include <vector>

#include "truelux/irradiance.h"

#include "baselines/vertex_tracing.h"
#include "conjunctive_scenes.h"
#include "support/portable_random.h"

namespace truelux::bench {
namespace {

/// E [W/m^2] of a case that is kept, over the area of the source: some 1/300
/// of what there would be without blockers.
constexpr double kLeastSeen = 1e-3;
constexpr double kWrong = 1e-6;  ///< relative error

struct Options {
  int receivers = 200;
  std::uint64_t seed = 1;
  std::string only;
  bool list = false;
};

struct Column {
  std::string name;
  VertexTracingOptions options;
};

std::vector<Column> Columns() {
  std::vector<Column> columns = {{"rays", {}}};
  for (int k = 3; k <= 9; ++k) {
    columns.push_back(
        {fmt::format("1e-{}", k), {Tracing::kCones, std::pow(10.0, -k)}});
  }
  columns.push_back({"1e-6, strict", {Tracing::kCones, 1e-6, true}});
  return columns;
}

/// The relative errors of one method, one per receiver.
class Errors {
 public:
  void Add(double error) { errors_.push_back(error); }

  /// "wrong; median; largest".
  [[nodiscard]] std::string Text() {
    if (errors_.empty()) return "";
    std::ranges::sort(errors_);
    const auto wrong = std::ranges::count_if(
        errors_, [](double error) { return !(error <= kWrong); });
    return fmt::format("{}; {:.0e}; {:.0e}", wrong, errors_[errors_.size() / 2],
                       errors_.back());
  }

 private:
  std::vector<double> errors_;
};

void MeasureFamily(const ConjunctiveFamily& family, const Options& options) {
  const std::vector<Column> columns = Columns();
  std::vector<Errors> errors(columns.size());
  testing::PortableRandom random(options.seed);
  for (int i = 0; i < options.receivers;) {
    const ConjunctiveCase made = family.make(random);
    const double truth = Oracle(made.scene).Evaluate(made.receiver).value[0];
    if (truth < kLeastSeen * made.side * made.side) continue;
    std::string line;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const VertexTracing tracing(made.scene, columns[c].options);
      const double value = tracing.Evaluate(made.receiver)[0];
      const double error = std::abs(value / truth - 1);
      errors[c].Add(error);
      line += fmt::format(" {:.1e}", error);
    }
    if (options.list) fmt::print(stderr, "{}, {}:{}\n", family.name, i, line);
    ++i;
  }
  fmt::print("| {} |", family.name);
  for (Errors& of_method : errors)
    fmt::print(" {} |", of_method.Text());
  fmt::print("\n");
  std::fflush(stdout);
}

void Measure(const Options& options) {
  fmt::print(
      "Of {} receivers: how many are wrong by more than {:.0e}, relative to "
      "the\ncertified value; median error; largest error.\n\n",
      options.receivers, kWrong);
  std::string head = "| |";
  std::string rule = "|---|";
  for (const Column& column : Columns()) {
    head += fmt::format(" {} |", column.name);
    rule += "---|";
  }
  fmt::print("{}\n{}\n", head, rule);
  for (const ConjunctiveFamily& family : ConjunctiveFamilies()) {
    if (family.name.find(options.only) != std::string::npos)
      MeasureFamily(family, options);
  }
}

int Run(int argc, char** argv) {
  Options options;
  CLI::App app("Vertex tracing as published, where edges coincide.",
               "conjunctions");
  app.add_option("--receivers", options.receivers, "per family")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str()
      ->type_name("N");
  app.add_option("--seed", options.seed, "of the scenes")
      ->capture_default_str()
      ->type_name("N");
  app.add_option("--only", options.only,
                 "only families whose names contain this")
      ->type_name("TEXT");
  app.add_flag("--list", options.list,
               "write the errors of each receiver to standard error");
  CLI11_PARSE(app, argc, argv);
  Measure(options);
  return 0;
}

}  // namespace
}  // namespace truelux::bench

int main(int argc, char** argv) {
  try {
    return truelux::bench::Run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "internal error: %s\n", error.what());
  }
  return 3;
}
