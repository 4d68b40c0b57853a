// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle_options.h"

#include <algorithm>
#include <array>
#include <oneapi/tbb/info.h>
#include <span>
#include <vector>

#include "errors.h"

namespace truelux::python {
namespace {

constexpr int kMaxThreads = 1024;
constexpr std::array kEngines = {Engine::kContour, Engine::kArrangement,
                                 Engine::kAngularSpans};
constexpr std::array kMethods = {Method::kCertified, Method::kDouble};
constexpr std::array kEmissions = {Emission::kExitance, Emission::kRadiance};

/// The value of a word, else a defect.
template <class T>
T ByName(std::span<const T> all, const std::string& word, const char* what,
         std::vector<std::string>& defects) {
  std::string names;
  for (const T value : all) {
    if (word == Name(value)) return value;
    names += (names.empty() ? "" : ", ") + std::string(Name(value));
  }
  defects.push_back(std::string(what) + ": '" + word + "' is none of " + names);
  return all.front();
}

}  // namespace

OracleOptions Choice::Options(const StopFlag* stop) const {
  return {.engine = engine,
          .method = method,
          .emission = emission,
          .formula = formula,
          .half_side = half_side,
          .stop = stop};
}

int Choice::ThreadCount() const {
  if (threads > 0) return threads;
  return std::min(kMaxThreads, tbb::info::default_concurrency());
}

Choice MakeChoice(const std::string& engine, const std::string& method,
                  const std::string& emission, const std::string& formula,
                  double half_side, int threads) {
  std::vector<std::string> defects;
  Choice choice;
  choice.engine =
      ByName(std::span<const Engine>(kEngines), engine, "engine", defects);
  choice.method =
      ByName(std::span<const Method>(kMethods), method, "method", defects);
  choice.emission = ByName(std::span<const Emission>(kEmissions), emission,
                           "emission", defects);
  choice.formula = ByName(AllFormulas(), formula, "formula", defects);
  choice.half_side = half_side;
  choice.threads = threads;
  if (!(half_side > 0)) defects.emplace_back("half_side: expected more than 0");
  if (threads < 0 || threads > kMaxThreads)
    defects.emplace_back("threads: expected 1 to 1024, or None");
  if (!defects.empty()) throw InputError(std::move(defects));
  return choice;
}

std::optional<ScalarChannel> ChannelOf(const std::optional<std::string>& name) {
  if (!name) return std::nullopt;
  for (const ScalarChannel channel :
       {ScalarChannel::kLuminance, ScalarChannel::kRed, ScalarChannel::kGreen,
        ScalarChannel::kBlue}) {
    if (*name == Name(channel)) return channel;
  }
  throw InputError({"channel: '" + *name + "' is none of luminance, r, g, b"});
}

}  // namespace truelux::python
