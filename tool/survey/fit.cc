#include "tool/survey/fit.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <utility>

#include "core/coverage.h"
#include "core/error.h"
#include "exact/coverage.h"
#include "tool/survey/families.h"

namespace rasterproof::tool {
namespace {

constexpr std::size_t kKept = 6;

struct Drawn {
  Scene scene;
  CoverageCounts counts;
};

// Snaps and sample locations, all with the top-left rule.
std::vector<Profile> Geometries(const Profile& own) {
  std::vector<Snap> snaps{own.snap, {}};  // of equally good ones the declared one stays first
  for (const int bits : {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 16}) {
    for (const SnapRule rule : {SnapRule::kNearestEven, SnapRule::kNearestAway, SnapRule::kHalfUp,
                                SnapRule::kFloor, SnapRule::kTruncate}) {
      snaps.push_back({bits, rule});
    }
  }
  std::vector<Profile> models;
  // Centres, corners, and centres less what fixed-point code takes off to break ties.
  constexpr std::array<Point2, 7> kLocations{{{0.5, 0.5},
                                              {0, 0},
                                              {0.5, 0},
                                              {0, 0.5},
                                              {0.5, 127.0 / 256},
                                              {31.0 / 64, 31.0 / 64},
                                              {33.0 / 64, 33.0 / 64}}};
  for (const Point2& at : kLocations) {
    for (const Snap& snap : snaps) {
      Profile model = own;
      model.snap = snap;
      model.lattice.locations = {at};
      model.fill_rule = kTopLeft;
      models.push_back(model);
    }
  }
  return models;
}

std::vector<FillRule> FillRules() {
  std::vector<FillRule> rules{{+1, +1, false, true}};
  for (const int x : {+1, -1}) {
    for (const int y : {+1, -1}) {
      for (const bool y_first : {false, true}) {
        rules.push_back({static_cast<std::int8_t>(x), static_cast<std::int8_t>(y), y_first, false});
      }
    }
  }
  return rules;
}

std::uint64_t Wrong(const Drawn& drawn, const Profile& model) {
  const CoverageCounts expected = exact::Coverage(drawn.scene, model);
  std::uint64_t wrong = 0;
  for (std::size_t k = 0; k < expected.size(); ++k) {
    wrong += expected.Count(k) != drawn.counts.Count(k) ? 1U : 0U;
  }
  return wrong;
}

std::vector<Fit> Rank(const std::vector<Profile>& models, const std::vector<Drawn>& drawings) {
  std::vector<Fit> fits;
  for (const Profile& model : models) {
    Fit fit{model, 0, 0};
    for (const Drawn& drawn : drawings) {
      fit.wrong += Wrong(drawn, model);
      fit.samples += drawn.counts.size();
    }
    fits.push_back(fit);
  }
  // Of equally wrong models the first comes first. (clang calls what std::stable_sort uses
  // deprecated.)
  std::vector<std::size_t> order(fits.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t k) { return std::pair(fits[k].wrong, k); });
  std::vector<Fit> best;
  for (std::size_t k = 0; k < std::min(order.size(), kKept); ++k) best.push_back(fits[order[k]]);
  return best;
}

}  // namespace

std::vector<Fit> FitModels(Subject& subject, const Profile& declared, std::uint64_t triangles) {
  std::array<std::vector<Drawn>, 2> drawings;
  for (std::uint64_t k = 0; k < triangles; ++k) {
    Drawn drawn{FittingScene(k, subject.Info().input), CoverageCounts(16, 16)};
    try {
      subject.Draw(drawn.scene, {}, drawn.counts);
    } catch (const InputError&) {
      continue;
    }
    drawings[k % 2].push_back(std::move(drawn));
  }
  // Those of even index lie off every lattice: ties do not matter there.
  std::vector<Profile> models;
  for (const Fit& fit : Rank(Geometries(declared), drawings[0])) {
    for (const FillRule& rule : FillRules()) {
      models.push_back(fit.model);
      models.back().fill_rule = rule;
    }
  }
  std::ranges::move(drawings[1], std::back_inserter(drawings[0]));
  return Rank(models, drawings[0]);
}

}  // namespace rasterproof::tool
