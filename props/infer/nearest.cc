#include "props/infer/nearest.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "props/domains/bit_source.h"
#include "props/infer/directed.h"

namespace rasterproof::props {
namespace {

// How models are dropped in ranking them.
struct Thrift {
  std::size_t first_part;  // experiments after which half of the models are dropped
  std::size_t fewest;      // models that see all experiments
};
constexpr Thrift kToBeSure{64, 256};
constexpr Thrift kToGuess{16, 16};
constexpr std::size_t kInACall = 16;
// No case of the race, which counts its own from 0.
constexpr std::uint64_t kFirstCase = std::uint64_t{1} << 32;

struct Entry {
  Model model;
  std::uint64_t wrong = 0;  ///< samples
  std::uint64_t wrong_experiments = 0;
};

std::vector<Entry> EntriesOf(const ModelSpace& space) {
  std::vector<Entry> stated;
  std::vector<Entry> others;
  for (const Model& model : space.models()) {
    if (model.snap == space.stated().snap) {
      stated.push_back({model});
    } else if (model.snap.form == SnapForm::kCoordinate) {
      others.push_back({model});
    }
  }
  stated.insert(stated.end(), others.begin(), others.end());
  return stated;
}

// The best first; of equally good ones the order stays. (clang calls what std::stable_sort uses
// deprecated.)
void Rank(std::vector<Entry>& entries) {
  std::vector<std::pair<std::uint64_t, std::size_t>> order;
  for (std::size_t k = 0; k < entries.size(); ++k) order.emplace_back(entries[k].wrong, k);
  std::ranges::sort(order);
  std::vector<Entry> ranked;
  for (const auto& [wrong, k] : order) ranked.push_back(entries[k]);
  entries = std::move(ranked);
}

// The models that are wrong about the fewest samples, the best first. Half of them are dropped
// after each part of the experiments.
std::vector<Entry> Ranked(const Observer& observer, const ModelSpace& space,
                          std::vector<Entry> race, std::span<const Experiment> experiments,
                          const Thrift& thrift) {
  std::size_t next = 0;
  for (std::size_t part = thrift.first_part; next < experiments.size(); part *= 2) {
    for (; next < std::min(part, experiments.size()); ++next) {
      const Experiment& experiment = experiments[next];
      Prediction prediction(experiment.scene, space, observer.facing());
      for (Entry& entry : race) {
        const std::uint64_t wrong = Compare(experiment.seen, prediction.Of(entry.model)).wrong;
        entry.wrong += wrong;
        entry.wrong_experiments += wrong != 0 ? 1 : 0;
      }
    }
    Rank(race);
    race.resize(std::max(race.size() / 2, std::min(race.size(), thrift.fewest)));
  }
  return race;
}

}  // namespace

NearestModel Nearest(const Observer& observer, const ModelSpace& space,
                     std::span<const Experiment> experiments, Model* nearest) {
  NearestModel found;
  const std::vector<Entry> race = Ranked(observer, space, EntriesOf(space), experiments, kToBeSure);
  for (const Experiment& experiment : experiments) found.samples += experiment.seen.size();
  *nearest = race.front().model;
  found.profile = space.ProfileOf(*nearest);
  found.wrong_samples = race.front().wrong;
  found.wrong_experiments = race.front().wrong_experiments;
  found.experiments = experiments.size();
  return found;
}

std::vector<Model> NearestModels(const Observer& observer, const ModelSpace& space,
                                 std::span<const Experiment> experiments, std::size_t most) {
  std::vector<Entry> all;
  for (const Model& model : space.models()) all.push_back({model});
  std::vector<Model> nearest;
  for (const Entry& entry : Ranked(observer, space, std::move(all), experiments, kToGuess)) {
    if (nearest.size() < most) nearest.push_back(entry.model);
  }
  return nearest;
}

std::vector<Experiment> AimlessExperiments(Observer& observer, std::uint64_t seed, int count) {
  std::vector<Experiment> experiments;
  std::vector<Scene> scenes;
  for (int k = 0; k < count && !observer.HasBrokenOff(); ++k) {
    PhiloxSource bits(seed, kFirstCase + static_cast<std::uint64_t>(k));
    const std::optional<Scene> scene = observer.Given(AimlessTriangle(bits));
    if (scene) scenes.push_back(*scene);
    if (scenes.size() < kInACall && k + 1 < count) continue;
    std::vector<CoverageCounts> seen = observer.Draw(scenes);
    for (std::size_t s = 0; s < seen.size(); ++s) {
      const bool is_refused = seen[s].size() == 0;
      if (!is_refused) experiments.push_back({scenes[s], std::move(seen[s])});
    }
    scenes.clear();
  }
  return experiments;
}

const Experiment* FirstAgainst(const Model& model, const Observer& observer,
                               const ModelSpace& space, std::span<const Experiment> experiments) {
  for (const Experiment& experiment : experiments) {
    Prediction prediction(experiment.scene, space, observer.facing());
    if (!prediction.Explains(model, experiment.seen)) return &experiment;
  }
  return nullptr;
}

std::vector<PatternCandidate> WithUsualPatterns(std::vector<PatternCandidate> patterns,
                                                const SamplePattern& stated) {
  const auto add = [&](const SamplePattern& pattern) {
    const auto is_it = [&](const PatternCandidate& c) {
      return !c.half_off && c.pattern == pattern;
    };
    if (std::ranges::none_of(patterns, is_it)) patterns.push_back({pattern, false});
  };
  add(stated);
  if (stated.samples() != 1) return patterns;
  constexpr std::array<Point2, 7> kUsual{{{0.5, 0.5},
                                          {0, 0},
                                          {0.5, 0},
                                          {0, 0.5},
                                          {0.5, 127.0 / 256},
                                          {31.0 / 64, 31.0 / 64},
                                          {33.0 / 64, 33.0 / 64}}};
  for (const Point2& at : kUsual) {
    SamplePattern pattern;
    pattern.locations = {at};
    add(pattern);
  }
  return patterns;
}

}  // namespace rasterproof::props
