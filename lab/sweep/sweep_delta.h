// Delta debugging of a list, as in Zeller and Hildebrandt, "Simplifying and Isolating
// Failure-Inducing Input" (2002).
#ifndef RASTERPROOF_LAB_SWEEP_SWEEP_DELTA_H_
#define RASTERPROOF_LAB_SWEEP_SWEEP_DELTA_H_

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace rasterproof::lab {

/// A part of the items, in their order, that still passes the test and from which no single item
/// can be left out.
///
/// Domain:     a test that the whole list passes; pure, or what is returned is only as minimal as
///             its answers say.
/// Cost:       at most about n^2 tests of n items.
template <class T>
std::vector<T> MinimalPart(std::vector<T> items,
                           const std::function<bool(const std::vector<T>&)>& passes) {
  std::size_t parts = 2;
  while (items.size() >= 2) {
    parts = std::min(parts, items.size());
    bool is_smaller = false;
    // The chunks by themselves first, then all but one of them.
    for (std::size_t turn = 0; turn < 2 * parts && !is_smaller; ++turn) {
      const std::size_t chunk = turn % parts;
      const std::size_t first = items.size() * chunk / parts;
      const std::size_t last = items.size() * (chunk + 1) / parts;
      const bool is_alone = turn < parts;
      std::vector<T> kept;
      for (std::size_t k = 0; k < items.size(); ++k) {
        if ((k >= first && k < last) == is_alone) kept.push_back(items[k]);
      }
      if (kept.size() == items.size() || !passes(kept)) continue;
      items = std::move(kept);
      parts = is_alone ? 2 : std::max<std::size_t>(parts - 1, 2);
      is_smaller = true;
    }
    if (is_smaller) continue;
    if (parts == items.size()) break;
    parts *= 2;
  }
  return items;
}

}  // namespace rasterproof::lab

#endif  // RASTERPROOF_LAB_SWEEP_SWEEP_DELTA_H_
