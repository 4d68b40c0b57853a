// SPDX-License-Identifier: GPL-3.0-or-later
// Why a word is no number, and what its writer probably meant.

#ifndef TRUELUX_SCENE_IO_NUMBER_DEFECT_H_
#define TRUELUX_SCENE_IO_NUMBER_DEFECT_H_

#include <string>
#include <string_view>

#include "scene/diagnostic_list.h"

namespace truelux {

/// What is wrong with a word that stands where a number should.
struct NumberDefect {
  std::string text;
  /// Whether a file that has it once has it everywhere (a comma for a point),
  /// so that the text, which does not quote the word, is told once and counted.
  bool is_habit = false;

  /// Tells it as an error.
  void Report(int line, DiagnosticList& diagnostics) const;
};

/// What is wrong with a word that ParseNumber refuses.
NumberDefect DefectOfNumber(std::string_view word);

/// Whether a text is one of those that are told once and counted.
bool IsHabit(std::string_view text);

/// What is wrong with a corner of a face that no integer begins.
NumberDefect DefectOfCorner(std::string_view word);

}  // namespace truelux

#endif  // TRUELUX_SCENE_IO_NUMBER_DEFECT_H_
