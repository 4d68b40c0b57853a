// SPDX-License-Identifier: GPL-3.0-or-later
// What the words of truelux eval ask for.

#ifndef TRUELUX_CLI_EVAL_REQUEST_H_
#define TRUELUX_CLI_EVAL_REQUEST_H_

#include <optional>
#include <string>

#include "truelux/irradiance.h"

#include "cli/input_arguments.h"

namespace truelux {

/// The words of the command line, before they are looked at.
struct EvalArguments {
  SceneArguments scene;
  std::optional<std::string> receivers;
  std::optional<std::string> at;
  std::optional<std::string> normal;
  std::optional<std::string> on_face;
  std::optional<std::string> output;
  bool resume = false;
  std::optional<std::string> stats;
  std::string method;
  std::string engine;
  std::string emission;
  std::optional<std::string> formula;
  std::optional<std::string> half_side;
  std::string threads;
};

/// What is to be done.
struct EvalRequest {
  SceneRequest scene;
  std::string receivers;  ///< path or "-"; "": see table
  std::string table;      ///< --at and its companions as a table of one row
  std::optional<std::string> on_face;  ///< for OnFaceOf
  std::string output;                  ///< path; "": standard output
  std::string stats;                   ///< path; "": none
  std::string part;  ///< path of what --resume keeps; "": none
  OracleOptions options;
  int threads = 1;
};

/// Throws UsageError if the words do not fit together or are no numbers.
EvalRequest ParseEvalRequest(const EvalArguments& arguments);

}  // namespace truelux

#endif  // TRUELUX_CLI_EVAL_REQUEST_H_
