// SPDX-License-Identifier: GPL-3.0-or-later
#include "tables.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <fmt/format.h>

namespace truelux::bench {
namespace {

/// The errors of certified values are bounded, not measured.
std::string ErrorText(const Measurement& m) {
  if (!m.error) return "-";
  if (m.method == kCertifiedName) return fmt::format("<= {:.1e}", *m.error);
  return *m.error == 0 ? "0" : fmt::format("{:.1e}", *m.error);
}

std::string Verdict(const BarRow& row) {
  if (!row.measured) return row.reason;
  if (*row.measured > row.at_most) return "MISSED";
  return row.aim && *row.measured <= *row.aim ? "aim met" : "met";
}

std::size_t Widest(std::size_t least, const std::vector<BarRow>& rows) {
  for (const BarRow& row : rows)
    least = std::max(least, row.what.size());
  return least;
}

}  // namespace

void PrintScene(const BenchScene& scene,
                const std::vector<Measurement>& measurements,
                const std::vector<std::string>& remarks) {
  fmt::print("\n{}: {} triangles, {} rounds\n", scene.name,
             scene.scene.triangles().size(),
             measurements.empty() ? 0 : measurements[0].rounds.size());
  fmt::print("{:<24} {:>9} {:>14} {:>12}\n", "method", "receivers",
             "us/receiver", "RMS error");
  for (const Measurement& m : measurements) {
    fmt::print("{:<24} {:>9} {:>14.4g} {:>12}\n", m.method, m.receivers,
               m.Microseconds(), ErrorText(m));
  }
  if (const Measurement* certified =
          Find(measurements, scene.name, kCertifiedName)) {
    const Statistics& statistics = certified->statistics;
    const double count = certified->receivers;
    fmt::print(
        "({:.3g} blocker parts and {:.3g} arcs a receiver; {} of {}"
        " receivers in multiple precision)\n",
        static_cast<double>(statistics.blockers) / count,
        static_cast<double>(statistics.arcs) / count,
        statistics.evaluated_multiprecision, certified->receivers);
  }
  for (const std::string& remark : remarks)
    fmt::print("({})\n", remark);
  std::fflush(stdout);
}

void PrintBar(const std::vector<BarRow>& rows) {
  if (rows.empty()) return;
  const std::size_t width = Widest(4, rows);
  fmt::print("\n{:<{}} {:>9} {:>8} {:>8}\n", "what", width, "measured",
             "at most", "aim");
  for (const BarRow& row : rows) {
    fmt::print("{:<{}} {:>9} {:>8.3g} {:>8}  {}\n", row.what, width,
               row.measured ? fmt::format("{:.3g}", *row.measured) : "-",
               row.at_most, row.aim ? fmt::format("{:.3g}", *row.aim) : "-",
               Verdict(row));
  }
  std::fflush(stdout);
}

std::string CsvText(const std::vector<Measurement>& measurements) {
  std::string text =
      "scene,method,family,receivers,rounds,microseconds,relative_rms_error\n";
  for (const Measurement& m : measurements) {
    text += fmt::format("{},{},{},{},{},{},{}\n", m.scene, m.method, m.family,
                        m.receivers, m.rounds.size(), m.Microseconds(),
                        m.error ? fmt::format("{}", *m.error) : "");
  }
  return text;
}

}  // namespace truelux::bench
