// SPDX-License-Identifier: GPL-3.0-or-later
// A library to be loaded before a program (LD_PRELOAD): one call of one
// function of the system fails, as it may on any day.
//
//   TRUELUX_FAULT=NAME:N   the N-th call of NAME, from 1, since main began
//   TRUELUX_FAULT_MARK=F   the file F is made when that call comes
//
// NAME: allocate, write, open, rename, close, thread.

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/syscall.h>
#include <unistd.h>

// The names are those of the C library.
// NOLINTBEGIN(bugprone-reserved-identifier,readability-identifier-naming)
// NOLINTBEGIN(readability-inconsistent-declaration-parameter-name)

extern "C" {
void* __libc_malloc(size_t size);
void* __libc_calloc(size_t count, size_t size);
void* __libc_realloc(void* memory, size_t size);
void* __libc_memalign(size_t alignment, size_t size);
}

namespace {

enum class Fault : int {
  kNone,
  kAllocate,
  kWrite,
  kOpen,
  kRename,
  kClose,
  kThread
};

// Zeroed before anything runs; set when main begins.
std::atomic<Fault> armed;
std::atomic<long> calls_left;

/// Whether this call is the one.
bool Fails(Fault fault) {
  if (armed.load(std::memory_order_relaxed) != fault) return false;
  if (calls_left.fetch_sub(1) != 1) return false;
  if (const char* mark = std::getenv("TRUELUX_FAULT_MARK")) {
    // Not by open or close, which may be what fails.
    const long fd =
        syscall(SYS_openat, AT_FDCWD, mark, O_CREAT | O_WRONLY, 0600);
    if (fd >= 0) syscall(SYS_close, fd);
  }
  return true;
}

Fault FaultNamed(const char* name, std::size_t size) {
  struct Named {
    const char* name;
    Fault fault;
  };

  constexpr Named kAll[] = {
      {"allocate", Fault::kAllocate}, {"write", Fault::kWrite},
      {"open", Fault::kOpen},         {"rename", Fault::kRename},
      {"close", Fault::kClose},       {"thread", Fault::kThread}};
  for (const Named& named : kAll) {
    if (std::strlen(named.name) == size &&
        std::strncmp(named.name, name, size) == 0)
      return named.fault;
  }
  std::abort();
}

void Arm() {
  const char* text = std::getenv("TRUELUX_FAULT");
  if (text == nullptr) return;
  const char* colon = std::strchr(text, ':');
  if (colon == nullptr) std::abort();
  calls_left = std::strtol(colon + 1, nullptr, 10);
  armed = FaultNamed(text, static_cast<std::size_t>(colon - text));
}

template <class Function>
Function Next(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

using Main = int (*)(int, char**, char**);
Main program_main;

int ArmedMain(int argc, char** argv, char** environment) {
  Arm();
  return program_main(argc, argv, environment);
}

}  // namespace

extern "C" {

int __libc_start_main(Main main, int argc, char** argv, void (*init)(),
                      void (*fini)(), void (*rtld_fini)(), void* stack_end) {
  program_main = main;
  using Start =
      int (*)(Main, int, char**, void (*)(), void (*)(), void (*)(), void*);
  return Next<Start>("__libc_start_main")(ArmedMain, argc, argv, init, fini,
                                          rtld_fini, stack_end);
}

void* malloc(size_t size) {
  if (Fails(Fault::kAllocate)) {
    errno = ENOMEM;
    return nullptr;
  }
  return __libc_malloc(size);
}

void* calloc(size_t count, size_t size) {
  if (Fails(Fault::kAllocate)) {
    errno = ENOMEM;
    return nullptr;
  }
  return __libc_calloc(count, size);
}

void* realloc(void* memory, size_t size) {
  if (size != 0 && Fails(Fault::kAllocate)) {
    errno = ENOMEM;
    return nullptr;
  }
  return __libc_realloc(memory, size);
}

void* aligned_alloc(size_t alignment, size_t size) {
  if (Fails(Fault::kAllocate)) {
    errno = ENOMEM;
    return nullptr;
  }
  return __libc_memalign(alignment, size);
}

int posix_memalign(void** memory, size_t alignment, size_t size) {
  if (Fails(Fault::kAllocate)) return ENOMEM;
  *memory = __libc_memalign(alignment, size);
  return *memory == nullptr ? ENOMEM : 0;
}

ssize_t write(int fd, const void* bytes, size_t size) {
  // Messages get through: a test reads them.
  if (fd != STDERR_FILENO && Fails(Fault::kWrite)) {
    errno = ENOSPC;
    return -1;
  }
  return syscall(SYS_write, fd, bytes, size);
}

int open(const char* path, int flags, ...) {
  mode_t mode = 0;
  if ((flags & O_CREAT) != 0) {
    va_list arguments;
    va_start(arguments, flags);
    mode = va_arg(arguments, mode_t);
    va_end(arguments);
  }
  if (Fails(Fault::kOpen)) {
    errno = EMFILE;
    return -1;
  }
  return static_cast<int>(syscall(SYS_openat, AT_FDCWD, path, flags, mode));
}

int rename(const char* from, const char* to) {
  if (Fails(Fault::kRename)) {
    errno = EIO;
    return -1;
  }
  return static_cast<int>(
      syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0));
}

int close(int fd) {
  if (Fails(Fault::kClose)) {
    syscall(SYS_close, fd);
    errno = EIO;
    return -1;
  }
  return static_cast<int>(syscall(SYS_close, fd));
}

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes,
                   void* (*start)(void*), void* argument) {
  if (Fails(Fault::kThread)) return EAGAIN;
  using Create =
      int (*)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
  return Next<Create>("pthread_create")(thread, attributes, start, argument);
}
}

// NOLINTEND(readability-inconsistent-declaration-parameter-name)
// NOLINTEND(bugprone-reserved-identifier,readability-identifier-naming)
