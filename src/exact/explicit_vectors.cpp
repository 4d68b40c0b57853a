// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/explicit_vectors.h"

#include <utility>

#include "exact/number.h"
#include "exact/vec3.h"

namespace truelux {

struct ExplicitVectors::Storage {
  IdVector<ExplicitId, Vec3<Exact>> vectors;
};

ExplicitVectors::ExplicitVectors() = default;
ExplicitVectors::~ExplicitVectors() = default;
ExplicitVectors::ExplicitVectors(ExplicitVectors&& other) noexcept = default;
ExplicitVectors& ExplicitVectors::operator=(ExplicitVectors&& other) noexcept =
    default;

ExplicitVectors::ExplicitVectors(std::initializer_list<Vec3<Exact>> vectors)
    : storage_(std::make_unique<Storage>(Storage{vectors})) {}

ExplicitVectors::ExplicitVectors(const ExplicitVectors& other)
    : storage_(other.storage_ ? std::make_unique<Storage>(*other.storage_)
                              : nullptr) {}

ExplicitVectors& ExplicitVectors::operator=(const ExplicitVectors& other) {
  if (this != &other) *this = ExplicitVectors(other);
  return *this;
}

ExplicitId ExplicitVectors::Add(Vec3<Exact> vector) {
  return Stored().vectors.push_back(std::move(vector));
}

void ExplicitVectors::Clear() {
  if (storage_) storage_->vectors.clear();
}

Vec3<Exact>& ExplicitVectors::operator[](ExplicitId id) {
  return storage_->vectors[id];
}

const Vec3<Exact>& ExplicitVectors::operator[](ExplicitId id) const {
  return storage_->vectors[id];
}

IdSpan<ExplicitId, const Vec3<Exact>> ExplicitVectors::All() const {
  if (!storage_) return {};
  return storage_->vectors;
}

IdSpan<ExplicitId, Vec3<Exact>> ExplicitVectors::All() {
  if (!storage_) return {};
  return storage_->vectors;
}

ExplicitVectors::Storage& ExplicitVectors::Stored() {
  if (!storage_) storage_ = std::make_unique<Storage>();
  return *storage_;
}

}  // namespace truelux
