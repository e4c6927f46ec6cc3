// Options of a campaign: number of cases, time, and callbacks.
#ifndef RASTERPROOF_PROPS_RUN_CAMPAIGN_OPTIONS_H_
#define RASTERPROOF_PROPS_RUN_CAMPAIGN_OPTIONS_H_

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"

namespace rasterproof::props {

struct Trial;  // props/run/trial.h
struct World;  // props/domains/worlds.h

inline constexpr std::uint64_t kDefaultSeed = 1;
inline constexpr std::uint64_t kDefaultCases = 1000;
inline constexpr std::size_t kDefaultBatch = 32;

/// What other runs saw of a subject's pace. Threads may share it.
struct Pace {
  std::atomic<bool> is_slow = false;  ///< small cases come first
  std::atomic<bool> hangs = false;    ///< no case gets more than LimitAfterAHang
  std::atomic<double> slowest = 0;    ///< seconds that the slowest call with an answer took
  std::atomic<int> silent = 0;        ///< properties in a row that ended without an answer

  void Answered(double seconds);
  /// What a case gets of a time limit once the subject was seen to hang: a tenth, or ten times what
  /// its slowest answer took. All of it while nothing was ever answered and few were asked.
  double LimitAfterAHang(double time_limit) const;
};

struct CampaignOptions {
  std::uint64_t seed = kDefaultSeed;
  /// Cases in all, chosen ones and one of each of the property's domains in turn: CaseOrder says
  /// which they are. A domain that the property lists twice has two turns.
  std::uint64_t cases = kDefaultCases;
  std::uint64_t first_case = 0;  ///< for shards and replays
  /// Takes the cases of this world, in their order, and not those of the property's domains:
  /// `cases` of them from `first_case` on, no more than there are. The seed plays no part.
  const World* world = nullptr;
  /// Cases whose draws share calls, where the subject takes that; at least 1. What is found of a
  /// subject whose draws depend on nothing but the scene is the same for every number.
  std::size_t batch = kDefaultBatch;
  /// Stop after this long, within a case or while shrinking as well if the subject can be stopped;
  /// 0: no limit.
  double seconds = 0;
  std::uint64_t shrink_budget = 2000;  ///< evaluations
  double shrink_seconds = 60;          ///< shrinking ends after this long at the latest
  /// What one draw of a subject that can be stopped may take, in seconds. 0: it can't be stopped.
  double time_limit = 0;
  /// Called now and then with the number of cases done. May be empty.
  std::function<void(std::uint64_t)> progress = {};
  /// Called with each case and its verdict, in the order in which they are judged. May be empty.
  std::function<void(const Case&, const Verdict&)> judged = {};
  /// Called now and then with the number of evaluations, 0 first, while a failing case is shrunk.
  /// May be empty.
  std::function<void(std::uint64_t)> shrinking = {};
  /// Asked between cases and between steps of shrinking: true ends the run. May be empty.
  std::function<bool()> stop = {};
  /// Read and kept up to date, if there is one: for runs of several properties on one subject.
  Pace* pace = nullptr;
  /// Makes a fresh subject in its own process. A failure is judged again by one that has drawn
  /// nothing else, as in a replay. Empty, or nullptr if none can be made or the run is stopped: the
  /// subject itself judges it again.
  std::function<std::unique_ptr<Subject>()> afresh = {};
  /// Gives the trials of the next cases where they are known already, as TryTogether() would, and
  /// credits the decisions that they took. Empty: the cases are put to the subject.
  std::function<std::vector<Trial>(std::span<const Case>)> tried = {};
  /// The clock, for tests. Empty: std::chrono::steady_clock.
  std::function<std::chrono::steady_clock::time_point()> now = {};
};

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_RUN_CAMPAIGN_OPTIONS_H_
