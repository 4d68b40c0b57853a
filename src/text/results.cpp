// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/results.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/shortest_decimal.h"

namespace truelux {
namespace {

using Json = nlohmann::ordered_json;

Json JsonOf(const StageCounts& counts) {
  return {{"symbolic", counts.symbolic},
          {"filter", counts.filter},
          {"interval", counts.interval},
          {"double_double", counts.double_double},
          {"exact", counts.exact}};
}

Json JsonOf(const RunReport& report) {
  const Statistics& s = report.statistics;
  Json json;
  json["version"] = report.version;
  json["engine"] = Name(report.options.engine);
  json["method"] = Name(report.options.method);
  json["emission"] = Name(report.options.emission);
  json["formula"] = Name(report.options.formula);
  json["load_seconds"] = report.load_seconds;
  json["evaluate_seconds"] = report.evaluate_seconds;
  json["threads"] = report.threads;
  json["receivers"] = report.receivers;
  Json left_out = Json::array();
  for (const LeftOutFaces& faces : report.left_out)
    left_out.push_back({{"reason", faces.reason}, {"faces", faces.numbers}});
  json["left_out"] = left_out;
  json["predicates"] = {{"receiver_side", JsonOf(s.receiver_side)},
                        {"vertex_side", JsonOf(s.vertex_side)},
                        {"plane_side", JsonOf(s.plane_side)},
                        {"edge_order", JsonOf(s.edge_order)}};
  json["visibility"] = {
      {"sources", s.sources}, {"blockers", s.blockers}, {"arcs", s.arcs}};
  json["evaluation"] = {{"zero", s.evaluated_zero},
                        {"double", s.evaluated_double},
                        {"double_double", s.evaluated_double_double},
                        {"multiprecision", s.evaluated_multiprecision},
                        {"ties", s.ties},
                        {"overflows", s.overflows},
                        {"max_precision_bits", s.max_precision_bits}};
  return json;
}

/// Objects deeper than this are written on one line.
constexpr std::size_t kBrokenLevels = 2;

/// Appends a value; level: how many objects are around it. Not nlohmann's dump,
/// which breaks the lines of all objects or of none, and writes the number 1 of
/// seconds as 1.0.
void AppendJson(std::string& text, const Json& json, std::size_t level = 0) {
  if (json.is_number_float()) {
    AppendNumber(text, json.get<double>());
    return;
  }
  if (!json.is_object()) {
    text += json.dump(-1, ' ', false, Json::error_handler_t::replace);
    return;
  }
  const bool is_broken = level < kBrokenLevels;
  const std::string end = is_broken ? "\n" + std::string(2 * level, ' ') : "";
  const std::string start = is_broken ? end + "  " : "";
  std::string before = start;
  text += '{';
  for (const auto& [key, value] : json.items()) {
    text += before + Json(key).dump() + ": ";
    AppendJson(text, value, level + 1);
    before = (is_broken ? "," : ", ") + start;
  }
  text += end + '}';
}

}  // namespace

void AppendNumber(std::string& text, double value) {
  if (std::isnan(value)) {
    text += "nan";  // whatever its sign
    return;
  }
  AppendShortestDecimal(text, value);
}

std::string ResultHeader(Method method, char separator) {
  std::string header = method == Method::kDouble
                           ? ",E_r,E_g,E_b,bound_r,bound_g,bound_b"
                           : ",E_r,E_g,E_b";
  std::ranges::replace(header, ',', separator);
  return header;
}

void AppendResult(std::string& text, const Irradiance& irradiance,
                  Method method, char separator) {
  for (const double value : irradiance.value) {
    text += separator;
    AppendNumber(text, value);
  }
  if (method != Method::kDouble) return;
  for (const double bound : irradiance.bound) {
    text += separator;
    AppendNumber(text, bound);
  }
}

std::string JsonText(const RunReport& report) {
  std::string text;
  AppendJson(text, JsonOf(report));
  return text + "\n";
}

}  // namespace truelux
