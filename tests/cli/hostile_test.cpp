// SPDX-License-Identifier: GPL-3.0-or-later
// What goes wrong around the program: names of files that lead to one file or
// round in a circle, names that are no texts, limits of the system, endless
// inputs. Each ends at once, with one line and the right exit status.

#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <string>
#include <string_view>
#include <sys/file.h>
#include <sys/resource.h>
#include <unistd.h>
#include <vector>

#include <gtest/gtest.h>

#include "cli/program.h"

namespace truelux::test {
namespace {

namespace fs = std::filesystem;

bool Contains(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

class Hostile : public testing::Test {
 protected:
  /// Runs eval in the folder for one receiver.
  [[nodiscard]] Outcome Eval(const std::vector<std::string>& more) const {
    std::vector<std::string> words = {"eval",  scene_,     "--at",
                                      "0,0,0", "--normal", "0,0,1"};
    words.insert(words.end(), more.begin(), more.end());
    return RunTruelux(words);
  }

  TemporaryFolder folder_;
  std::string scene_ = WriteSquare(folder_);
};

/// The working folder of the test and of what it starts.
class WorkingFolder {
 public:
  explicit WorkingFolder(const std::string& path) : old_(fs::current_path()) {
    fs::current_path(path);
  }

  ~WorkingFolder() { fs::current_path(old_); }

  WorkingFolder(const WorkingFolder&) = delete;
  WorkingFolder& operator=(const WorkingFolder&) = delete;

 private:
  fs::path old_;
};

TEST_F(Hostile, TwoNamesOfOneNewFileAreNoticed) {
  fs::create_directory(folder_ / "sub");
  fs::create_directory_symlink(folder_ / "sub", folder_ / "link");
  fs::create_symlink("target", folder_ / "points");
  fs::create_symlink(folder_ / "sub/far", folder_ / "far");
  const WorkingFolder here(folder_ / "");
  const std::vector<std::vector<std::string>> pairs = {
      {"q", "./q"},        {"q", folder_ / "q"}, {"sub/../q", "q"},
      {"sub/q", "link/q"}, {"points", "target"}, {"points", "./sub/../target"},
      {"far", "sub/far"},  {"link/far", "far"},  {"link/./q", "sub//q"}};
  for (const std::vector<std::string>& pair : pairs) {
    for (const bool swap : {false, true}) {
      const Outcome outcome =
          Eval({"-o", pair[swap ? 1 : 0], "--stats", pair[swap ? 0 : 1]});
      EXPECT_EQ(outcome.exit_status, 2) << pair[0] << ' ' << pair[1];
      EXPECT_TRUE(Contains(outcome.err, "are the same file")) << outcome.err;
    }
  }
  // And files that are two are two.
  EXPECT_EQ(Eval({"-o", "q", "--stats", "sub/q"}).exit_status, 0);
  EXPECT_EQ(Eval({"-o", "one", "--stats", "ONE"}).exit_status, 0);
}

TEST_F(Hostile, ALoopOfLinksIsAnError) {
  fs::create_symlink("b", folder_ / "a");
  fs::create_symlink("a", folder_ / "b");
  for (const char* option : {"-o", "--stats"}) {
    const Outcome outcome = Eval({option, folder_ / "a"});
    EXPECT_EQ(outcome.exit_status, 2);
    EXPECT_TRUE(Contains(outcome.err, "symbolic links")) << outcome.err;
    EXPECT_TRUE(fs::is_symlink(folder_ / "a"));
  }
}

TEST_F(Hostile, NamesStayOnOneLine) {
  const Outcome outcome = RunTruelux(
      {"eval", "a\nb\x1b[31m.obj", "--at", "0,0,0", "--normal", "0,0,1"});
  EXPECT_EQ(outcome.exit_status, 2);
  EXPECT_EQ(outcome.err,
            "a\\x0ab\\x1b[31m.obj: error: cannot be read: No such file or "
            "directory\n");
}

/// Names of groups with all that no document may have in it.
std::vector<std::string> StrangeNames() {
  return {"\xef\xbf\xbe\xef\xbf\xbf",  // U+FFFE, U+FFFF
          "\xf0\x9f\xbf\xbe",          // U+1FFFE
          "\xef\xb7\x90",              // U+FDD0
          "\xed\xa0\x80",              // half a surrogate pair
          "\xc2\x85\xc2\x80",          // controls
          "\xff\xfe\x80",              // no UTF-8 at all
          "\xe2\x82",                  // a part of a character
          "<&\"'>]]>",
          std::string(6000, 'x')};
}

/// The characters of a valid UTF-8 text.
bool IsCleanUtf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = [&](std::size_t k) {
      return i + k < text.size() ? static_cast<unsigned char>(text[i + k]) : 0U;
    };
    const unsigned first = byte(0);
    const std::size_t size = first < 0x80   ? 1
                             : first < 0xC2 ? 0
                             : first < 0xE0 ? 2
                             : first < 0xF0 ? 3
                             : first < 0xF5 ? 4
                                            : 0;
    if (size == 0) return false;
    unsigned code = size == 1 ? first : first & (0x7FU >> size);
    for (std::size_t k = 1; k < size; ++k) {
      if ((byte(k) & 0xC0U) != 0x80U) return false;
      code = code << 6U | (byte(k) & 0x3FU);
    }
    const bool is_control = code < 0x20 && code != '\n' && code != '\t';
    if (is_control || (code >= 0x7F && code < 0xA0)) return false;
    if ((code & 0xFFFEU) == 0xFFFEU || (code >= 0xFDD0 && code <= 0xFDEF))
      return false;
    if (code >= 0xD800 && code < 0xE000) return false;
    i += size;
  }
  return true;
}

TEST_F(Hostile, DocumentsAreCleanWhateverTheNames) {
  int number = 0;
  for (const std::string& name : StrangeNames()) {
    const std::string scene = folder_.Write(
        "s.obj",
        "mtllib square.mtl\nv -1 -1 1\nv -1 1 1\nv 1 1 1\nv 1 -1 1\n"
        "g " +
            name + "\nusemtl light\nf 1 2 3 4\n");
    const std::string svg = folder_ / fmt::format("{}.svg", number++);
    const Outcome inspect =
        RunTruelux({"inspect", scene, "--at", "0,0,0", "--normal", "0,0,1",
                    "-o", svg, "--json", "-"});
    EXPECT_EQ(inspect.exit_status, 0) << inspect.err;
    EXPECT_TRUE(IsCleanUtf8(ReadFile(svg))) << number;
    EXPECT_LT(ReadFile(svg).find("</svg>"), std::string::npos);
    // A candidate that leaves the group out.
    const std::string table = folder_.Write(
        "c.csv", "x,y,z,nx,ny,nz,E_r,E_g,E_b\n0,0,0,0,0,1,9,9,9\n");
    const Outcome compare = RunTruelux({"compare", scene, table});
    EXPECT_EQ(compare.exit_status, 1) << compare.err;
  }
}

TEST_F(Hostile, NothingButNanHasNoLargestError) {
  const std::string table = folder_.Write(
      "c.csv", "x,y,z,nx,ny,nz,E_r,E_g,E_b\n0,0,0,0,0,1,nan,nan,nan\n");
  const Outcome outcome = RunTruelux({"compare", scene_, table});
  EXPECT_EQ(outcome.exit_status, 1);
  EXPECT_TRUE(Contains(outcome.out, "not a number           1"));
  EXPECT_FALSE(Contains(outcome.out, "absolute error"));
}

TEST_F(Hostile, ManyNamesCostNothing) {
  std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (int i = 0; i < 100000; ++i)
    obj += fmt::format("g part_{}\nf 1 2 3\n", i);
  const std::string scene = folder_.Write("many.obj", obj);
  const Outcome outcome = RunTruelux(
      {"render", scene, "--surface", "nope", "-o", folder_ / "x.png"});
  EXPECT_EQ(outcome.exit_status, 2);
  EXPECT_TRUE(outcome.err.ends_with("'part_19' and 99980 more\n"));
}

TEST_F(Hostile, ATallPictureHasANarrowLegend) {
  const std::string picture = folder_ / "x.png";
  const Outcome outcome =
      RunTruelux({"render", scene_, "--eye", "0,0,-3", "--target", "0,0,1",
                  "--up", "0,1,0", "--fov", "60", "--size", "1x65536",
                  "--false-colour", "-o", picture});
  EXPECT_EQ(outcome.exit_status, 0) << outcome.err;
  EXPECT_LT(fs::file_size(picture), 10'000'000U);
}

// Old and without a lock: dead. Young, or locked: somebody's.
TEST_F(Hostile, FilesOfKilledRunsAreRemoved) {
  const std::string dead = folder_.Write(".truelux-1-0.tmp", "half");
  const std::string young = folder_.Write(".truelux-2-0.tmp", "half");
  const std::string locked = folder_.Write(".truelux-3-0.tmp", "half");
  const std::string other = folder_.Write(".truelux-4-0.tmpx", "half");
  const auto hours_ago =
      fs::file_time_type::clock::now() - std::chrono::hours(3);
  for (const std::string& path : {dead, locked, other})
    fs::last_write_time(path, hours_ago);
  const int fd = open(locked.c_str(), O_RDONLY | O_CLOEXEC);
  ASSERT_EQ(flock(fd, LOCK_EX), 0);
  const Outcome outcome = Eval({"-o", folder_ / "out.csv"});
  close(fd);
  EXPECT_EQ(outcome.exit_status, 0);
  EXPECT_EQ(outcome.err, "note: " + dead +
                             " was left by a run that was killed, and is "
                             "removed\n");
  EXPECT_FALSE(fs::exists(dead));
  EXPECT_TRUE(fs::exists(young) && fs::exists(locked) && fs::exists(other));
}

TEST_F(Hostile, EndlessScenesHearSignals) {
  for (const int signal : {SIGTERM, SIGINT}) {
    Surroundings around;
    int looks = 0;
    around.watch = [&](pid_t pid) {
      // Once it has a temporary file it has begun; then a few looks later.
      if (looks == 0 && folder_.Names().size() < 3) return false;
      if (++looks < 20) return false;
      kill(pid, signal);
      return true;
    };
    const Outcome outcome =
        RunTruelux({"eval", "/dev/zero", "--at", "0,0,0", "--normal", "0,0,1",
                    "-o", folder_ / "out.csv"},
                   around);
    EXPECT_EQ(outcome.exit_status, 130);
    EXPECT_EQ(outcome.err, "interrupted\n");
    EXPECT_EQ(folder_.Names(),
              (std::vector<std::string>{"square.mtl", "square.obj"}));
  }
}

// The system gives no memory: whatever the limit, a line and status 3, or the
// work done.
TEST_F(Hostile, LittleMemoryIsSaid) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers take terabytes of addresses";
#endif
  std::string obj = "mtllib square.mtl\nusemtl light\n";
  for (int i = 0; i < 60000; ++i)
    obj += fmt::format("v {0} 0 1\nv {0} 1 1\nv {0}.5 1 1\nf -3 -2 -1\n{1}", i,
                       i == 0 ? "usemtl\n" : "");
  const std::string scene = folder_.Write("large.obj", obj);
  rlimit old{};
  getrlimit(RLIMIT_AS, &old);
  int done = 0;
  int refused = 0;
  for (rlim_t megabytes = 76; megabytes <= 200; megabytes += 4) {
    rlimit limit = old;
    limit.rlim_cur = megabytes << 20U;
    setrlimit(RLIMIT_AS, &limit);
    const Outcome outcome =
        RunTruelux({"eval", scene, "--at", "0,0,0", "--normal", "0,0,1", "-o",
                    folder_ / "out.csv", "--threads", "1"});
    setrlimit(RLIMIT_AS, &old);
    if (outcome.exit_status == 0) {
      ++done;
      fs::remove(folder_ / "out.csv");
    } else {
      ++refused;
      EXPECT_EQ(outcome.exit_status, 3) << megabytes << ' ' << outcome.err;
      EXPECT_TRUE(outcome.err.ends_with("internal error: out of memory\n"))
          << outcome.err;
    }
    EXPECT_EQ(folder_.Names(), (std::vector<std::string>{
                                   "large.obj", "square.mtl", "square.obj"}));
  }
  EXPECT_GT(done, 0);
  EXPECT_GT(refused, 0);
}

}  // namespace
}  // namespace truelux::test
