// The one comparison: the cases of a row by yardsticks, counted in cells.
//
// A row says which cases there are and how the subject draws them; a yardstick says what a drawing
// is compared with. The loop draws a case once for all yardsticks, counts refusals and breakdowns,
// and keeps the worst case of each. Other builds, and a host in another floating-point mode, come
// from the caller as functions.
#ifndef RASTERPROOF_PROPS_COMPARE_COMPARE_H_
#define RASTERPROOF_PROPS_COMPARE_COMPARE_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/call_end.h"
#include "core/case.h"
#include "core/comparison.h"
#include "core/coverage.h"
#include "core/drawing.h"
#include "props/placed_case.h"

namespace rasterproof::props {

/// A case of a row.
class CaseAtHand {
 public:
  CaseAtHand(std::uint64_t number, const Case& c) : index(number), given(c) {}

  std::uint64_t index;  ///< in its row
  const Case& given;
  /// Without triangles of zero area where the profile leaves open what they cover.
  const PlacedCase& placed() const {
    if (!placed_) placed_.emplace(Place(given, /*judges_degenerates=*/false));
    return *placed_;
  }

 private:
  mutable std::optional<PlacedCase> placed_;  // some yardsticks need none
};

/// What the subject drew of a case.
struct Drawn {
  CallEnd end;
  std::shared_ptr<const Drawing> drawing;  ///< null: there is none
  /// What its triangles add up to, each in a call of its own. Null: they were not drawn so.
  std::shared_ptr<const CoverageCounts> alone = nullptr;
};

/// What a yardstick says of a drawing.
struct Reading {
  std::vector<std::size_t> wrong = {};  ///< samples
  double furthest = 0;                  ///< as Cell::furthest, of this case
  bool is_by_snap = false;              ///< the snap alone explains all of them
  CallEnd end = {};                     ///< of what the yardstick drew itself
};

/// A yardstick's preparation of a case, before it is drawn.
struct Judging {
  std::string why_not;  ///< why it can't judge the case; empty: it reads the drawing
  std::function<Reading(const Drawn&)> read = {};
};
/// The case at hand outlives the judging.
using Yardstick = std::function<Judging(const CaseAtHand&)>;

struct Row {
  std::uint64_t cases = 0;
  std::function<Case(std::uint64_t index)> at;
  /// Called for the cases of which some yardstick says something.
  std::function<Drawn(const CaseAtHand&)> draw;
};

struct Limits {
  double seconds = 0;  ///< at most, for a row; 0: no limit
  /// Asked between cases: true ends the row. May be empty.
  std::function<bool()> stop = {};
  /// Called with the number of cases done. May be empty.
  std::function<void(std::uint64_t)> progress = {};
};

/// A cell for each yardstick. The row is given up after four cases that end the subject or take it
/// too long, in its own draw or in a yardstick's: each costs a process or a time limit.
std::vector<Cell> CompareRow(const Row& row, std::span<const Yardstick> yardsticks,
                             const Limits& limits = {});

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_COMPARE_COMPARE_H_
