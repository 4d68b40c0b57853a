// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/html_report.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <fmt/format.h>

#include "draw/svg.h"
#include "study/html_tables.h"
#include "study/report_view.h"
#include "study/svg_histogram.h"
#include "study/svg_speed_chart.h"
#include "text/number_text.h"

namespace truelux {
namespace {

constexpr const char* kStyle = R"(
html { background: #ffffff; color: #222222; }
body { font: 15px/1.5 "Helvetica Neue", Helvetica, Arial, "Liberation Sans",
  sans-serif; max-width: 1140px; margin: 2.5rem auto; padding: 0 1.25rem; }
h1 { font-size: 1.7rem; line-height: 1.2; margin: 0 0 .4rem; }
h2 { font-size: 1.15rem; margin: 2.6rem 0 .3rem; padding-top: .6rem;
  border-top: 1px solid #d0d0d0; }
h3 { font-size: 1rem; margin: 1.6rem 0 .1rem; }
p { margin: .2rem 0 .7rem; max-width: 46rem; color: #444444; }
.lead { font-size: 1.05rem; color: #222222; max-width: 58rem; }
svg { display: block; width: 100%; height: auto; }
svg.marker { display: inline-block; width: 12px; height: 12px; }
table { border-collapse: collapse; font-size: .82rem;
  font-variant-numeric: tabular-nums; margin: .4rem 0 1rem; }
th { font-weight: 600; color: #555555; border-bottom: 1px solid #8a8a8a;
  vertical-align: bottom; }
th, td { padding: .16rem .55rem .16rem 0; text-align: right; }
td { border-bottom: 1px solid #ececec; white-space: nowrap; }
th.text, td.text { text-align: left; }
th.digits, td.digits { text-align: left; }
td.digits { font-family: "DejaVu Sans Mono", Menlo, Consolas, monospace;
  font-size: .74rem; }
td.seen { text-align: left; white-space: normal; min-width: 11rem; }
tr.best td { font-weight: 600; }
.off { color: #b03a00; }
.wide { overflow-x: auto; }
.histograms { display: grid; gap: 1.1rem 1.3rem;
  grid-template-columns: repeat(auto-fill, minmax(215px, 1fr)); }
figure { margin: 0; break-inside: avoid; }
.histograms figcaption { font-size: .78rem; line-height: 1.35; }
.histograms figcaption span { color: #666666; }
dl { font-size: .9rem; color: #444444; max-width: 46rem; }
dt { font-weight: 600; }
dd { margin: 0 0 .5rem; }
@media print {
  body { margin: 0; max-width: none; font-size: 10pt; }
  h2, h3, h2 + p, h3 + p { break-after: avoid; }
  tr { break-inside: avoid; }
  .wide { overflow: visible; }
  table.worst { font-size: .6rem; }
  td.seen { min-width: 9rem; }
  @page { size: A4 landscape; margin: 12mm; }
}
)";

std::string Count(std::size_t count, const char* noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string Head(const ReportView& view) {
  const Comparison& comparison = view.comparison;
  const std::size_t lit = view.LitReceivers();
  const std::string processor =
      comparison.processor.empty()
          ? ""
          : fmt::format(" on {}", EscapedXml(comparison.processor));
  return fmt::format(
      "<header>\n<h1>Speed and error: {}</h1>\n"
      "<p class=\"lead\">{} at {}, {} of them lit. The truth is the certified "
      "irradiance, the binary64 number nearest to the true value. Times are "
      "processor time of one thread{}.</p>\n</header>\n",
      EscapedXml(comparison.scene), Count(comparison.methods.size(), "method"),
      Count(comparison.receivers.size(), "receiver"), lit, processor);
}

/// Names of methods that the chart cannot show.
std::string Unshown(const ReportView& view) {
  std::string names;
  for (std::size_t m = 0; m < view.summaries.size(); ++m) {
    if (view.summaries[m].answered > 0) continue;
    if (!names.empty()) names += ", ";
    names += view.comparison.methods[m].name;
  }
  if (names.empty()) return "";
  return fmt::format("<p>No value at any receiver: {}.</p>\n",
                     EscapedXml(names));
}

std::string ChartSection(const ReportView& view) {
  return "<section>\n<h2>Speed against error</h2>\n"
         "<p>Lower is more accurate, further left is faster. Point at a mark "
         "for its numbers.</p>\n<figure id=\"chart\">\n" +
         SpeedChart(view) + "</figure>\n" + Unshown(view) +
         "<h3>What an error costs</h3>\n"
         "<p>The fastest method that keeps its relative error at every "
         "receiver below a bound, and gives no light where there is none. Of "
         "bounds with the same answer only the strictest is listed.</p>\n" +
         ChoiceTable(view) + "</section>\n";
}

std::string MethodsSection(const ReportView& view) {
  return "<section>\n<h2>Methods</h2>\n"
         "<p>In bold: no other method with values at all receivers is both "
         "faster and more accurate (RMS).</p>\n<div class=\"wide\">\n" +
         MethodsTable(view) + "</div>\n</section>\n";
}

std::string Caption(const MethodResult& method, const MethodSummary& summary) {
  std::string numbers = "no lit receiver";
  if (summary.answered == 0) numbers = "no value";
  if (summary.relative) {
    numbers = summary.relative->max == 0
                  ? "no error"
                  : fmt::format("median {}, largest {}",
                                ScientificText(summary.relative->median, 1),
                                ScientificText(summary.relative->max, 1));
  }
  return fmt::format(
      "<figcaption><b>{}</b> "
      "<span>{}</span><br/><span>{}</span></figcaption>\n",
      EscapedXml(method.name), TimeText(method.microseconds), numbers);
}

/// The highest bar of a decade in any histogram: they share one scale.
std::size_t SharedScale(const ReportView& view) {
  std::size_t scale = 0;
  for (const MethodSummary& summary : view.summaries)
    scale = std::max(scale, summary.histogram.HighestDecade());
  return scale == 0 ? view.comparison.receivers.size() : scale;
}

std::string HistogramSection(const ReportView& view) {
  const std::size_t scale = SharedScale(view);
  std::string html = fmt::format(
      "<section>\n<h2>Errors over the receivers</h2>\n"
      "<p>Receivers by the decade of their relative error. Apart from it, "
      "with their counts: exact values, light where there is none (false), "
      "no value (none). All on one scale, {} at full height; higher bars are "
      "cut.</p>\n<div class=\"histograms\">\n",
      Count(scale, "receiver"));
  for (std::size_t m = 0; m < view.summaries.size(); ++m) {
    html += "<figure>\n" +
            Caption(view.comparison.methods[m], view.summaries[m]) +
            HistogramSvg(view.summaries[m].histogram, scale, view.series[m]) +
            "</figure>\n";
  }
  return html + "</div>\n</section>\n";
}

std::string WorstSection(const ReportView& view) {
  return "<section>\n<h2>Worst receivers</h2>\n"
         "<p>Per group of methods the receivers at which one of them is "
         "farthest from the truth [W/m\u00b2], in the channel where it is. "
         "Digits that differ from the truth are coloured.</p>\n" +
         WorstTables(view) + "</section>\n";
}

std::string AbsentSection(const Comparison& comparison) {
  if (comparison.absent.empty()) return "";
  std::string html = "<section>\n<h2>Left out</h2>\n<ul id=\"absent\">\n";
  for (const std::string& method : comparison.absent)
    html += fmt::format("<li>{}</li>\n", EscapedXml(method));
  return html + "</ul>\n</section>\n";
}

constexpr const char* kDefinitions = R"(<section>
<h2>How the numbers are defined</h2>
<dl>
<dt>relative error</dt>
<dd>|value - truth| / truth, per receiver the largest of the channels whose
truth is above 0. Median, 95 %, largest and root of the mean square (RMS) are
over the receivers that have such a channel. A value that is no number has an
infinite error.</dd>
<dt>false light</dt>
<dd>Receivers with light in a channel whose truth is 0; they have no relative
error and are counted apart.</dd>
<dt>exact</dt>
<dd>All three channels are the certified numbers, dark receivers included.</dd>
<dt>absolute</dt>
<dd>The largest |value - truth| of all channels [W/m&#178;].</dd>
<dt>time</dt>
<dd>Processor time of one thread per receiver, the median of rounds in which
the methods take turns. What a method prepares once per scene is not
counted.</dd>
</dl>
</section>
)";

}  // namespace

std::string HtmlReport(const Comparison& comparison) {
  assert(comparison.reasons.size() == comparison.receivers.size());
  const ReportView view(comparison);
  std::string html = fmt::format(
      "<!DOCTYPE html>\n"
      "<html lang=\"en\" xmlns=\"http://www.w3.org/1999/xhtml\">\n<head>\n"
      "<meta charset=\"utf-8\"/>\n"
      "<meta name=\"viewport\""
      " content=\"width=device-width, initial-scale=1\"/>\n"
      "<meta name=\"generator\" content=\"truelux\"/>\n"
      "<title>Speed and error: {}</title>\n<style>{}</style>\n</head>\n"
      "<body>\n",
      EscapedXml(comparison.scene), kStyle);
  html += Head(view) + ChartSection(view) + MethodsSection(view) +
          HistogramSection(view) + WorstSection(view) +
          AbsentSection(comparison) + kDefinitions;
  return html + "</body>\n</html>\n";
}

}  // namespace truelux
