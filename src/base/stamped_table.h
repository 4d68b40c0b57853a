// SPDX-License-Identifier: GPL-3.0-or-later
// Tables whose entries are forgotten all at once, in constant time: what is
// kept for one receiver, or for one source, and is worth nothing for the next.

#ifndef TRUELUX_BASE_STAMPED_TABLE_H_
#define TRUELUX_BASE_STAMPED_TABLE_H_

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/ids.h"

namespace truelux {

/// Maps keys, each an Id or a small integer, to values of type T. Every entry
/// carries a stamp, and only an entry with the table's current stamp is set:
/// Clear() takes the next stamp and touches no entry.
///
/// The stamps wrap around after 2^32 - 1 clears; Clear() then resets all
/// entries once, so that an old entry never seems set again. (Stamp is a
/// parameter so that a test can get there.)
///
/// Allocates only in Cover(), and there only for more keys than ever before.
template <class T, class Key = int, class Stamp = std::uint32_t>
class StampedTable {
 public:
  /// Room for the keys 0 .. size - 1; none of them is set.
  explicit StampedTable(std::size_t size = 0) : entries_(size) {}

  /// Makes room for the keys below `size`. What is set stays set, but
  /// references to values end if the table grows.
  void Cover(std::size_t size) {
    if (size > entries_.size()) entries_.resize(size);
  }

  /// Forgets all entries. The values themselves live on, for Renew.
  void Clear() {
    if (++stamp_ != kNever) return;
    for (Entry& entry : entries_)
      entry.stamp = kNever;
    ++stamp_;
  }

  /// The value of a key; null if the key is not set, or if there is no room for
  /// it yet.
  [[nodiscard]] T* Find(Key key) {
    const std::size_t index = IndexOf(key);
    if (index >= entries_.size() || entries_[index].stamp != stamp_) {
      return nullptr;
    }
    return &entries_[index].value;
  }

  /// Whether a key is set. Requires room for it, as all that follows.
  [[nodiscard]] bool Has(Key key) const { return At(key).stamp == stamp_; }

  /// The value of a key. Requires Has(key).
  [[nodiscard]] T& operator[](Key key) {
    assert(Has(key));
    return At(key).value;
  }

  /// The same, to read.
  [[nodiscard]] const T& operator[](Key key) const {
    assert(Has(key));
    return At(key).value;
  }

  /// Sets a key.
  T& Set(Key key, T value) {
    T& place = Renew(key);
    place = std::move(value);
    return place;
  }

  /// Sets a key to whatever value it had last, possibly before a Clear() (a
  /// new one at first): for values whose memory is used again.
  T& Renew(Key key) {
    Entry& entry = At(key);
    entry.stamp = stamp_;
    return entry.value;
  }

  /// The value of a key, which is set to make() if it is not set. make() must
  /// not change this table.
  template <class Make>
  T& FindOrMake(Key key, const Make& make) {
    Entry& entry = At(key);
    if (entry.stamp != stamp_) {
      entry.value = make();
      entry.stamp = stamp_;
    }
    return entry.value;
  }

 private:
  static constexpr Stamp kNever = 0;  ///< no table's current stamp

  struct Entry {
    Stamp stamp = kNever;
    [[no_unique_address]] T value{};
  };

  static std::size_t IndexOf(int key) {
    assert(key >= 0);
    return static_cast<std::size_t>(key);
  }

  template <class Tag>
  static std::size_t IndexOf(Id<Tag> key) {
    return key.index();
  }

  [[nodiscard]] Entry& At(Key key) {
    const std::size_t index = IndexOf(key);
    assert(index < entries_.size());
    return entries_[index];
  }

  [[nodiscard]] const Entry& At(Key key) const {
    const std::size_t index = IndexOf(key);
    assert(index < entries_.size());
    return entries_[index];
  }

  std::vector<Entry> entries_;
  Stamp stamp_ = kNever + 1;
};

/// A set of keys: a StampedTable without values.
template <class Key = int>
class StampedSet {
 public:
  /// Room for the keys 0 .. size - 1; none of them is in the set.
  explicit StampedSet(std::size_t size = 0) : table_(size) {}

  /// Takes out all keys, in constant time.
  void Clear() { table_.Clear(); }

  /// Puts in a key. Requires room for it.
  void Insert(Key key) { table_.Renew(key); }

  /// Whether a key is in the set. Requires room for it.
  [[nodiscard]] bool Contains(Key key) const { return table_.Has(key); }

 private:
  struct Nothing {};

  StampedTable<Nothing, Key> table_;
};

}  // namespace truelux

#endif  // TRUELUX_BASE_STAMPED_TABLE_H_
