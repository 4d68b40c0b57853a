// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the program truelux from outside, as a user does.

#ifndef TRUELUX_TESTS_CLI_PROGRAM_H_
#define TRUELUX_TESTS_CLI_PROGRAM_H_

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <sys/types.h>
#include <vector>

namespace truelux::test {

/// What is around the program.
struct Surroundings {
  std::string input = {};        ///< what standard input gives
  bool keep_input_open = false;  ///< no end of standard input
  std::string output_path = {};  ///< standard output goes there
  bool close_output = false;     ///< nobody reads standard output
  bool ignore_output = false;    ///< it is never read, but not closed
  bool terminal = false;         ///< standard error is a terminal
  /// Looks at the program about a hundred times a second; true: no more.
  std::function<bool(pid_t)> watch = {};
};

/// How it ended. A run of more than a minute is stopped by a signal.
struct Outcome {
  int exit_status = -1;  ///< -1: ended by a signal
  std::string out;
  std::string err;
};

Outcome RunTruelux(const std::vector<std::string>& arguments,
                   const Surroundings& around = {});

/// A folder for one test, removed with all that is in it.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  /// The path of a file in it.
  [[nodiscard]] std::string operator/(std::string_view name) const;

  /// Writes a file and returns its path.
  // NOLINTNEXTLINE(modernize-use-nodiscard): not every test needs the path
  std::string Write(std::string_view name, std::string_view text) const;

  /// The names in it, sorted.
  [[nodiscard]] std::vector<std::string> Names() const;

 private:
  std::filesystem::path path_;
};

std::string ReadFile(const std::string& path);

/// A square of side 2, one unit above the plane z = 0, that shines down, with
/// all channels different; and a table of receivers below it.
inline constexpr std::string_view kSquareObj =
    "mtllib square.mtl\n"
    "v -1 -1 1\nv -1 1 1\nv 1 1 1\nv 1 -1 1\n"
    "usemtl light\nf 1 2 3 4\n";
inline constexpr std::string_view kSquareMtl = "newmtl light\nKe 1 2 0\n";
inline constexpr std::string_view kHeader = "x,y,z,nx,ny,nz\n";

/// Writes square.obj and square.mtl; returns the path of the former.
std::string WriteSquare(const TemporaryFolder& folder);

/// The header and `count` rows, all different.
std::string Table(int count);

}  // namespace truelux::test

#endif  // TRUELUX_TESTS_CLI_PROGRAM_H_
