// SPDX-License-Identifier: GPL-3.0-or-later
// Spikes of a ring: paths that go out and come back the same way.

#ifndef TRUELUX_SCENE_RING_SPIKES_H_
#define TRUELUX_SCENE_RING_SPIKES_H_

#include <cstddef>
#include <utility>
#include <vector>

namespace truelux {

/// Takes every vertex whose two neighbours coincide out of a closed ring,
/// together with the later of them, until there is none. same(a, b): whether
/// two entries stand for one point; no two consecutive ones do, cyclically.
/// What is left does not depend on the order of removals, up to which of two
/// coinciding entries stays. Fewer than three entries: nothing has an inside.
template <class T, class Same>
void RemoveSpikes(std::vector<T>& ring, const Same& same) {
  const std::size_t size = ring.size();
  bool any = false;
  for (std::size_t i = 0; i < size && size > 3; ++i) {
    any = any || same(ring[i], ring[i + 2 < size ? i + 2 : i + 2 - size]);
  }
  // Few rings have one, and most are triangles, which cannot.
  if (!any) return;
  std::vector<T> kept;
  for (T& entry : ring) {
    const std::size_t n = kept.size();
    if (n >= 2 && same(kept[n - 2], entry)) {
      kept.pop_back();
    } else {
      kept.push_back(std::move(entry));
    }
  }
  // The ends of the ring are neighbours, too.
  std::size_t begin = 0;
  std::size_t end = kept.size();
  while (end - begin >= 3) {
    if (same(kept[begin], kept[end - 2])) {
      end -= 2;
    } else if (same(kept[begin + 1], kept[end - 1])) {
      ++begin;
      --end;
    } else {
      break;
    }
  }
  ring.assign(
      std::make_move_iterator(kept.begin() +
                              static_cast<std::ptrdiff_t>(begin)),
      std::make_move_iterator(kept.begin() + static_cast<std::ptrdiff_t>(end)));
}

}  // namespace truelux

#endif  // TRUELUX_SCENE_RING_SPIKES_H_
