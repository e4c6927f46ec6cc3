// A program that is not at hand is asked in rounds: a file of requests out, a file of answers in.
#ifndef RASTERPROOF_TOOL_PIPE_ROUNDS_H_
#define RASTERPROOF_TOOL_PIPE_ROUNDS_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "core/drawing.h"
#include "core/subject.h"
#include "core/subject_info.h"

namespace rasterproof::tool {

/// What a folder of rounds is about, name and value: "case", the hash of its text; "seed", "1".
using RoundsTask = std::vector<std::pair<std::string, std::string>>;

/// Two answers to one request differ: the program is not deterministic.
class ChangedAnswer : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A folder with rounds.json, and round-N.requests and round-N.answers of every round: what was
/// asked before is known, what is asked now makes up the next round.
class Rounds {
 public:
  /// Reads the folder, which may be new. A round has about `most` requests.
  ///
  /// Error:      InputError with the file, the line and the remedy: the folder is about another
  ///             task, a file changed after it was read, an answer is missing or is none.
  ///             ChangedAnswer with both places.
  Rounds(std::string folder, RoundsTask task, const SubjectInfo& info, std::size_t most);

  /// The path of the answers that are waited for; nothing if all rounds have theirs.
  const std::optional<std::string>& waits_for() const { return waits_for_; }
  /// What the program answered, without what the job is drawn onto; nothing if it was not asked.
  std::optional<DrawOutcome> Find(const DrawJob& job) const;
  /// The jobs that are answered, each once, in the order of asking.
  const std::vector<DrawJob>& answered() const { return answered_; }
  /// How many rounds have had an answer to the job.
  int TimesAnswered(const DrawJob& job) const;

  /// Makes the job a request of the next round, once however often it is called.
  void Ask(const DrawJob& job);
  /// How many requests the next round has.
  std::size_t asked() const { return asked_.size(); }
  /// Whether the next round has room for more. Its files should be no larger than people carry.
  bool HasRoom() const;
  /// Writes the next round, whole or not at all. Returns its number, from 1.
  ///
  /// Domain:     something was asked.
  std::size_t Write();
  std::string PathOf(std::size_t round, std::string_view ending) const;

 private:
  struct Round {
    std::size_t requests = 0;
    std::string hash_of_requests;
    std::string hash_of_answers;  ///< empty: none were read
    std::string answers;
  };
  // Where an answer begins.
  struct Place {
    std::size_t round = 0;
    std::size_t begin = 0;
    std::size_t line = 0;
    std::uint64_t id = 0;
    int times = 1;
  };

  std::string KeyOf(const DrawJob& job) const;
  std::string StatePath() const { return folder_ + "/rounds.json"; }
  void ReadState();
  void RequireTask(std::string_view name, std::string_view value) const;
  void WriteState() const;
  void ReadRound(std::size_t number);
  void Note(const DrawJob& job, const Place& place);

  std::string folder_;
  RoundsTask task_;
  SubjectInfo info_;
  std::size_t most_;
  std::vector<Round> rounds_;
  std::uint64_t last_id_ = 0;
  std::optional<std::string> waits_for_;
  std::unordered_map<std::string, Place> known_;  ///< by the request's text
  std::vector<DrawJob> answered_;
  std::vector<DrawJob> asked_;
  std::size_t asked_samples_ = 0;
  std::unordered_set<std::string> is_asked_;
};

/// A subject whose answers come from rounds. What they do not have is asked in the next one.
class AnswersOfRounds final : public Subject {
 public:
  /// What becomes of a draw that has no answer yet: a refusal lets callers go on to the next one.
  enum class Unanswered : std::uint8_t { kEndsTheCall, kIsRefused };

  AnswersOfRounds(const SubjectInfo& info, std::shared_ptr<Rounds> rounds)
      : info_(info), rounds_(std::move(rounds)) {}
  const SubjectInfo& OwnInfo() const override { return info_; }
  std::vector<DrawOutcome> DrawMany(std::span<const DrawJob> jobs) override;
  bool SharesCalls() const override { return true; }

  void Take(Unanswered unanswered) { unanswered_ = unanswered; }
  /// Answers by a guess what has no answer yet; without one, as Take() says. It counts as missed.
  void Suppose(std::function<DrawOutcome(const DrawJob&)> guess) { guess_ = std::move(guess); }
  /// From here on what has fewer answers is asked again.
  void AskUpTo(int times) { times_ = times; }
  /// Returns how many draws had no answer so far.
  std::uint64_t missed() const { return missed_; }

 private:
  SubjectInfo info_;
  std::shared_ptr<Rounds> rounds_;
  Unanswered unanswered_ = Unanswered::kEndsTheCall;
  std::function<DrawOutcome(const DrawJob&)> guess_;
  int times_ = 1;
  std::uint64_t missed_ = 0;
};

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_PIPE_ROUNDS_H_
