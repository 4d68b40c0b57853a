// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/eval_request.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <string_view>
#include <vector>

#include "truelux/formulas.h"
#include "truelux/io.h"

#include "cli/option_values.h"
#include "cli/oracle_arguments.h"
#include "run/file_id.h"
#include "run/file_place.h"
#include "run/interrupt.h"
#include "run/user_error.h"
#include "text/receivers.h"

namespace truelux {
namespace {

void CheckCombination(const EvalArguments& arguments) {
  if (arguments.receivers && arguments.at) {
    throw UsageError("--at stands for a table of receivers; give one of them");
  }
  if (arguments.at.has_value() != arguments.normal.has_value()) {
    throw UsageError("--at and --normal belong together");
  }
  if (!arguments.receivers && !arguments.at) {
    throw UsageError("no receivers: give a table, or --at and --normal");
  }
}

std::string FormulaNames() {
  std::string names;
  for (const Formula formula : AllFormulas()) {
    if (!names.empty()) names += ", ";
    names += Name(formula);
  }
  return names;
}

/// Sets the formula and its half-side; method and engine are set already.
void ParseFormula(const EvalArguments& arguments, OracleOptions& options) {
  if (arguments.formula) {
    if (options.method != Method::kDouble) {
      throw UsageError(
          "--formula belongs to --method double; a certified result does not "
          "depend on the formula");
    }
    const auto formula = FormulaByName(*arguments.formula);
    if (!formula) {
      throw UsageError(fmt::format("--formula: '{}' is none of {}",
                                   *arguments.formula, FormulaNames()));
    }
    options.formula = *formula;
  }
  if (options.formula != Formula::kAuto &&
      options.engine == Engine::kAngularSpans) {
    throw UsageError(
        "--formula needs the contour of every source; --engine angular-spans "
        "has none");
  }
  if (!arguments.half_side) return;
  if (options.formula != Formula::kImagePlane &&
      options.formula != Formula::kDirections) {
    throw UsageError(
        "--half-side belongs to --formula image-plane and directions");
  }
  const std::optional<double> half_side = ParseNumber(*arguments.half_side);
  if (!half_side || !(*half_side > 0)) {
    throw UsageError(fmt::format("--half-side: '{}' is not a positive number",
                                 *arguments.half_side));
  }
  options.half_side = *half_side;
}

/// A text as a field of a table, whatever it has in it.
std::string QuotedField(std::string_view text) {
  if (text.find_first_of(",;\"\r\n\t ") == text.npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text)
    quoted += c == '"' ? std::string(2, c) : std::string(1, c);
  return quoted + "\"";
}

std::string TableOfOne(const EvalArguments& arguments) {
  std::array<std::string, kReceiverColumns.size()> texts;
  std::ranges::copy(TripleTexts("--at", *arguments.at), texts.begin());
  std::ranges::copy(TripleTexts("--normal", *arguments.normal),
                    texts.begin() + 3);
  // Numbers have no quotes and line ends, so the row needs no quoting.
  std::vector<FieldDefect> defects;
  ParseReceiver(texts, defects);
  if (!defects.empty()) {
    const FieldDefect& defect = defects.front();
    throw UsageError(fmt::format(
        "{}: {}", defect.index < 3 ? "--at" : "--normal", defect.message));
  }
  std::string header = fmt::format("{}", fmt::join(kReceiverColumns, ","));
  std::string row = fmt::format("{}", fmt::join(texts, ","));
  if (arguments.on_face) {
    // Whether there is such a face is known when the scene has been read.
    header += fmt::format(",{}", kOnFaceColumn);
    row += "," + QuotedField(*arguments.on_face);
  }
  return header + "\n" + row + "\n";
}

}  // namespace

/// Where the part of an output is kept; what is piped cannot be gone on with.
std::string PartOf(const EvalRequest& request) {
  if (request.output.empty())
    throw UsageError("--resume needs --output, a file");
  const auto table = FileIdOf(request.receivers);
  if (request.receivers.empty() || request.receivers == "-" ||
      (table && !table->IsRegular())) {
    throw UsageError(
        "--resume needs a table of receivers in a file that can be read again");
  }
  if (!request.stats.empty())
    throw UsageError("--stats is about a whole run; not with --resume");
  return FollowLinks(request.output) + ".part";
}

EvalRequest ParseEvalRequest(const EvalArguments& arguments) {
  CheckCombination(arguments);
  EvalRequest request;
  request.scene = SceneRequestOf(arguments.scene);
  request.receivers = PathValue("RECEIVERS.csv", arguments.receivers);
  request.output = PathValue("--output", arguments.output);
  request.stats = PathValue("--stats", arguments.stats);
  if (request.output == "-") request.output.clear();
  if (arguments.resume) request.part = PartOf(request);
  if (arguments.at) request.table = TableOfOne(arguments);
  request.on_face = arguments.on_face;
  request.threads = ThreadsOf(arguments.threads);
  request.options.method = MethodOf(arguments.method);
  request.options.engine = EngineOf(arguments.engine);
  request.options.emission = EmissionOf(arguments.emission);
  request.options.stop = InterruptFlag();
  ParseFormula(arguments, request.options);
  return request;
}

}  // namespace truelux
