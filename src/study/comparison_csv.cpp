// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/comparison_csv.h"

#include <algorithm>
#include <cstddef>
#include <fmt/format.h>
#include <optional>

#include "study/comparison_summary.h"
#include "text/receivers.h"
#include "text/results.h"

namespace truelux {
namespace {

void AppendField(std::string& row, double value) {
  row += ',';
  AppendNumber(row, value);
}

void AppendField(std::string& row, std::string_view text) {
  row += ',';
  row += CsvField(text);
}

double Mean(const Rgb& value) {
  return (value[0] + value[1] + value[2]) / 3;
}

void AppendRelative(std::string& row,
                    const std::optional<MethodSummary::Relative>& relative) {
  if (!relative) {
    row += ",,,,";
    return;
  }
  for (const double error : {relative->median, relative->percentile_95,
                             relative->max, relative->rms})
    AppendField(row, error);
}

void AppendHistogram(std::string& row, const ErrorHistogram& histogram) {
  for (const std::size_t count : histogram.decades)
    row += fmt::format(",{}", count);
  row += fmt::format(",{},{}\n", histogram.false_light, histogram.no_value);
}

void AppendReceiver(std::string& row, const Receiver& receiver) {
  const Point3& p = receiver.position;
  const Vector3& n = receiver.normal;
  for (const double number : {p.x, p.y, p.z, n.x, n.y, n.z})
    AppendField(row, number);
  row += receiver.on_face == 0 ? "," : fmt::format(",{}", receiver.on_face);
}

}  // namespace

std::string CsvField(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == text.npos) return std::string(text);
  std::string field = "\"";
  for (const char c : text) {
    if (c == '"') field += '"';
    field += c;
  }
  return field + '"';
}

std::string MethodsCsv(const Comparison& comparison) {
  std::string text =
      "method,group,microseconds,receivers,left_out,lit,median_relative_error,"
      "percentile_95_relative_error,max_relative_error,rms_relative_error,"
      "max_absolute_error,false_light,exact";
  for (std::size_t i = 0; i < ErrorHistogram::kDecades; ++i) {
    text += fmt::format(",from_1e{}",
                        ErrorHistogram::kLowest + static_cast<int>(i));
  }
  text += ",only_false_light,no_value\n";
  for (const MethodResult& method : comparison.methods) {
    const MethodSummary summary = Summarize(comparison, method);
    text += CsvField(method.name);
    AppendField(text, method.group);
    AppendField(text, method.microseconds);
    text += fmt::format(",{},{},{}", summary.answered, method.left_out,
                        summary.lit);
    AppendRelative(text, summary.relative);
    AppendField(text, summary.max_absolute);
    text += fmt::format(",{},{}", summary.false_light, summary.exact);
    AppendHistogram(text, summary.histogram);
  }
  return text;
}

std::string ReceiversCsv(const Comparison& comparison) {
  std::string text =
      fmt::format("receiver,{},{},E_r,E_g,E_b,reason",
                  fmt::join(kReceiverColumns, ","), kOnFaceColumn);
  for (const MethodResult& method : comparison.methods) {
    AppendField(text, method.name + ": mean E");
    AppendField(text, method.name + ": relative error");
  }
  text += '\n';
  for (std::size_t i = 0; i < comparison.receivers.size(); ++i) {
    text += fmt::format("{}", i + 1);
    AppendReceiver(text, comparison.receivers[i]);
    for (const double e : comparison.truth[i])
      AppendField(text, e);
    AppendField(text, comparison.reasons[i]);
    for (const MethodResult& method : comparison.methods) {
      if (!method.values[i]) {
        text += ",,";
        continue;
      }
      AppendField(text, Mean(*method.values[i]));
      const ValueError error = ErrorOf(*method.values[i], comparison.truth[i]);
      if (error.relative) {
        AppendField(text, *error.relative);
      } else {
        text += ',';
      }
    }
    text += '\n';
  }
  return text;
}

}  // namespace truelux
