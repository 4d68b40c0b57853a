#include "exact/explicit_vectors.h"

#include <cstddef>
#include <utility>
#include <vector>

#include "exact/number.h"
#include "exact/vec3.h"

namespace truelux {

struct ExplicitVectors::Storage {
  std::vector<Vec3<Exact>> vectors;
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

int ExplicitVectors::Add(Vec3<Exact> vector) {
  std::vector<Vec3<Exact>>& vectors = Stored().vectors;
  vectors.push_back(std::move(vector));
  return static_cast<int>(vectors.size()) - 1;
}

void ExplicitVectors::Clear() {
  if (storage_) storage_->vectors.clear();
}

Vec3<Exact>& ExplicitVectors::operator[](int index) {
  return storage_->vectors[static_cast<std::size_t>(index)];
}

const Vec3<Exact>& ExplicitVectors::operator[](int index) const {
  return storage_->vectors[static_cast<std::size_t>(index)];
}

std::span<const Vec3<Exact>> ExplicitVectors::All() const {
  if (!storage_) return {};
  return storage_->vectors;
}

std::span<Vec3<Exact>> ExplicitVectors::All() {
  if (!storage_) return {};
  return storage_->vectors;
}

ExplicitVectors::Storage& ExplicitVectors::Stored() {
  if (!storage_) storage_ = std::make_unique<Storage>();
  return *storage_;
}

}  // namespace truelux
