// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/last_words.h"

#include <array>
#include <atomic>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <flint/flint.h>
#include <new>
#include <unistd.h>

#include <gmp.h>

#include "run/exit_status.h"

namespace truelux {
namespace {

enum class SlotState : int { kFree, kFilling, kKept };

struct Slot {
  std::atomic<SlotState> state = SlotState::kFree;
  std::array<char, TemporaryName::kLongest> path{};
};

static_assert(std::atomic<SlotState>::is_always_lock_free,
              "a signal handler may touch only lock-free atomics");

/// Global, as whatever ends the process knows nothing else.
std::array<Slot, TemporaryName::kMost> slots;
std::atomic<bool> is_ending = false;

constexpr int kInternalError = static_cast<int>(ExitStatus::kInternalError);

[[noreturn]] void EndWithoutMemory() {
  EndNow("internal error: out of memory\n", kInternalError);
}

void* Checked(void* memory) {
  if (memory == nullptr) EndWithoutMemory();
  return memory;
}

// For GMP and MPFR. They never ask for 0 bytes.

void* AllocateForGmp(std::size_t size) {
  return Checked(std::malloc(size));
}

void* ReallocateForGmp(void* memory, std::size_t /*old_size*/,
                       std::size_t size) {
  return Checked(std::realloc(memory, size));
}

void FreeForGmp(void* memory, std::size_t /*size*/) {
  std::free(memory);
}

// For FLINT, which may ask for 0 bytes.

void* AllocateForFlint(std::size_t size) {
  return Checked(std::malloc(size == 0 ? 1 : size));
}

void* AllocateZerosForFlint(std::size_t count, std::size_t size) {
  return Checked(std::calloc(count == 0 ? 1 : count, size == 0 ? 1 : size));
}

void* ReallocateForFlint(void* memory, std::size_t size) {
  return Checked(std::realloc(memory, size == 0 ? 1 : size));
}

/// What an exception says that nobody catches; nothing else may be running
/// that needs memory or locks.
[[noreturn]] void EndUncaught() {
  if (const std::exception_ptr error = std::current_exception()) {
    try {
      std::rethrow_exception(error);
    } catch (const std::bad_alloc&) {
      EndWithoutMemory();
    } catch (...) {
      // The line below.
    }
  }
  EndNow(
      "internal error: the system refuses what is needed to go on (threads, "
      "memory); fewer --threads may help\n",
      kInternalError);
}

}  // namespace

bool TemporaryName::Keep(const char* path) {
  const std::size_t size = std::strlen(path) + 1;
  if (size > kLongest) return false;
  for (std::size_t i = 0; i < slots.size(); ++i) {
    SlotState expected = SlotState::kFree;
    Slot& slot = slots[i];
    if (!slot.state.compare_exchange_strong(expected, SlotState::kFilling))
      continue;
    std::memcpy(slot.path.data(), path, size);
    slot.state = SlotState::kKept;
    slot_ = static_cast<int>(i);
    return true;
  }
  return false;
}

void TemporaryName::Forget() {
  if (slot_ < 0) return;
  slots[static_cast<std::size_t>(slot_)].state = SlotState::kFree;
  slot_ = -1;
}

void EndNow(const char* line, int exit_status) {
  // The handler of a signal may have come in between.
  if (is_ending.exchange(true)) _exit(exit_status);
  for (Slot& slot : slots) {
    if (slot.state == SlotState::kKept) unlink(slot.path.data());
  }
  constexpr const char* kClearLine = "\r\033[K";
  const auto write_all = [](const char* text) {
    // What cannot be told cannot be told.
    [[maybe_unused]] const ssize_t written =
        write(STDERR_FILENO, text, std::strlen(text));
  };
  if (isatty(STDERR_FILENO) != 0) write_all(kClearLine);
  write_all(line);
  _exit(exit_status);
}

void EndWhereNothingHelps() {
  std::set_new_handler(EndWithoutMemory);
  mp_set_memory_functions(AllocateForGmp, ReallocateForGmp, FreeForGmp);
  __flint_set_memory_functions(AllocateForFlint, AllocateZerosForFlint,
                               ReallocateForFlint, std::free);
  std::set_terminate(EndUncaught);
}

}  // namespace truelux
