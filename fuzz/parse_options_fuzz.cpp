// SPDX-License-Identifier: GPL-3.0-or-later
// Feeds the command line with any words: each line of the input is one. What
// the commands would do is left out; their words are parsed, and those of eval
// and render made into requests. What is refused needs a reason.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/commands.h"
#include "cli/eval_request.h"
#include "cli/parser.h"
#include "cli/render_request.h"
#include "run/user_error.h"

namespace {

void Require(bool condition) {
  if (!condition) std::abort();
}

/// A word of the command line has no zero byte.
std::vector<std::string> WordsOf(std::string_view bytes) {
  std::vector<std::string> words(1);
  for (const char c : bytes) {
    if (c == '\n') {
      words.emplace_back();
    } else if (c != '\0') {
      words.back() += c;
    }
  }
  return words;
}

void ParseCommandLine(const std::vector<std::string>& words) {
  truelux::Program program = {
      .name = "truelux",
      .description = "",
      .version = "",
      .commands = {truelux::EvalCommand(), truelux::BenchCommand(),
                   truelux::CompareCommand(), truelux::InspectCommand(),
                   truelux::RenderCommand(), truelux::StabilityCommand()}};
  for (truelux::Command& command : program.commands) {
    // What it would run keeps the words' places alive.
    command.run = [kept = command.run] { return truelux::ExitStatus::kDone; };
  }
  std::vector<const char*> arguments = {"truelux"};
  for (const std::string& word : words)
    arguments.push_back(word.c_str());
  const truelux::ExitStatus status = truelux::RunCommandLine(
      program, static_cast<int>(arguments.size()), arguments.data());
  Require(status == truelux::ExitStatus::kDone ||
          status == truelux::ExitStatus::kBadInput);
}

/// Calls parse(), which may refuse the words.
template <class Parse>
void MayRefuse(const Parse& parse) {
  try {
    parse();
  } catch (const truelux::UserError& error) {
    Require(!error.diagnostics().empty());
    for (const truelux::Diagnostic& diagnostic : error.diagnostics())
      Require(!diagnostic.message.empty());
  }
}

/// Hands out the words one after the other, "" after the last.
class Words {
 public:
  explicit Words(const std::vector<std::string>& words) : words_(words) {}

  std::string Next() { return at_ < words_.size() ? words_[at_++] : ""; }

  /// Nothing for an empty word.
  std::optional<std::string> Maybe() {
    std::string word = Next();
    if (word.empty()) return std::nullopt;
    return word;
  }

 private:
  const std::vector<std::string>& words_;
  std::size_t at_ = 0;
};

void ParseEval(const std::vector<std::string>& all) {
  Words words(all);
  truelux::EvalArguments arguments;
  arguments.method = "double";
  arguments.engine = "contour";
  arguments.emission = "exitance";
  arguments.at = words.Maybe();
  arguments.normal = words.Maybe();
  arguments.on_face = words.Maybe();
  arguments.half_side = words.Maybe();
  arguments.threads = words.Next();
  arguments.scene.opaque_from = words.Maybe();
  arguments.formula = words.Maybe();
  arguments.output = words.Maybe();
  arguments.scene.path = words.Next();
  arguments.receivers = words.Maybe();
  arguments.stats = words.Maybe();
  MayRefuse([&] {
    const auto request = truelux::ParseEvalRequest(arguments);
    Require(request.threads >= 1);
    Require(request.options.half_side > 0);
  });
}

void ParseRender(const std::vector<std::string>& all) {
  Words words(all);
  truelux::RenderArguments arguments;
  arguments.method = "certified";
  arguments.engine = "contour";
  arguments.emission = "radiance";
  arguments.output = "o.png";
  arguments.scene.path = "s.obj";
  arguments.size = words.Next();
  arguments.threads = words.Next();
  arguments.surface = words.Maybe();
  arguments.eye = words.Maybe();
  arguments.target = words.Maybe();
  arguments.up = words.Maybe();
  arguments.fov = words.Maybe();
  arguments.on_face = words.Maybe();
  arguments.exposure = words.Maybe();
  arguments.white = words.Maybe();
  arguments.resume = words.Maybe().has_value();
  MayRefuse([&] {
    const auto request = truelux::ParseRenderRequest(arguments);
    Require(request.threads >= 1 && request.size.width >= 1);
    if (request.style.white) Require(*request.style.white >= 0);
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const std::vector<std::string> words = WordsOf(bytes);
  ParseCommandLine(words);
  ParseEval(words);
  ParseRender(words);
  return 0;
}
