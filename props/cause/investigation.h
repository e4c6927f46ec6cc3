// The search for causes: what was drawn, and the suspects that are left.
#ifndef RASTERPROOF_PROPS_CAUSE_INVESTIGATION_H_
#define RASTERPROOF_PROPS_CAUSE_INVESTIGATION_H_

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "core/case.h"
#include "core/clock.h"
#include "core/subject.h"
#include "props/cause/cause.h"
#include "props/cause/evidence.h"
#include "props/cause/suspect.h"

namespace rasterproof::props {

/// A quarter of the time is for draws of the subject.
inline constexpr double kGatheringShare = 0.25;
/// Draws that are wrong in fewer scenes may be alike by chance.
inline constexpr std::size_t kFewestScenes = 4;

/// A suspect that is still in the race.
struct Fitting {
  std::string name;
  std::string what;
  SuspectStages stages;
  std::unique_ptr<Subject> draws;
  std::size_t reproduced = 0;  // wrong observations
};

/// One search. Run() alone is for others.
class Investigation {
 public:
  Investigation(const MakesSubject& make, std::span<const FailedProperty> failures, double seconds)
      : make_(make), failures_(failures), seconds_(seconds) {}

  Causes Run();

 private:
  void Sort();
  void Race();
  std::optional<Suspect> WithBudget(Suspect suspect) const;
  bool IsSound(Fitting& fitting) const;
  void TellApart(std::vector<Fitting>& left);
  bool Split(std::vector<Fitting>& left, const Case& c, bool also_alike);
  std::optional<Case> NextSplit(std::uint64_t number) const;
  void Observe(Observation observation);
  bool HasWrongDraws(std::size_t failure) const;
  bool FindWhole();
  bool FindWholeByRaces();
  bool FindNothingDrawn();
  bool FindCombination();
  std::vector<std::vector<Fitting>> PartsOfAll();
  bool FindParts();
  void FindMistakes();
  void FindRest();
  std::vector<bool> ReproducedBy(const SuspectStages& stages) const;
  std::vector<const Observation*> AllWrong() const;
  std::size_t WrongScenes(const std::vector<bool>& counts) const;
  std::size_t AllWrongScenes() const { return WrongScenes(std::vector<bool>(wrong_, true)); }
  // Whether the wrong draws are too few to name a cause by them for sure.
  bool AreFew() const;
  std::optional<std::size_t> BestWith(const SuspectStages& stages,
                                      const std::vector<bool>& reproduced);
  void Share(const std::vector<std::size_t>& combined);
  void Take(Cause cause);
  Cause Of(CauseKind kind, const std::vector<Fitting>& left) const;
  // Both to be asked only where something is left to be done. Suspects draw in this thread.
  bool IsLate() { return CutsShort(ThreadSeconds() > end_); }
  bool IsSlow() { return CutsShort(asked_ > kGatheringShare * seconds_); }
  bool CutsShort(bool is_over) {
    if (is_over) found_.is_cut_short = true;
    return is_over;
  }

  const MakesSubject& make_;
  std::span<const FailedProperty> failures_;
  double seconds_;
  double end_ = 0;    // of this thread's processor time
  double asked_ = 0;  // SecondsOfDraws that the subject took after the gathering
  std::unique_ptr<Subject> subject_;
  std::unique_ptr<Subject> stated_;
  std::vector<Observation> observations_;  // modelled wrong ones first
  std::size_t wrong_ = 0;
  std::size_t modelled_ = 0;
  std::vector<Suspect> suspects_;
  std::vector<Seen> stated_drew_;  // of the wrong ones, when the race began
  std::vector<Fitting> partly_;    // sound ones that reproduce some wrong draws
  std::size_t raced_ = 0;          // observations when they were found
  std::set<std::size_t> open_;     // failures without a cause
  // Of failures: what draws alike, by too few scenes to be sure.
  std::map<std::size_t, Cause> hints_;
  Causes found_;
};

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CAUSE_INVESTIGATION_H_
