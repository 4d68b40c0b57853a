// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/candidates.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <limits>
#include <utility>

#include "truelux/io.h"

#include "base/ascii_case.h"
#include "scene/io/quoted.h"

namespace truelux {
namespace {

constexpr std::array<std::string_view, 3> kChannelNames = {"r", "g", "b"};

/// A number as programs print it, also where they have none.
std::optional<double> ParseValue(std::string_view text) {
  const std::string_view trimmed = TrimBlanks(text);
  if (const auto number = ParseNumber(trimmed)) return number;
  std::string word = LowerAscii(trimmed);
  const bool negative = word.starts_with('-');
  if (negative || word.starts_with('+')) word.erase(0, 1);
  if (word == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (word != "inf" && word != "infinity") return std::nullopt;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  return negative ? -kInfinity : kInfinity;
}

constexpr std::array<std::string_view, 3> kAxisNames = {"x", "y", "z"};
constexpr std::array kAxes = {&Vector3::x, &Vector3::y, &Vector3::z};

std::string ColumnOf(std::size_t channel) {
  return fmt::format("E_{}", kChannelNames[channel]);
}

/// "grad_r_x", or "grad_x" of the only channel.
std::string GradientColumnOf(std::optional<std::size_t> channel,
                             std::size_t axis) {
  if (!channel) return fmt::format("grad_{}", kAxisNames[axis]);
  return fmt::format("grad_{}_{}", kChannelNames[*channel], kAxisNames[axis]);
}

}  // namespace

std::string_view ChannelName(std::size_t channel) {
  return kChannelNames[channel];
}

CandidateReader::CandidateReader(ByteSource& source,
                                 const std::string& file_name,
                                 const CandidateRules& rules, FaceWords& faces)
    : csv_(source, file_name), columns_(faces), rules_(rules) {}

bool CandidateReader::ReadHeader(std::vector<Diagnostic>& defects) {
  const std::size_t defects_before = defects.size();
  if (!ReadHeaderRecord(csv_, record_, defects)) return false;
  columns_.Find(csv_, record_, defects);
  FindValues(defects);
  return defects.size() == defects_before;
}

void CandidateReader::FindValues(std::vector<Diagnostic>& defects) {
  const ColumnNames names(csv_, record_);
  quantity_ = rules_.quantity.value_or(
      HasGradient(names) ? Quantity::kGradient : Quantity::kIrradiance);
  switch (quantity_) {
    case Quantity::kFormFactor:
      FindFormFactor(names, defects);
      break;
    case Quantity::kGradient:
      FindGradient(names, defects);
      break;
    case Quantity::kIrradiance:
      FindIrradiance(names, defects);
      break;
  }
}

void CandidateReader::FindFormFactor(const ColumnNames& names,
                                     std::vector<Diagnostic>& defects) {
  if (const auto column = names.Find("F", defects)) {
    UseColumn(0, *column, "F");
    return;
  }
  defects.push_back(
      csv_.Error(record_.line(0),
                 "the header lacks the column F; --quantity form-factor "
                 "expects the candidate's form factors there"));
}

void CandidateReader::FindIrradiance(const ColumnNames& names,
                                     std::vector<Diagnostic>& defects) {
  const auto error = [&](std::size_t column, std::string message) {
    defects.push_back(csv_.Error(record_.line(column), std::move(message)));
  };
  const std::optional<std::size_t> single = names.Find("E", defects);
  const std::vector<std::size_t> wanted = WantedChannels();
  std::vector<std::string> missing;
  bool any = false;
  for (std::size_t channel = 0; channel < kChannelNames.size(); ++channel) {
    const auto column = names.Find(ColumnOf(channel), defects);
    any = any || column;
    if (std::ranges::find(wanted, channel) == wanted.end()) continue;
    if (column) {
      UseColumn(channel, *column, ColumnOf(channel));
    } else {
      missing.push_back(ColumnOf(channel));
    }
  }
  if (single && any) {
    error(*single,
          "both column 'E' and a column E_r, E_g or E_b; expected one of them");
  } else if (single) {
    if (!rules_.channel && !rules_.is_grey) {
      error(*single,
            "column 'E' could be any channel, and the scene's differ; say "
            "which by --channel r, g or b, or give E_r,E_g,E_b");
    }
    UseColumn(rules_.channel.value_or(0), *single, "E");
  } else if (!any && names.Find("F", defects)) {
    error(0,
          "column 'F' but no E: form factors are compared by --quantity "
          "form-factor");
  } else if (!missing.empty()) {
    error(0, fmt::format("the header lacks the column{} {}; expected the "
                         "candidate's E_r,E_g,E_b, or one column E",
                         missing.size() == 1 ? "" : "s",
                         fmt::join(missing, ", ")));
  }
}

/// Whether some column is one of a gradient.
bool CandidateReader::HasGradient(const ColumnNames& names) {
  std::vector<Diagnostic> not_told;
  for (std::size_t axis = 0; axis < kAxisNames.size(); ++axis) {
    if (names.Find(GradientColumnOf({}, axis), not_told)) return true;
    for (std::size_t channel = 0; channel < kChannelNames.size(); ++channel) {
      if (names.Find(GradientColumnOf(channel, axis), not_told)) return true;
    }
  }
  return false;
}

void CandidateReader::FindGradient(const ColumnNames& names,
                                   std::vector<Diagnostic>& defects) {
  std::vector<std::string> missing;
  std::optional<std::size_t> single;
  for (std::size_t axis = 0; axis < kAxisNames.size(); ++axis) {
    const auto column = names.Find(GradientColumnOf({}, axis), defects);
    if (!single) single = column;
    if (column) {
      UseColumn(rules_.channel.value_or(0), *column,
                GradientColumnOf({}, axis));
    } else {
      missing.push_back(GradientColumnOf({}, axis));
    }
  }
  if (single && !rules_.channel && !rules_.is_grey) {
    defects.push_back(csv_.Error(
        record_.line(*single),
        "columns 'grad_x', 'grad_y' and 'grad_z' could be any channel, and the "
        "scene's differ; say which by --channel r, g or b, or give grad_r_x .. "
        "grad_b_z"));
  }
  if (!single) {
    missing.clear();
    for (const std::size_t channel : WantedChannels()) {
      for (std::size_t axis = 0; axis < kAxisNames.size(); ++axis) {
        std::string name = GradientColumnOf(channel, axis);
        if (const auto column = names.Find(name, defects))
          UseColumn(channel, *column, std::move(name));
        else
          missing.push_back(std::move(name));
      }
    }
  }
  if (missing.empty()) {
    ignores_irradiance_ = HasIrradiance(names);
    return;
  }
  defects.push_back(csv_.Error(
      record_.line(0),
      fmt::format("the header lacks the column{} {}; expected the candidate's "
                  "grad_r_x .. grad_b_z, or grad_x,grad_y,grad_z",
                  missing.size() == 1 ? "" : "s", fmt::join(missing, ", "))));
}

/// Whether some column is one of irradiances.
bool CandidateReader::HasIrradiance(const ColumnNames& names) {
  std::vector<Diagnostic> not_told;
  if (names.Find("E", not_told)) return true;
  for (std::size_t channel = 0; channel < kChannelNames.size(); ++channel) {
    if (names.Find(ColumnOf(channel), not_told)) return true;
  }
  return false;
}

std::vector<std::size_t> CandidateReader::WantedChannels() const {
  if (rules_.channel) return {*rules_.channel};
  return {0, 1, 2};
}

void CandidateReader::UseColumn(std::size_t channel, std::size_t column,
                                std::string name) {
  if (channels_.empty() || channels_.back() != channel)
    channels_.push_back(channel);
  value_columns_.push_back(column);
  value_names_.push_back(std::move(name));
}

/// What stands in a column of values; 0 and a defect if that is no number.
double CandidateReader::ValueAt(std::size_t i,
                                std::vector<Diagnostic>& defects) {
  const std::string text = record_.Value(value_columns_[i]);
  if (quantity_ == Quantity::kGradient && TrimBlanks(text).empty())
    return std::numeric_limits<double>::quiet_NaN();
  const std::optional<double> value = ParseValue(text);
  if (!value) {
    defects.push_back(csv_.Error(
        record_.line(value_columns_[i]),
        fmt::format("{}: {} is not a number; expected a decimal number in "
                    "the range of binary64, inf or nan",
                    value_names_[i], Quoted(text))));
  }
  return value.value_or(0);
}

CandidateReader::Status CandidateReader::Next(
    CandidateRow& row, std::vector<Diagnostic>& defects) {
  const Status status = NextRecord(csv_, record_, defects);
  if (status != Status::kRow) return status;
  const std::size_t defects_before = defects.size();
  const std::optional<ReceiverFields> fields =
      columns_.Parse(csv_, record_, defects);
  if (!columns_.HasAllFields(record_)) return Status::kDefect;
  row.values = {};
  row.gradient = {};
  for (std::size_t i = 0; i < value_columns_.size(); ++i) {
    const double value = ValueAt(i, defects);
    if (quantity_ == Quantity::kGradient)
      row.gradient[i / kAxes.size()].*kAxes[i % kAxes.size()] = value;
    else
      row.values[i] = value;
  }
  if (defects.size() != defects_before) return Status::kDefect;
  row.receiver = fields->receiver;
  row.face = fields->face;
  row.line = record_.line(0);
  return Status::kRow;
}

}  // namespace truelux
