// A subject that knows the answers so far, and collects the requests that have none.
#ifndef RASTERPROOF_PROPS_ENGINE_KNOWN_ANSWERS_H_
#define RASTERPROOF_PROPS_ENGINE_KNOWN_ANSWERS_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/drawing.h"
#include "core/subject.h"
#include "core/subject_info.h"

namespace rasterproof::props {

/// The most that one round asks.
struct RoundSize {
  std::size_t requests = 4000;
  std::size_t samples = std::size_t{1} << 25;
  /// Requests of one shrinking: its guesses at what comes after what is not answered yet. Many make
  /// few rounds, few make little work.
  std::size_t of_a_shrinking = 1000;
};

/// Draws by a memory of answers. A job that has none is wanted: it counts as missed, and its
/// outcome is one that its caller gives up on, so that work which missed something is to be run
/// again. Targets are added to here, as for a program on a pipe.
class KnownAnswers final : public Subject {
 public:
  /// What stands for an answer that is missing: a refusal lets a call go on to its next draw.
  enum class Missing : std::uint8_t { kIsRefused, kEndsTheCall };
  /// Spells a job. Jobs that are spelled alike have one answer.
  using Spelling = std::function<std::string(const DrawJob&)>;

  /// Without a spelling, all that a draw may depend on.
  explicit KnownAnswers(const SubjectInfo& info, RoundSize size = {}, Spelling spelling = {});

  const SubjectInfo& OwnInfo() const override { return info_; }
  std::vector<DrawOutcome> DrawMany(std::span<const DrawJob> jobs) override;
  bool SharesCalls() const override { return true; }

  /// Keeps an answer, without what the job is drawn onto.
  ///
  /// Returns:    false if the job had another answer before: the subject is not deterministic.
  bool Learn(const DrawJob& job, const DrawOutcome& outcome);
  /// Returns how many answers the job had so far.
  int TimesAnswered(const DrawJob& job) const;

  /// Makes the job a request of the next round, once however often it is called.
  void Want(const DrawJob& job);
  bool HasRoom() const { return wanted_.size() < size_.requests && samples_ < size_.samples; }
  std::size_t wanted() const { return wanted_.size(); }
  const RoundSize& size() const { return size_; }
  /// Returns the requests of the next round, and begins another round.
  std::vector<DrawJob> TakeWanted();
  /// Returns how many draws had no answer so far.
  std::uint64_t missed() const { return missed_; }

  void Take(Missing missing) { missing_ = missing; }
  /// Answers by a guess what has no answer. It counts as missed. An empty function ends this.
  void Suppose(std::function<DrawOutcome(const DrawJob&)> guess) { guess_ = std::move(guess); }
  /// From here on what has fewer answers is wanted again; that is no miss.
  void AskUpTo(int times) { times_ = times; }

  /// Returns all answers, for Load() of one with the same description and spelling.
  std::string Save() const;
  /// Error:      InputError if these are no saved answers; then nothing changes.
  void Load(std::string_view saved);

 private:
  using Key = std::array<std::uint64_t, 2>;
  struct Entry {
    std::string answer;
    int times = 1;
  };

  Key KeyOf(const DrawJob& job) const;
  DrawOutcome OutcomeOf(const DrawJob& job);

  SubjectInfo info_;
  RoundSize size_;
  Spelling spelling_;
  std::map<Key, Entry> known_;
  std::vector<DrawJob> wanted_;
  std::set<Key> is_wanted_;
  std::size_t samples_ = 0;  ///< of what is wanted
  Missing missing_ = Missing::kIsRefused;
  std::function<DrawOutcome(const DrawJob&)> guess_;
  int times_ = 1;
  std::uint64_t missed_ = 0;
};

/// Returns an answer as bytes, which ReadOutcome() reads.
std::string OutcomeBytes(const DrawOutcome& outcome);
/// Returns nothing if the bytes are no answer.
std::optional<DrawOutcome> ReadOutcome(std::string_view bytes);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_ENGINE_KNOWN_ANSWERS_H_
