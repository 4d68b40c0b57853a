#include "text/results.h"

#include <array>
#include <charconv>
#include <cmath>
#include <fmt/format.h>

namespace truelux {
namespace {

/// Enough for the shortest form of any binary64, such as
/// -2.2250738585072014e-308.
constexpr std::size_t kNumberChars = 32;

std::string Number(double value) {
  std::string text;
  AppendNumber(text, value);
  return text;
}

std::string JsonText(const StageCounts& counts) {
  return fmt::format(
      R"({{"symbolic": {}, "filter": {}, "interval": {}, "exact": {}}})",
      counts.symbolic, counts.filter, counts.interval, counts.exact);
}

}  // namespace

void AppendNumber(std::string& text, double value) {
  if (std::isnan(value)) {
    text += "nan";  // whatever its sign
    return;
  }
  std::array<char, kNumberChars> buffer{};
  const std::to_chars_result end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  text.append(buffer.data(), end.ptr);
}

std::string_view ResultHeader(Method method) {
  return method == Method::kDouble ? ",E_r,E_g,E_b,bound_r,bound_g,bound_b"
                                   : ",E_r,E_g,E_b";
}

void AppendResult(std::string& text, const Irradiance& irradiance,
                  Method method) {
  for (const double value : irradiance.value) {
    text += ',';
    AppendNumber(text, value);
  }
  if (method != Method::kDouble) return;
  for (const double bound : irradiance.bound) {
    text += ',';
    AppendNumber(text, bound);
  }
}

std::string JsonText(const RunReport& report) {
  const Statistics& s = report.statistics;
  std::string text = "{\n";
  const auto line = [&text](std::string_view key, std::string_view value) {
    text += fmt::format("  \"{}\": {},\n", key, value);
  };
  const auto word = [](std::string_view value) {
    return fmt::format("\"{}\"", value);
  };
  line("version", word(report.version));
  line("engine", word(Name(report.options.engine)));
  line("method", word(Name(report.options.method)));
  line("emission", word(Name(report.options.emission)));
  line("formula", word(Name(report.options.formula)));
  line("load_seconds", Number(report.load_seconds));
  line("evaluate_seconds", Number(report.evaluate_seconds));
  line("threads", fmt::to_string(report.threads));
  line("receivers", fmt::to_string(report.receivers));
  text += fmt::format(
      R"(  "predicates": {{
    "receiver_side": {},
    "vertex_side": {},
    "plane_side": {},
    "edge_order": {}
  }},
)",
      JsonText(s.receiver_side), JsonText(s.vertex_side),
      JsonText(s.plane_side), JsonText(s.edge_order));
  text += fmt::format(
      R"(  "visibility": {{
    "sources": {},
    "blockers": {},
    "arcs": {}
  }},
)",
      s.sources, s.blockers, s.arcs);
  text += fmt::format(
      R"(  "evaluation": {{
    "zero": {},
    "double": {},
    "double_double": {},
    "multiprecision": {},
    "ties": {},
    "overflows": {},
    "max_precision_bits": {}
  }}
}}
)",
      s.evaluated_zero, s.evaluated_double, s.evaluated_double_double,
      s.evaluated_multiprecision, s.ties, s.overflows, s.max_precision_bits);
  return text;
}

}  // namespace truelux
