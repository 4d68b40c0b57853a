// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/html_tables.h"

#include <algorithm>
#include <cstddef>
#include <fmt/format.h>
#include <iterator>
#include <limits>
#include <optional>

#include "draw/svg.h"
#include "study/worst_receivers.h"
#include "text/number_text.h"
#include "text/results.h"

namespace truelux {
namespace {

std::string Cell(const std::string& html, const char* kind = "") {
  return *kind == '\0' ? "<td>" + html + "</td>"
                       : fmt::format("<td class=\"{}\">{}</td>", kind, html);
}

std::string TextCell(const std::string& text) {
  return Cell(EscapedXml(text), "text");
}

std::string CountCell(std::size_t count) {
  return Cell(count == 0 ? "" : fmt::format("{}", count));
}

/// An error, or a dash if there is none to speak of.
std::string ErrorCell(const std::optional<double>& error) {
  if (!error) return Cell("\u2013");
  return *error == 0 ? Cell("0") : Cell(ScientificText(*error, 1));
}

/// A marker as in the chart, for the line of a table.
std::string MarkerCell(std::size_t series, bool everywhere) {
  return "<td class=\"text\">"
         "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"marker\""
         " viewBox=\"0 0 12 12\" width=\"12\" height=\"12\""
         " aria-hidden=\"true\">" +
         SvgMarker(6, 6, series,
                   everywhere ? MarkerFill::kSolid : MarkerFill::kHollow) +
         "</svg></td>";
}

std::string Header(const std::string& names) {
  return fmt::format("<thead><tr>{}</tr></thead>\n<tbody>\n", names);
}

std::string Number(double value) {
  std::string text;
  AppendNumber(text, value);
  return text;
}

/// The largest relative error that a method makes anywhere; light where there
/// is none has no bound.
double LargestError(const MethodSummary& summary) {
  if (summary.false_light > 0) return std::numeric_limits<double>::infinity();
  return summary.relative ? summary.relative->max : 0;
}

/// The fastest method that answers everywhere with at most this error.
std::optional<std::size_t> FastestWithin(const ReportView& view, double bound) {
  std::optional<std::size_t> fastest;
  const auto& methods = view.comparison.methods;
  for (std::size_t m = 0; m < methods.size(); ++m) {
    const MethodSummary& summary = view.summaries[m];
    if (!summary.AnswersAll(view.comparison) || LargestError(summary) > bound)
      continue;
    if (!fastest || methods[m].microseconds < methods[*fastest].microseconds)
      fastest = m;
  }
  return fastest;
}

std::string MethodRow(const ReportView& view, std::size_t m) {
  const MethodResult& method = view.comparison.methods[m];
  const MethodSummary& summary = view.summaries[m];
  const auto& relative = summary.relative;
  const auto error = [&](double MethodSummary::Relative::*which) {
    return ErrorCell(relative ? std::optional((*relative).*which)
                              : std::nullopt);
  };
  const bool everywhere = summary.AnswersAll(view.comparison);
  std::string note = method.note;
  if (method.left_out > 0) {
    note += fmt::format("{}not tried on {} receivers", note.empty() ? "" : "; ",
                        method.left_out);
  }
  std::string row = view.IsOnFront(m) ? "<tr class=\"best\">" : "<tr>";
  row += MarkerCell(view.series[m], everywhere) + TextCell(method.name) +
         TextCell(method.group) + Cell(TimeText(method.microseconds)) +
         CountCell(summary.answered) + CountCell(summary.exact) +
         error(&MethodSummary::Relative::median) +
         error(&MethodSummary::Relative::percentile_95) +
         error(&MethodSummary::Relative::max) +
         error(&MethodSummary::Relative::rms) +
         ErrorCell(summary.max_absolute) + CountCell(summary.false_light) +
         TextCell(note) + "</tr>\n";
  return row;
}

/// A value with the digits from the first one that differs from the truth set
/// apart.
std::string ComparedNumber(double value, double truth) {
  std::string text = Number(value);
  const std::string other = Number(truth);
  std::size_t common = 0;
  while (common < text.size() && common < other.size() &&
         text[common] == other[common])
    ++common;
  if (text == other) return text;
  if (common == text.size()) common = 0;  // "0" beside "0.25" is all wrong
  return fmt::format("{}<span class=\"off\">{}</span>", text.substr(0, common),
                     text.substr(common));
}

/// A point or a normal in few digits; all of them when pointed at.
std::string TripleCell(double x, double y, double z) {
  return fmt::format(
      "<td class=\"text\" title=\"{},{},{}\">{:.6g}, {:.6g}, {:.6g}</td>",
      Number(x), Number(y), Number(z), x, y, z);
}

std::string WorstErrorText(const ValueError& error) {
  if (error.exact) return "exact";
  if (error.false_light) return "false light";
  return ScientificText(error.relative.value_or(0), 1);
}

std::string WorstRow(const ReportView& view, const WorstReceiver& worst,
                     bool with_best) {
  constexpr const char* kChannels[] = {"r", "g", "b"};
  const Comparison& comparison = view.comparison;
  const Receiver& receiver = comparison.receivers[worst.receiver];
  const MethodResult& method = comparison.methods[worst.method];
  const std::size_t channel = worst.error.channel;
  const double truth = comparison.truth[worst.receiver][channel];
  const double value = (*method.values[worst.receiver])[channel];
  const Point3& p = receiver.position;
  const Vector3& n = receiver.normal;
  std::string row = "<tr>" + Cell(fmt::format("{}", worst.receiver + 1)) +
                    TripleCell(p.x, p.y, p.z) + TripleCell(n.x, n.y, n.z) +
                    TextCell(method.name) + Cell(kChannels[channel], "text") +
                    Cell(Number(truth), "digits") +
                    Cell(ComparedNumber(value, truth), "digits") +
                    Cell(WorstErrorText(worst.error));
  if (with_best) {
    const std::string& best = comparison.methods[worst.best_method].name;
    row += TextCell(
        worst.best_method == worst.method
            ? ""
            : fmt::format("{} ({})", best, WorstErrorText(worst.best_error)));
  }
  return row + Cell(EscapedXml(comparison.reasons[worst.receiver]), "seen") +
         "</tr>\n";
}

/// A group of one method has no better one to name.
bool HasSeveralMethods(const ReportView& view, const std::string& group) {
  return std::ranges::count(view.comparison.methods, group,
                            &MethodResult::group) > 1;
}

std::string WorstTable(const ReportView& view, const WorstOfGroup& group) {
  const bool with_best = HasSeveralMethods(view, group.group);
  std::string names =
      "<th>receiver</th><th class=\"text\">position</th>"
      "<th class=\"text\">normal</th><th class=\"text\">worst method</th>"
      "<th></th><th class=\"digits\">truth</th>"
      "<th class=\"digits\">its value</th><th>error</th>";
  if (with_best) names += "<th class=\"text\">best of the group</th>";
  names += "<th class=\"text\">what is seen</th>";
  std::string html =
      "<div class=\"wide\"><table class=\"worst\">\n" + Header(names);
  for (const WorstReceiver& worst : group.worst)
    html += WorstRow(view, worst, with_best);
  return html + "</tbody></table></div>\n";
}

}  // namespace

std::string ChoiceTable(const ReportView& view) {
  constexpr double kBounds[] = {1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-9, 1e-12, 0};
  std::string html =
      "<table id=\"choice\">\n" +
      Header(
          "<th>no error above</th><th></th><th class=\"text\">fastest method"
          "</th><th>time</th><th>its largest error</th>");
  for (std::size_t i = 0; i < std::size(kBounds); ++i) {
    const std::optional<std::size_t> m = FastestWithin(view, kBounds[i]);
    // Of bounds with the same answer the strictest one says it all.
    const bool last = i + 1 == std::size(kBounds);
    if (!last && FastestWithin(view, kBounds[i + 1]) == m) continue;
    html += "<tr>" + Cell(last ? "exact" : ScientificText(kBounds[i], 0));
    if (m) {
      const MethodResult& method = view.comparison.methods[*m];
      html += MarkerCell(view.series[*m], true) + TextCell(method.name) +
              Cell(TimeText(method.microseconds)) +
              ErrorCell(LargestError(view.summaries[*m]));
    } else {
      html += "<td></td><td class=\"text\">none</td><td></td><td></td>";
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table>\n";
}

std::string MethodsTable(const ReportView& view) {
  std::string html =
      "<table id=\"methods\">\n" +
      Header(
          "<th></th><th class=\"text\">method</th><th class=\"text\">group"
          "</th><th>time</th><th>receivers</th><th>exact</th><th>median</th>"
          "<th>95 %</th><th>largest</th><th>RMS</th><th>absolute</th>"
          "<th>false light</th><th class=\"text\">note</th>");
  for (std::size_t m = 0; m < view.comparison.methods.size(); ++m)
    html += MethodRow(view, m);
  return html + "</tbody></table>\n";
}

std::string WorstTables(const ReportView& view) {
  std::string html;
  for (const WorstOfGroup& group : WorstReceivers(view.comparison)) {
    html += fmt::format("<h3>{}</h3>\n", EscapedXml(group.group));
    if (group.worst.empty()) {
      html += "<p>Exact wherever it has a value.</p>\n";
      continue;
    }
    html += fmt::format("<p>Not exact at {} of {} receivers.</p>\n",
                        group.wrong, view.comparison.receivers.size()) +
            WorstTable(view, group);
  }
  return html;
}

}  // namespace truelux
