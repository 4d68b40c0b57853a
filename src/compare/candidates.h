// SPDX-License-Identifier: GPL-3.0-or-later
// A candidate: receivers and what another program says about them.

#ifndef TRUELUX_COMPARE_CANDIDATES_H_
#define TRUELUX_COMPARE_CANDIDATES_H_

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "truelux/diagnostics.h"
#include "truelux/geometry.h"
#include "truelux/gradient_comparison.h"
#include "truelux/receiver.h"

#include "text/byte_source.h"
#include "text/csv.h"
#include "text/face_choice.h"
#include "text/receiver_columns.h"

namespace truelux {

/// What a candidate's numbers are.
enum class Quantity {
  kIrradiance,  ///< E [W/m^2]: columns E_r, E_g, E_b, or one column E
  kFormFactor,  ///< F [1]: one column F, E with M = 1 on every face that emits
  kGradient,    ///< dE/dr with the normal fixed [W/m^3]: columns grad_r_x ..
                ///< grad_b_z, or for one channel grad_x, grad_y, grad_z
};

/// "r", "g", "b".
[[nodiscard]] std::string_view ChannelName(std::size_t channel);

/// What is asked about a candidate, and what its scene allows.
struct CandidateRules {
  /// Nothing: gradients if the table has a column of theirs, else irradiances.
  std::optional<Quantity> quantity{};
  /// The only channel that is compared, if one is named.
  std::optional<std::size_t> channel{};
  /// All faces of the scene emit the same in red, green and blue, so that a
  /// column E, or grad_x, needs no channel.
  bool is_grey = false;
};

/// One receiver of a candidate.
struct CandidateRow {
  Receiver receiver;  ///< without a face that has to be searched for
  FaceChoice face;    ///< for SetFace
  Rgb values{};       ///< entry c for CandidateReader::channels()[c], others 0
  GradientRow gradient{};  ///< likewise; one of the two is filled
  int line = 0;            ///< on which it begins in the table, from 1
};

/// Reads a candidate: the columns of a receivers table and those of the
/// values; all others, bound_* among them, are ignored. Values are decimal
/// numbers, or inf, infinity or nan with any sign and in any case. A gradient's
/// component may be empty, as where there is none, and is then nan.
class CandidateReader {
 public:
  using Status = RowStatus;

  /// source, faces: must outlive the reader.
  CandidateReader(ByteSource& source, const std::string& file_name,
                  const CandidateRules& rules, FaceWords& faces);

  /// Reads the header; must be called once, first. False, and entries in
  /// `defects`, if a column is missing or stands twice, or if the columns do
  /// not say which values are meant.
  bool ReadHeader(std::vector<Diagnostic>& defects);

  /// What the values are.
  [[nodiscard]] Quantity quantity() const { return quantity_; }

  /// Whether the table also has columns of irradiances, which are not compared.
  [[nodiscard]] bool ignores_irradiance() const { return ignores_irradiance_; }

  /// The channels that are compared, from 0; only the first if the quantity is
  /// kFormFactor, or if a column E holds what is the same for all.
  [[nodiscard]] const std::vector<std::size_t>& channels() const {
    return channels_;
  }

  /// The names of the columns with the values: one per channel, or three.
  [[nodiscard]] const std::vector<std::string>& value_names() const {
    return value_names_;
  }

  /// Reads the next row. May be called again after a defect.
  Status Next(CandidateRow& row, std::vector<Diagnostic>& defects);

 private:
  void FindValues(std::vector<Diagnostic>& defects);
  void FindFormFactor(const ColumnNames& names,
                      std::vector<Diagnostic>& defects);
  void FindIrradiance(const ColumnNames& names,
                      std::vector<Diagnostic>& defects);
  void FindGradient(const ColumnNames& names, std::vector<Diagnostic>& defects);
  [[nodiscard]] static bool HasGradient(const ColumnNames& names);
  [[nodiscard]] static bool HasIrradiance(const ColumnNames& names);
  [[nodiscard]] std::vector<std::size_t> WantedChannels() const;
  void UseColumn(std::size_t channel, std::size_t column, std::string name);
  [[nodiscard]] double ValueAt(std::size_t i, std::vector<Diagnostic>& defects);

  CsvReader csv_;
  CsvRecord record_;
  ReceiverColumns columns_;
  CandidateRules rules_;
  Quantity quantity_ = Quantity::kIrradiance;
  bool ignores_irradiance_ = false;
  std::vector<std::size_t> channels_;
  std::vector<std::string> value_names_;
  std::vector<std::size_t> value_columns_;
};

}  // namespace truelux

#endif  // TRUELUX_COMPARE_CANDIDATES_H_
