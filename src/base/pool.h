// SPDX-License-Identifier: GPL-3.0-or-later
// Objects that are made once and used again, by one thread at a time.

#ifndef TRUELUX_BASE_POOL_H_
#define TRUELUX_BASE_POOL_H_

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace truelux {

/// Lends objects of type T. Safe to use from several threads.
template <class T>
class Pool {
 public:
  /// An object on loan; it goes back when the loan ends. The pool must outlive
  /// its loans.
  class Loan {
   public:
    Loan(Pool& pool, std::unique_ptr<T> object)
        : pool_(pool), object_(std::move(object)) {}

    Loan(const Loan&) = delete;
    Loan& operator=(const Loan&) = delete;

    ~Loan() { pool_.GiveBack(std::move(object_)); }

    T& operator*() const { return *object_; }

    T* operator->() const { return object_.get(); }

   private:
    Pool& pool_;
    std::unique_ptr<T> object_;
  };

  /// An idle object, or what make() returns (a std::unique_ptr<T>).
  template <class Make>
  Loan Borrow(const Make& make) {
    std::unique_ptr<T> object;
    {
      const std::scoped_lock lock(mutex_);
      if (!idle_.empty()) {
        object = std::move(idle_.back());
        idle_.pop_back();
      }
    }
    if (!object) object = make();
    return {*this, std::move(object)};
  }

 private:
  void GiveBack(std::unique_ptr<T> object) {
    const std::scoped_lock lock(mutex_);
    idle_.push_back(std::move(object));
  }

  std::mutex mutex_;
  std::vector<std::unique_ptr<T>> idle_;
};

}  // namespace truelux

#endif  // TRUELUX_BASE_POOL_H_
