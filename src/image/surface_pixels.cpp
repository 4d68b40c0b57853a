// SPDX-License-Identifier: GPL-3.0-or-later
#include "image/surface_pixels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include <gmpxx.h>

#include "exact/rational.h"
#include "scene/facet_normal.h"

namespace truelux {
namespace {

/// The place of a point in a picture [px]: pixel (x, y) has its centre there.
struct PixelPlace {
  mpq_class x;
  mpq_class y;
};

mpz_class Floor(const mpq_class& q) {
  mpz_class result;
  mpz_fdiv_q(result.get_mpz_t(), q.get_num_mpz_t(), q.get_den_mpz_t());
  return result;
}

mpz_class Ceiling(const mpq_class& q) {
  mpz_class result;
  mpz_cdiv_q(result.get_mpz_t(), q.get_num_mpz_t(), q.get_den_mpz_t());
  return result;
}

/// Whole numbers from `first` to `last`.
struct PixelRange {
  int first;
  int last;
};

/// Those of 0 .. count - 1 within [least, most].
PixelRange PixelsWithin(const mpq_class& least, const mpq_class& most,
                        int count) {
  const mpz_class first = Ceiling(least);
  const mpz_class last = Floor(most);
  return {first <= 0      ? 0
          : first < count ? static_cast<int>(first.get_si())
                          : count,
          last < 0       ? -1
          : last < count ? static_cast<int>(last.get_si())
                         : count - 1};
}

/// Where a row crosses a closed triangle, from the left to the right.
struct Crossings {
  bool any = false;
  mpq_class least;
  mpq_class most;

  void Add(const mpq_class& x) {
    if (!any || x < least) least = x;
    if (!any || x > most) most = x;
    any = true;
  }
};

Crossings CrossingsOf(const std::array<PixelPlace, 3>& corners, int row) {
  Crossings crossings;
  for (std::size_t k = 0; k < 3; ++k) {
    const PixelPlace& p = corners[k];
    const PixelPlace& q = corners[(k + 1) % 3];
    if (p.y == row) crossings.Add(p.x);
    if ((p.y < row && q.y > row) || (p.y > row && q.y < row)) {
      crossings.Add(p.x + (row - p.y) / (q.y - p.y) * (q.x - p.x));
    }
  }
  return crossings;
}

std::array<DoubleDouble, 3> PlaceOf(const RationalVector& v) {
  return {DoubleDoubleOf(v.x), DoubleDoubleOf(v.y), DoubleDoubleOf(v.z)};
}

}  // namespace

SurfacePixels::SurfacePixels(const Scene& scene, const SurfaceFrame& frame,
                             int width, int height)
    : PixelReceivers(width, height),
      faces_(width, height, 0),
      reversed_(frame.reversed) {
  const auto front = static_cast<std::size_t>(frame.faces.front());
  normal_ = FacetNormal(scene, scene.faces()[front].first_facet);
  const mpq_class a_range = frame.a_most - frame.a_least;
  const mpq_class b_range = frame.b_most - frame.b_least;
  for (int x = 0; x < width; ++x) {
    mpq_class share(2 * x + 1, 2 * width);
    share.canonicalize();
    const mpq_class a = frame.a_least + share * a_range;
    const RationalVector along = a * frame.u;
    columns_.push_back(
        PlaceOf({frame.origin.x + along.x, frame.origin.y + along.y,
                 frame.origin.z + along.z}));
  }
  for (int y = 0; y < height; ++y) {
    mpq_class share(2 * y + 1, 2 * height);
    share.canonicalize();
    const mpq_class b = frame.b_most - share * b_range;
    rows_.push_back(PlaceOf(b * frame.v));
  }
  for (const int face : frame.faces)
    Fill(scene, frame, face);
}

/// Gives the pixels on a face that have none yet its number.
void SurfacePixels::Fill(const Scene& scene, const SurfaceFrame& frame,
                         int face) {
  const Face& f = scene.faces()[static_cast<std::size_t>(face)];
  const Facet& facet = scene.facets()[static_cast<std::size_t>(f.first_facet)];
  const mpq_class half(1, 2);
  for (const Triangle& triangle : scene.triangles().subspan(
           static_cast<std::size_t>(facet.first_triangle),
           static_cast<std::size_t>(facet.triangle_count))) {
    std::array<PixelPlace, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = frame.Of(
          scene.vertices()[static_cast<std::size_t>(triangle.vertices[k])]);
      corners[k].x =
          (a - frame.a_least) / (frame.a_most - frame.a_least) * width() - half;
      corners[k].y =
          (frame.b_most - b) / (frame.b_most - frame.b_least) * height() - half;
    }
    const auto [top, bottom] =
        std::minmax({corners[0].y, corners[1].y, corners[2].y});
    const PixelRange rows = PixelsWithin(top, bottom, height());
    for (int y = rows.first; y <= rows.last; ++y) {
      const Crossings crossings = CrossingsOf(corners, y);
      const PixelRange columns =
          PixelsWithin(crossings.least, crossings.most, width());
      for (int x = columns.first; x <= columns.last; ++x) {
        int& entry = faces_.At(x, y);
        if (entry == 0) entry = face + 1;
      }
    }
  }
}

std::optional<Receiver> SurfacePixels::At(int x, int y) const {
  const int face = faces_.At(x, y);
  if (face == 0) return std::nullopt;
  const Place& column = columns_[static_cast<std::size_t>(x)];
  const Place& row = rows_[static_cast<std::size_t>(y)];
  const auto sum = [&](std::size_t k) { return (column[k] + row[k]).high; };
  Receiver receiver{{sum(0), sum(1), sum(2)}, normal_, face};
  if (std::ranges::binary_search(reversed_, face - 1)) {
    // Not a bare minus: zeros stay without a sign.
    receiver.normal = {0 - normal_.x, 0 - normal_.y, 0 - normal_.z};
  }
  return receiver;
}

bool SurfacePixels::IsFinite() const {
  const auto is_finite = [](const Place& place) {
    return std::ranges::all_of(place, [](const DoubleDouble& c) {
      // With room for the sum.
      return std::fabs(c.high) < 0x1p1022;
    });
  };
  return std::ranges::all_of(columns_, is_finite) &&
         std::ranges::all_of(rows_, is_finite);
}

}  // namespace truelux
