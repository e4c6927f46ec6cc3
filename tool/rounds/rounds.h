// A program that is not at hand is asked in rounds: a file of requests out, a file of answers in.
#ifndef RASTERPROOF_TOOL_ROUNDS_ROUNDS_H_
#define RASTERPROOF_TOOL_ROUNDS_ROUNDS_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/drawing.h"
#include "props/engine/pulled.h"

namespace rasterproof::tool {

/// Two answers to one request differ: the program is not deterministic.
class ChangedAnswer : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A folder with rounds.json, and round-N.requests and round-N.answers of every round, whichever
/// verb asked: what was answered is known to the engine, what the engine asks next makes up the
/// next round.
class Rounds {
 public:
  /// Reads the folder, which may be new. `stated` is a hash of what the program states. The engine
  /// outlives this.
  ///
  /// Error:      InputError with the file, the line and the remedy: the folder is about another
  ///             program, a file changed after it was read, an answer is missing or is none.
  ///             ChangedAnswer with both places.
  Rounds(std::string folder, std::string stated, props::PulledEngine& engine);

  /// The path of the answers that are waited for; nothing if all rounds have theirs.
  const std::optional<std::string>& waits_for() const { return waits_for_; }
  /// Writes the next round, whole or not at all. Returns its number, from 1.
  ///
  /// Domain:     at least one job.
  std::size_t Write(std::span<const DrawJob> jobs);
  std::string PathOf(std::size_t round, std::string_view ending) const;

 private:
  struct Round {
    std::size_t requests = 0;
    std::string hash_of_requests;
    std::string hash_of_answers;  ///< empty: none were read
  };
  // Where an answer begins.
  struct Place {
    std::size_t round = 0;
    std::size_t line = 0;
    std::uint64_t id = 0;
  };

  std::string StatePath() const { return folder_ + "/rounds.json"; }
  void ReadState();
  void WriteState() const;
  void ReadRound(std::size_t number);
  void Note(const DrawJob& job, const DrawOutcome& outcome, const Place& place);
  std::string Spelled(const DrawJob& job) const;

  std::string folder_;
  std::string stated_;
  props::PulledEngine& engine_;
  std::vector<Round> rounds_;
  std::uint64_t last_id_ = 0;
  std::optional<std::string> waits_for_;
  std::unordered_map<std::string, Place> first_;  ///< of each request, by its spelling
};

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_ROUNDS_ROUNDS_H_
