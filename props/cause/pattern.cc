// Where all wrong samples lie.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "props/cause/cause.h"
#include "props/cause/evidence.h"

namespace rasterproof::props {
namespace {

// One wrong drawing, and as it should be.
struct DrawnWrong {
  std::shared_ptr<const Drawing> seen;
  std::shared_ptr<const Drawing> stated;

  const CoverageCounts& Seen() const { return seen->counts; }
  bool IsWrong(std::size_t k) const {
    return Seen().front[k] != stated->counts.front[k] || Seen().back[k] != stated->counts.back[k];
  }
  bool IsTooMany(std::size_t k) const { return Seen().Count(k) > stated->counts.Count(k); }
};

std::vector<DrawnWrong> DrawnWrongly(std::span<const Observation* const> wrong, Subject& stated) {
  std::vector<DrawnWrong> all;
  for (const Observation* o : wrong) {
    const Seen expected = DrawnBy(stated, *o);
    if (expected.size() != o->seen.size()) continue;
    for (std::size_t d = 0; d < o->seen.size(); ++d) {
      if (!(o->seen[d]->counts == expected[d]->counts)) all.push_back({o->seen[d], expected[d]});
    }
  }
  return all;
}

// Calls `visit(x, row, k)` for each sample, and returns whether it was true of all.
template <class Visit>
bool AllSamples(const CoverageCounts& shape, const Visit& visit) {
  for (int row = 0; row < shape.height; ++row) {
    for (int x = 0; x < shape.width; ++x) {
      for (int s = 0; s < shape.samples; ++s) {
        if (!visit(x, row, shape.Index(x, row, s))) return false;
      }
    }
  }
  return true;
}

// Whether each wrong sample lies in a block of `side` pixels that is covered whole, or left out
// whole.
bool LieInBlocks(const std::vector<DrawnWrong>& all, int side, bool covered) {
  return std::ranges::all_of(all, [&](const DrawnWrong& drawn) {
    const CoverageCounts& seen = drawn.Seen();
    // Of a drawing that covers nothing it says nothing.
    if (AllSamples(seen, [&](int, int, std::size_t k) { return seen.Count(k) == 0; })) return false;
    return AllSamples(seen, [&](int x, int row, std::size_t k) {
      if (!drawn.IsWrong(k)) return true;
      if (drawn.IsTooMany(k) != covered) return false;
      for (int y = row / side * side; y < std::min(seen.height, row / side * side + side); ++y) {
        for (int i = x / side * side; i < std::min(seen.width, x / side * side + side); ++i) {
          for (int s = 0; s < seen.samples; ++s) {
            if ((seen.Count(seen.Index(i, y, s)) != 0) != covered) return false;
          }
        }
      }
      return true;
    });
  });
}

// The column, or row, in which all wrong samples lie.
std::optional<int> OneLine(const std::vector<DrawnWrong>& all, bool of_rows) {
  std::optional<int> line;
  const bool is_one = std::ranges::all_of(all, [&](const DrawnWrong& drawn) {
    return AllSamples(drawn.Seen(), [&](int x, int row, std::size_t k) {
      if (!drawn.IsWrong(k)) return true;
      const int at = of_rows ? row : x;
      if (!line) line = at;
      return *line == at;
    });
  });
  return is_one ? line : std::nullopt;
}

// The column, or row, from which on, or up to which, all that should be covered is wrong, and
// nothing else is.
std::optional<int> OneSide(const std::vector<DrawnWrong>& all, bool of_rows, bool beyond) {
  std::optional<int> nearest_wrong, farthest_right;
  for (const DrawnWrong& drawn : all) {
    AllSamples(drawn.Seen(), [&](int x, int row, std::size_t k) {
      const int at = beyond ? (of_rows ? row : x) : -(of_rows ? row : x);
      if (drawn.IsWrong(k)) {
        nearest_wrong = std::min(nearest_wrong.value_or(at), at);
      } else if (drawn.stated->counts.Count(k) != 0) {
        farthest_right = std::max(farthest_right.value_or(at), at);
      }
      return true;
    });
  }
  if (!nearest_wrong || !farthest_right || *farthest_right >= *nearest_wrong) return std::nullopt;
  return beyond ? *nearest_wrong : -*nearest_wrong;
}

}  // namespace

std::string PatternOf(std::span<const Observation* const> wrong, Subject& stated) {
  constexpr std::size_t kMostLookedAt = 64;
  constexpr std::size_t kFewest = 8;  // scenes
  if (ScenesOf(wrong, kFewest) < kFewest) return "";
  const std::vector<DrawnWrong> all =
      DrawnWrongly(wrong.first(std::min(kMostLookedAt, wrong.size())), stated);
  if (all.empty()) return "";
  for (const bool of_rows : {false, true}) {
    const std::string word = of_rows ? "row " : "column ";
    if (const auto line = OneLine(all, of_rows); line)
      return "lies in " + word + std::to_string(*line);
    for (const bool beyond : {true, false}) {
      if (const auto side = OneSide(all, of_rows, beyond); side) {
        return "lies " + std::string(beyond ? "from " : "up to ") + word + std::to_string(*side) +
               (beyond ? " on" : "") + ", where nothing is right that should be covered";
      }
    }
  }
  for (const int side : {32, 16, 8, 4}) {
    const std::string of = std::to_string(side) + " x " + std::to_string(side) + " pixels";
    for (const bool covered : {true, false}) {
      if (LieInBlocks(all, side, covered))
        return "lies in a block of " + of + " that is " + (covered ? "drawn" : "left out") +
               " whole";
    }
  }
  return "";
}

}  // namespace rasterproof::props
