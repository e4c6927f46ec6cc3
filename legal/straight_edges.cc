#include "legal/straight_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/vertex.h"
#include "exact/edge.h"

namespace rasterproof::legal {
namespace {

// C(28, 3) triples of an edge at most, its four bounds at the ends counted.
constexpr std::size_t kMostBeside = 24;

// A sample next to the edge, or an end of the stretch that the moved edge passes within the reach.
struct Mark {
  Point2 at;
  std::optional<std::size_t> open;  ///< a sample's
  bool may_be_in = true;
  bool may_be_out = true;
};

class Marks {
 public:
  Marks(const ClippedTriangle& clipped, std::size_t edge, int facing)
      : stretch_(*clipped.StraightStretchOf(edge)), inside_(facing * (stretch_.rises ? 1 : -1)) {}

  double Along(Point2 p) const { return stretch_.along_y ? p.y : p.x; }

  void AddEnds() {
    for (const auto& [low, high] : {stretch_.first, stretch_.last}) {
      // The side of the first of them, as seen from the other.
      const bool low_is_in = exact::EdgeSign(stretch_.first[1], stretch_.last[1], low) == inside_;
      marks_.push_back({low, std::nullopt, low_is_in, !low_is_in});
      marks_.push_back({high, std::nullopt, !low_is_in, low_is_in});
    }
  }
  void Add(const OpenSample& sample, std::size_t index) { marks_.push_back({sample.at, index}); }

  // Every third sample between two others whose sides no straight line allows.
  void AddExclusionsTo(std::vector<Exclusion>& exclusions) {
    std::ranges::sort(marks_, {}, [&](const Mark& m) {
      return stretch_.along_y ? std::pair(m.at.y, m.at.x) : std::pair(m.at.x, m.at.y);
    });
    for (std::size_t i = 0; i < marks_.size(); ++i) {
      for (std::size_t k = i + 2; k < marks_.size(); ++k) {
        for (std::size_t j = i + 1; j < k; ++j)
          Exclude({&marks_[i], &marks_[j], &marks_[k]}, exclusions);
      }
    }
  }

 private:
  void Exclude(const std::array<const Mark*, 3>& m, std::vector<Exclusion>& exclusions) const {
    if (!(Along(m[0]->at) < Along(m[1]->at) && Along(m[1]->at) < Along(m[2]->at))) return;
    const int side = exact::EdgeSign(m[0]->at, m[2]->at, m[1]->at);
    if (side == 0) return;
    // A middle sample inside the line through two covered ones is covered too; and the reverse.
    const bool covered = side == inside_;
    const auto may_be = [](const Mark& mark, bool in) {
      return in ? mark.may_be_in : mark.may_be_out;
    };
    if (!may_be(*m[0], covered) || !may_be(*m[2], covered) || !may_be(*m[1], !covered)) return;
    Exclusion exclusion;
    for (std::size_t k = 0; k < 3; ++k) {
      if (m[k]->open) exclusion.push_back({*m[k]->open, (k == 1) != covered});
    }
    exclusions.push_back(std::move(exclusion));
  }

  StraightStretch stretch_;
  int inside_;  ///< the sign of E on the inner side of a line that rises along the axis
  std::vector<Mark> marks_;
};

}  // namespace

std::vector<Exclusion> ExclusionsOf(const ClippedTriangle& clipped, int facing,
                                    std::span<const OpenSample> open) {
  std::vector<Exclusion> exclusions;
  for (std::size_t edge = 0; edge < 3; ++edge) {
    std::vector<std::size_t> beside;
    for (std::size_t k = 0; k < open.size(); ++k) {
      if (open[k].moved_edge == edge) beside.push_back(k);
    }
    if (beside.empty()) continue;
    Marks marks(clipped, edge, facing);
    marks.AddEnds();
    const std::size_t every = (beside.size() + kMostBeside - 1) / kMostBeside;
    for (std::size_t k = 0; k < beside.size(); k += every) marks.Add(open[beside[k]], beside[k]);
    marks.AddExclusionsTo(exclusions);
  }
  return exclusions;
}

}  // namespace rasterproof::legal
