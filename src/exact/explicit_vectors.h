// SPDX-License-Identifier: GPL-3.0-or-later
// Exact vectors that no recipe describes, for headers that do not need CGAL.

#ifndef TRUELUX_EXACT_EXPLICIT_VECTORS_H_
#define TRUELUX_EXACT_EXPLICIT_VECTORS_H_

#include <initializer_list>
#include <memory>

#include "base/id_vector.h"

namespace CGAL {  // NOLINT(readability-identifier-naming)
struct Mpzf;
}  // namespace CGAL

namespace truelux {

using Exact = CGAL::Mpzf;  // as in number.h, which has its definition

template <class T>
struct Vec3;

/// The vectors that PlaneRecipe::Kind::kExplicit and
/// DirectionRecipe::Kind::kExplicit refer to. Including this header does not
/// include CGAL; using the vectors needs number.h and vec3.h.
class ExplicitVectors {
 public:
  ExplicitVectors();
  ExplicitVectors(std::initializer_list<Vec3<Exact>> vectors);
  ExplicitVectors(const ExplicitVectors& other);
  ExplicitVectors(ExplicitVectors&& other) noexcept;
  ExplicitVectors& operator=(const ExplicitVectors& other);
  ExplicitVectors& operator=(ExplicitVectors&& other) noexcept;
  ~ExplicitVectors();

  /// Appends a vector and returns its id.
  ExplicitId Add(Vec3<Exact> vector);

  /// Removes all vectors and keeps the memory.
  void Clear();

  [[nodiscard]] Vec3<Exact>& operator[](ExplicitId id);
  [[nodiscard]] const Vec3<Exact>& operator[](ExplicitId id) const;

  /// All vectors; valid until the next Add, Clear or assignment.
  [[nodiscard]] IdSpan<ExplicitId, const Vec3<Exact>> All() const;
  [[nodiscard]] IdSpan<ExplicitId, Vec3<Exact>> All();

 private:
  struct Storage;

  [[nodiscard]] Storage& Stored();

  std::unique_ptr<Storage> storage_;  ///< made by the first Add
};

}  // namespace truelux

#endif  // TRUELUX_EXACT_EXPLICIT_VECTORS_H_
