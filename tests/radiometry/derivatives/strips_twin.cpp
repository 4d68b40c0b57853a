// SPDX-License-Identifier: GPL-3.0-or-later
#include "radiometry/derivatives/strips_twin.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "radiometry/derivatives/strips_in_plane.h"
#include "support/real.h"

namespace truelux::testing {
namespace {

bool IsNothing(const RationalVector& v) {
  return v.x == 0 && v.y == 0 && v.z == 0;
}

struct IsLess {
  bool operator()(const RationalVector& a, const RationalVector& b) const {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  }
};

/// v times a number: its first component that is not 0 is 1.
RationalVector Canonical(const RationalVector& v) {
  const mpq_class& first = v.x != 0 ? v.x : v.y != 0 ? v.y : v.z;
  const mpq_class scale = 1 / first;
  return scale * v;
}

RationalVector NormalOf(const std::vector<RationalVector>& corners) {
  RationalVector twice_area;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    twice_area = twice_area +
                 Cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
  }
  return twice_area;
}

/// Throws unless a sheet is planar and turns to one side only, once.
void Check(const Sheet& sheet) {
  const std::size_t count = sheet.corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    const RationalVector& a = sheet.corners[i];
    const RationalVector side = sheet.corners[(i + 1) % count] - a;
    for (const RationalVector& corner : sheet.corners) {
      const RationalVector to_corner = corner - a;
      if (Dot(sheet.normal, corner) != sheet.height ||
          Dot(sheet.normal, Cross(side, to_corner)) < 0) {
        throw std::invalid_argument("a face is not planar and convex");
      }
    }
  }
}

/// Whether a sheet has corners on both sides of another's plane, or in it.
bool Reaches(const Sheet& sheet, const Sheet& other) {
  bool is_above = false;
  bool is_below = false;
  for (const RationalVector& corner : sheet.corners) {
    const int side = sgn(Dot(other.normal, corner) - other.height);
    is_above = is_above || side >= 0;
    is_below = is_below || side <= 0;
  }
  return is_above && is_below;
}

/// What lies in one plane.
struct Content {
  bool has_face = false;
  std::set<RationalVector, IsLess> lines;  ///< by their 1/rho in the plane
};

using Contents = std::map<RationalVector, Content, IsLess>;

/// Adds the line with a moment (of two of its points) and a direction.
void AddLine(const RationalVector& moment, const RationalVector& direction,
             Contents& contents) {
  if (IsNothing(moment)) return;  // it goes through r
  const mpq_class scale = 1 / Dot(moment, moment);
  contents[Canonical(moment)].lines.insert(scale * Cross(direction, moment));
}

Contents ContentsOf(const std::vector<Sheet>& sheets) {
  Contents contents;
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    const Sheet& sheet = sheets[i];
    if (sheet.height == 0) contents[Canonical(sheet.normal)].has_face = true;
    const std::size_t count = sheet.corners.size();
    for (std::size_t k = 0; k < count; ++k) {
      const RationalVector& a = sheet.corners[k];
      const RationalVector& b = sheet.corners[(k + 1) % count];
      AddLine(Cross(a, b), b - a, contents);
    }
    for (std::size_t k = 0; k < i; ++k) {
      const Sheet& other = sheets[k];
      const RationalVector along = Cross(sheet.normal, other.normal);
      if (IsNothing(along) || !Reaches(sheet, other) || !Reaches(other, sheet))
        continue;
      AddLine(other.height * sheet.normal - sheet.height * other.normal, along,
              contents);
    }
  }
  return contents;
}

Vector3 UnitOf(const RationalVector& v) {
  const auto real = [](const mpq_class& q) {
    ShortReal x;
    mpfr_set_q(x.get(), q.get_mpq_t(), MPFR_RNDN);
    return x;
  };
  const ShortReal length = Sqrt(real(Dot(v, v)));
  return {(real(v.x) / length).ToDouble(), (real(v.y) / length).ToDouble(),
          (real(v.z) / length).ToDouble()};
}

}  // namespace

bool Sheet::Emits() const {
  return std::ranges::any_of(emission,
                             [](const mpq_class& x) { return x != 0; });
}

RationalVector Sheet::InverseDistance() const {
  const mpq_class scale = 1 / height;
  return scale * normal;
}

StripsTwin::StripsTwin(std::span<const TestFace> faces,
                       const Receiver& receiver) {
  const RationalVector r = RationalOf(receiver.position);
  const Vector3& n = receiver.normal;
  receiver_normal_ = RationalOf(Point3{n.x, n.y, n.z});
  int number = 0;
  for (const TestFace& face : faces) {
    Sheet sheet;
    sheet.number = ++number;
    for (const Point3& p : face.ring)
      sheet.corners.push_back(RationalOf(p) - r);
    sheet.normal = NormalOf(sheet.corners);
    sheet.height = Dot(sheet.normal, sheet.corners.front());
    for (std::size_t channel = 0; channel < 3; ++channel)
      sheet.emission[channel] = face.emission[channel];
    Check(sheet);
    sheets_.push_back(std::move(sheet));
  }
  if (receiver.on_face == 0) return;
  // All faces in the plane of that face are left out.
  const Sheet own = sheets_.at(static_cast<std::size_t>(receiver.on_face) - 1);
  std::erase_if(sheets_, [&own](const Sheet& sheet) {
    return std::ranges::all_of(sheet.corners,
                               [&own](const RationalVector& corner) {
                                 return Dot(own.normal, corner) == own.height;
                               });
  });
}

std::vector<int> StripsTwin::Touched() const {
  std::vector<int> numbers;
  for (const Sheet& sheet : sheets_) {
    if (sheet.height != 0) continue;
    bool is_inside = true;
    const std::size_t count = sheet.corners.size();
    for (std::size_t i = 0; i < count; ++i) {
      const RationalVector moment =
          Cross(sheet.corners[i], sheet.corners[(i + 1) % count]);
      is_inside = is_inside && Dot(sheet.normal, moment) >= 0;
    }
    if (is_inside) numbers.push_back(sheet.number);
  }
  return numbers;
}

bool StripsTwin::IsLevel(int number) const {
  const auto sheet = std::ranges::find(sheets_, number, &Sheet::number);
  return IsNothing(Cross(sheet->normal, receiver_normal_));
}

bool StripsTwin::MayBeLit() const {
  return std::ranges::any_of(sheets_, [](const Sheet& sheet) {
    return sheet.Emits() && sheet.height <= 0;
  });
}

std::vector<TwinPlane> StripsTwin::Planes() const {
  std::vector<TwinPlane> planes;
  for (const auto& [normal, content] : ContentsOf(sheets_)) {
    if (!content.has_face && content.lines.size() < 2) continue;
    planes.push_back(
        {UnitOf(normal), KinkSize(sheets_, normal, receiver_normal_)});
  }
  return planes;
}

}  // namespace truelux::testing
