// SPDX-License-Identifier: GPL-3.0-or-later
// An output that is there whole or not at all.

#ifndef TRUELUX_RUN_OUTPUT_FILE_H_
#define TRUELUX_RUN_OUTPUT_FILE_H_

#include <optional>
#include <string>
#include <string_view>

#include "run/file_id.h"
#include "run/last_words.h"

namespace truelux {

/// Thrown when nobody reads standard output any more (`| head`): all that was
/// wanted has been written.
struct ReaderGone {};

/// A file, or standard output, to be written once.
///
/// A new or regular file is written under a temporary name in its folder and
/// appears under its own name on Commit(); without that, nothing of it
/// remains. Anything else that exists (a device, a pipe), and whatever
/// standard output is, is written directly.
///
/// Errors are thrown as UserError; while it waits for the reader of a pipe,
/// an interruption as Stopped; that the reader of standard output has gone
/// as ReaderGone.
class OutputFile {
 public:
  /// path: "" or "-" is standard output.
  explicit OutputFile(const std::string& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void Write(std::string_view text);

  /// After the last Write: makes sure that everything has been written.
  void Finish();

  /// After Finish: gives the file its name.
  void Commit();

 private:
  void OpenTemporary();
  void CloseQuietly();

  std::string name_;       ///< for messages
  std::string path_;       ///< final path, links followed; see temporary_
  std::string temporary_;  ///< path; "": written directly or committed
  TemporaryName kept_;     ///< temporary_, for an end in a hurry
  int fd_ = -1;
  bool may_block_ = false;
};

}  // namespace truelux

#endif  // TRUELUX_RUN_OUTPUT_FILE_H_
