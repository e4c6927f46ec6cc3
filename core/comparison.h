// What a comparison counts: how a subject fares on some cases by one yardstick.
#ifndef RASTERPROOF_CORE_COMPARISON_H_
#define RASTERPROOF_CORE_COMPARISON_H_

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/case.h"

namespace rasterproof {

/// The cases of one row by one yardstick.
struct Cell {
  std::uint64_t cases = 0;      ///< compared, or that broke the subject down
  std::uint64_t wrong = 0;      ///< of these, cases with a wrong sample or a breakdown
  std::uint64_t ended = 0;      ///< of the wrong cases, those that broke the subject down
  std::uint64_t by_snap = 0;    ///< of the wrong cases, those that the snap alone explains
  std::uint64_t triangles = 0;  ///< of the compared cases that have a drawing
  std::uint64_t samples = 0;
  std::uint64_t wrong_samples = 0;
  /// How far the wrong sample furthest off lies from the nearest edge of its scene, in pixels: what
  /// some edge was at least displaced by. Of a case the first 64 wrong samples are measured.
  double furthest = 0;
  std::optional<Case> worst = {};     ///< the case of that sample; the first one of equals
  std::optional<Case> ended_on = {};  ///< the first case that broke the subject down
  std::uint64_t excused = 0;          ///< cases outside what the yardstick or the subject covers
  std::uint64_t refused = 0;          ///< of these, by the subject
  std::string why = {};               ///< of the first breakdown, else of the first excused case
  bool has_hung = false;              ///< it broke down by giving no answer
  bool is_exhausted = false;          ///< every case of a world was compared
  bool is_proved = false;             ///< the subject has proofs that none is wrong

  bool Fails() const { return wrong != 0; }
  /// As `furthest`; infinite where the subject broke down.
  double WorstPixels() const {
    return ended != 0 ? std::numeric_limits<double>::infinity() : furthest;
  }
  /// A breakdown is worse than a wrong sample. Null: no case fails.
  const Case* Worst() const { return ended_on ? &*ended_on : worst ? &*worst : nullptr; }
};

/// What else is known of a row or a subject, by name: {"file", "edge.c"}.
using Facts = std::vector<std::pair<std::string, std::string>>;

/// What the cases of a row have in common.
struct ComparedRow {
  std::string name;
  std::string summary;
  std::string theme;  ///< what they are hard for
  std::string right;  ///< what a right rasterizer does
  Facts facts = {};
};

struct ComparedSubject {
  std::string name;
  std::vector<std::vector<Cell>> cells;  ///< by row, then by yardstick
  Facts facts = {};
};

/// Cases by yardsticks, of some subjects.
struct ComparisonTable {
  std::string what = "families";  ///< its rows
  std::string one = "family";     ///< one of them
  std::uint64_t seed = 0;
  std::uint64_t cases = 0;              ///< of each row that is no world and no scene
  std::vector<std::string> yardsticks;  ///< names; the first one's verdict counts
  std::vector<ComparedRow> rows;
  std::vector<ComparedSubject> subjects;
};

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_COMPARISON_H_
