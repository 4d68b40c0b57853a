// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/program.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <climits>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <poll.h>
#include <pty.h>
#include <sstream>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>

namespace truelux::test {
namespace {

namespace fs = std::filesystem;

/// Both ends of a pipe; -1: closed.
struct Pipe {
  int read_end = -1;
  int write_end = -1;
};

void Close(int& fd) {
  if (fd >= 0) close(fd);
  fd = -1;
}

Pipe OpenPipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("pipe2");
  return {ends[0], ends[1]};
}

Pipe OpenTerminal() {
  Pipe ends;
  if (openpty(&ends.read_end, &ends.write_end, nullptr, nullptr, nullptr) !=
      0) {
    throw std::runtime_error("openpty");
  }
  fcntl(ends.read_end, F_SETFD, FD_CLOEXEC);
  fcntl(ends.write_end, F_SETFD, FD_CLOEXEC);
  return ends;
}

/// In the child: becomes the program.
[[noreturn]] void Become(const std::vector<std::string>& arguments, int in,
                         int out, int err) {
  dup2(in, STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  dup2(err, STDERR_FILENO);
  std::string program = TRUELUX_PROGRAM;
  std::vector<std::string> words = arguments;
  std::vector<char*> argv = {program.data()};
  for (std::string& word : words)
    argv.push_back(word.data());
  argv.push_back(nullptr);
  execv(program.c_str(), argv.data());
  _exit(127);
}

/// Takes what there is; closes the descriptor at the end.
void ReadSome(int& fd, std::string& text) {
  std::array<char, 4096> buffer{};
  const ssize_t n = read(fd, buffer.data(), buffer.size());
  if (n > 0) {
    text.append(buffer.data(), static_cast<std::size_t>(n));
  } else {
    Close(fd);
  }
}

void WriteSome(int& fd, std::string_view& text, bool keep_open) {
  if (!text.empty()) {
    const ssize_t n =
        write(fd, text.data(), std::min<std::size_t>(text.size(), PIPE_BUF));
    if (n < 0) return Close(fd);
    text.remove_prefix(static_cast<std::size_t>(n));
  }
  if (text.empty() && !keep_open) Close(fd);
}

/// The parent's ends of the three streams.
struct Streams {
  int in = -1;
  int out = -1;
  int err = -1;
};

/// Feeds and reads the program until it has closed its streams.
void Converse(Streams& streams, const Surroundings& around, pid_t pid,
              Outcome& outcome) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point deadline = Clock::now() + std::chrono::minutes(1);
  std::string_view input = around.input;
  std::function<bool(pid_t)> watch = around.watch;
  int ignored_out = -1;
  if (around.ignore_output) std::swap(ignored_out, streams.out);
  while (streams.out >= 0 || streams.err >= 0) {
    if (watch && watch(pid)) watch = nullptr;
    if (Clock::now() > deadline) kill(pid, SIGKILL);
    const bool writes = streams.in >= 0 && !input.empty();
    std::array<pollfd, 3> waiting = {
        pollfd{writes ? streams.in : -1, POLLOUT, 0},
        pollfd{streams.out, POLLIN, 0}, pollfd{streams.err, POLLIN, 0}};
    if (!writes && streams.in >= 0 && !around.keep_input_open) {
      Close(streams.in);
    }
    if (poll(waiting.data(), waiting.size(), 10) <= 0) continue;
    if (waiting[0].revents != 0) {
      WriteSome(streams.in, input, around.keep_input_open);
    }
    if (waiting[1].revents != 0) ReadSome(streams.out, outcome.out);
    if (waiting[2].revents != 0) ReadSome(streams.err, outcome.err);
  }
  Close(ignored_out);
}

}  // namespace

Outcome RunTruelux(const std::vector<std::string>& arguments,
                   const Surroundings& around) {
  std::signal(SIGPIPE, SIG_IGN);
  Pipe in = OpenPipe();
  Pipe out = OpenPipe();
  Pipe err = around.terminal ? OpenTerminal() : OpenPipe();
  if (!around.output_path.empty()) {
    Close(out.write_end);
    out.write_end =
        open(around.output_path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
  }
  const pid_t pid = fork();
  if (pid == 0) {
    // What the test ignores, the program shall not inherit.
    std::signal(SIGPIPE, SIG_DFL);
    if (around.close_output) close(out.read_end);
    Become(arguments, in.read_end, out.write_end, err.write_end);
  }
  Close(in.read_end);
  Close(out.write_end);
  Close(err.write_end);
  if (around.close_output) Close(out.read_end);
  Outcome outcome;
  Streams streams{in.write_end, out.read_end, err.read_end};
  Converse(streams, around, pid, outcome);
  int status = 0;
  waitpid(pid, &status, 0);
  Close(streams.in);
  if (WIFEXITED(status)) outcome.exit_status = WEXITSTATUS(status);
  return outcome;
}

TemporaryFolder::TemporaryFolder() {
  std::string name = (fs::temp_directory_path() / "truelux-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("mkdtemp");
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::string TemporaryFolder::operator/(std::string_view name) const {
  return (path_ / name).string();
}

std::string TemporaryFolder::Write(std::string_view name,
                                   std::string_view text) const {
  std::string path = *this / name;
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

std::vector<std::string> TemporaryFolder::Names() const {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(path_)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string ReadFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string WriteSquare(const TemporaryFolder& folder) {
  folder.Write("square.mtl", kSquareMtl);
  return folder.Write("square.obj", kSquareObj);
}

std::string Table(int count) {
  std::string text(kHeader);
  for (int i = 0; i < count; ++i) {
    text += "0." + std::to_string(i) + ",0,0,0,0,1\n";
  }
  return text;
}

}  // namespace truelux::test
