// SPDX-License-Identifier: GPL-3.0-or-later
// Arrays that are subscripted by ids of one kind only.

#ifndef TRUELUX_BASE_ID_VECTOR_H_
#define TRUELUX_BASE_ID_VECTOR_H_

#include <cstddef>
#include <initializer_list>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/ids.h"

namespace truelux {

/// The id that follows the last one of an array of this size.
template <class Key>
constexpr Key EndId(std::size_t size) {
  return Key(static_cast<int>(size));
}

/// Consecutive ids: for (const VertexId v : IdRange<VertexId>(first, count)).
template <class Key>
class IdRange {
 public:
  /// Walks over the ids.
  class Iterator {
   public:
    constexpr explicit Iterator(Key id) : id_(id) {}

    constexpr Key operator*() const { return id_; }

    constexpr Iterator& operator++() {
      ++id_;
      return *this;
    }

    friend constexpr bool operator==(const Iterator&,
                                     const Iterator&) = default;

   private:
    Key id_;
  };

  /// `count` ids from `first` on.
  constexpr IdRange(Key first, int count)
      : first_(first), end_(Key(first.value() + count)) {}

  [[nodiscard]] constexpr Iterator begin() const { return Iterator(first_); }

  [[nodiscard]] constexpr Iterator end() const { return Iterator(end_); }

  /// How many they are.
  [[nodiscard]] constexpr int size() const {
    return end_.value() - first_.value();
  }

  /// Whether an id is one of them.
  [[nodiscard]] constexpr bool contains(Key id) const {
    return first_ <= id && id < end_;
  }

 private:
  Key first_;
  Key end_;
};

/// A std::span that is subscripted by ids.
template <class Key, class T>
class IdSpan {
 public:
  constexpr IdSpan() = default;

  /// The entry of id i is values[i].
  constexpr explicit IdSpan(std::span<T> values) : values_(values) {}

  /// What may be written may be read.
  // NOLINTNEXTLINE(google-explicit-constructor): as a span becomes a const one
  constexpr IdSpan(const IdSpan<Key, std::remove_const_t<T>>& other) requires
      std::is_const_v<T> : values_(other.values()) {}

  constexpr T& operator[](Key id) const { return values_[id.index()]; }

  [[nodiscard]] constexpr std::size_t size() const { return values_.size(); }

  [[nodiscard]] constexpr bool empty() const { return values_.empty(); }

  [[nodiscard]] constexpr IdRange<Key> ids() const {
    return {Key(0), EndId<Key>(size()).value()};
  }

  [[nodiscard]] constexpr auto begin() const { return values_.begin(); }

  [[nodiscard]] constexpr auto end() const { return values_.end(); }

  /// The entries in order, for what needs no ids.
  [[nodiscard]] constexpr std::span<T> values() const { return values_; }

  /// `count` entries from that of `first` on, without their ids.
  [[nodiscard]] constexpr std::span<T> Part(Key first, int count) const {
    return values_.subspan(first.index(), static_cast<std::size_t>(count));
  }

 private:
  std::span<T> values_;
};

/// A std::vector that is subscripted by ids. Its other members are those of
/// std::vector.
template <class Key, class T>
class IdVector {
 public:
  using Reference = typename std::vector<T>::reference;
  using ConstReference = typename std::vector<T>::const_reference;

  IdVector() = default;

  /// `size` entries with the same value.
  explicit IdVector(std::size_t size, const T& value = T())
      : values_(size, value) {}

  IdVector(std::initializer_list<T> values) : values_(values) {}

  Reference operator[](Key id) { return values_[id.index()]; }

  ConstReference operator[](Key id) const { return values_[id.index()]; }

  /// Appends a value and returns its id.
  Key push_back(T value) {
    const Key id = end_id();
    values_.push_back(std::move(value));
    return id;
  }

  /// The id that the next appended value gets.
  [[nodiscard]] Key end_id() const { return EndId<Key>(values_.size()); }

  [[nodiscard]] IdRange<Key> ids() const { return {Key(0), end_id().value()}; }

  [[nodiscard]] std::size_t size() const { return values_.size(); }

  [[nodiscard]] bool empty() const { return values_.empty(); }

  void clear() { values_.clear(); }

  void reserve(std::size_t size) { values_.reserve(size); }

  void resize(std::size_t size) { values_.resize(size); }

  void resize(std::size_t size, const T& value) { values_.resize(size, value); }

  [[nodiscard]] auto begin() { return values_.begin(); }

  [[nodiscard]] auto begin() const { return values_.begin(); }

  [[nodiscard]] auto end() { return values_.end(); }

  [[nodiscard]] auto end() const { return values_.end(); }

  [[nodiscard]] ConstReference front() const { return values_.front(); }

  Reference back() { return values_.back(); }

  [[nodiscard]] ConstReference back() const { return values_.back(); }

  /// Appends a range of values.
  template <class Range>
  void Append(const Range& values) {
    values_.insert(values_.end(), values.begin(), values.end());
  }

  /// Removes the last value.
  void pop_back() { values_.pop_back(); }

  /// The values in order, for what needs no ids.
  [[nodiscard]] const std::vector<T>& values() const { return values_; }

  /// `count` entries from that of `first` on, without their ids.
  [[nodiscard]] std::span<const T> Part(Key first, int count) const {
    return IdSpan<Key, const T>(*this).Part(first, count);
  }

  // NOLINTNEXTLINE(google-explicit-constructor): as a vector becomes a span
  operator IdSpan<Key, const T>() const {
    return IdSpan<Key, const T>(std::span<const T>(values_));
  }

  // NOLINTNEXTLINE(google-explicit-constructor): as a vector becomes a span
  operator IdSpan<Key, T>() { return IdSpan<Key, T>(std::span<T>(values_)); }

  friend bool operator==(const IdVector&, const IdVector&) = default;

 private:
  std::vector<T> values_;
};

}  // namespace truelux

#endif  // TRUELUX_BASE_ID_VECTOR_H_
