#include "tool/pipe/rounds.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <sstream>

#include "core/call_end.h"
#include "core/error.h"
#include "core/hash_text.h"
#include "core/quoted.h"
#include "fmt/format.h"
#include "io/json_document.h"
#include "io/json_writer.h"
#include "io/output.h"
#include "subjects/process/protocol.h"

namespace rasterproof::tool {
namespace {

constexpr int kRoundsVersion = 1;
constexpr std::string_view kProgram = "version of rasterproof";
constexpr std::size_t kMostSamples = std::size_t{1} << 25;  // in a round: files that can be sent

// The answers of a file, from a place in it on.
class AnswersText {
 public:
  AnswersText(std::string_view text, std::size_t begin, std::size_t line)
      : text_(text), next_(begin), line_(line) {}

  std::size_t next() const { return next_; }
  std::size_t line() const { return line_; }  ///< of what is read next, from 1
  bool AtEnd() const { return next_ >= text_.size(); }
  bool was_short() const { return was_short_; }

  std::string_view NextLine() {
    was_short_ = was_short_ || AtEnd();
    const std::size_t end = std::min(text_.find('\n', next_), text_.size());
    std::string_view line = text_.substr(std::min(next_, end), end - std::min(next_, end));
    next_ = end + 1;
    ++line_;
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
  }
  std::string_view NextBytes(std::size_t count) {
    was_short_ = was_short_ || text_.size() - std::min(next_, text_.size()) < count;
    if (was_short_) BreakDown("it ends within an array");
    const std::string_view bytes = text_.substr(next_, count);
    line_ += static_cast<std::size_t>(std::ranges::count(bytes, '\n'));
    next_ += count;
    return bytes;
  }

 private:
  std::string_view text_;
  std::size_t next_;
  std::size_t line_;
  bool was_short_ = false;
};

DrawOutcome OutcomeAt(AnswersText& text, std::uint64_t id, const DrawJob& job,
                      const SubjectInfo& info) {
  DrawOutcome outcome;
  outcome.end = EndOf([&] {
    outcome.drawing = subjects::ReadAnswer(
        id, job, info, [&](std::size_t /*most_bytes*/) { return text.NextLine(); },
        [&](std::size_t count) { return text.NextBytes(count); });
  });
  return outcome;
}

// Whether the program itself says that it has a fault. Anything else that is no answer may as well
// come from how the file came here.
bool SaysFault(std::string_view text, std::size_t begin, std::uint64_t id) {
  const std::string head = fmt::format("fault {}", id);
  const std::string_view said = text.substr(begin);
  return said.starts_with(head + " ") || said.starts_with(head + "\n");
}

std::string AnswerAsText(const DrawOutcome& outcome, const DrawJob& job, const SubjectInfo& info) {
  if (outcome.end.stop != Stop::kNone) return outcome.end.why;
  return subjects::AnswerText(1, outcome.drawing, info.coverage, job.wants);
}

std::vector<DrawJob> JobsOf(const std::string& requests, const std::string& path) {
  std::istringstream in(requests);
  subjects::RequestReader reader(in);
  std::vector<DrawJob> jobs;
  try {
    for (;;) {
      std::vector<subjects::DrawRequest> call = reader.NextCall();
      if (call.empty()) return jobs;
      for (subjects::DrawRequest& request : call) jobs.push_back(std::move(request.job));
    }
  } catch (const InputError& error) {
    throw InputError(path, error.what(), "begin again in another folder");
  }
}

}  // namespace

Rounds::Rounds(std::string folder, RoundsTask task, const SubjectInfo& info, std::size_t most)
    : folder_(std::move(folder)), task_(std::move(task)), info_(info), most_(most) {
  task_.emplace_back(kProgram, RASTERPROOF_VERSION);
  if (std::filesystem::exists(StatePath())) ReadState();
  for (std::size_t n = 1; n <= rounds_.size() && !waits_for_; ++n) ReadRound(n);
}

std::string Rounds::PathOf(std::size_t round, std::string_view ending) const {
  return fmt::format("{}/round-{}.{}", folder_, round, ending);
}

std::string Rounds::KeyOf(const DrawJob& job) const {
  return subjects::RequestsText(1, {&job, 1}, info_);
}

void Rounds::RequireTask(std::string_view name, std::string_view value) const {
  const auto it = std::ranges::find(task_, name, [](const auto& item) { return item.first; });
  if (it != task_.end() && it->second == value) return;
  throw InputError(StatePath(), fmt::format("its rounds are about another {}", name),
                   "repeat the command that began them, or give another folder");
}

void Rounds::ReadState() {
  const io::JsonDocument document(io::ReadFile(StatePath()), StatePath());
  const io::JsonValue root = document.root();
  const auto integer = [](const io::JsonValue& value) {
    return static_cast<std::size_t>(
        value.RequireInteger(0, std::numeric_limits<std::int64_t>::max()));
  };
  const io::JsonValue version = root.Get("rasterproof_rounds");
  if (integer(version) != kRoundsVersion) {
    throw version.Error(fmt::format("is not version {}", kRoundsVersion),
                        "give another folder, or the program that began this one");
  }
  RequireTask(kProgram, root.Get("program").RequireString());
  for (const io::JsonValue item : root.Get("task").RequireArray()) {
    RequireTask(item.Get("name").RequireString(), item.Get("value").RequireString());
  }
  for (const io::JsonValue item : root.Get("rounds").RequireArray()) {
    rounds_.push_back({integer(item.Get("requests")),
                       std::string(item.Get("requests_fnv1a64").RequireString()),
                       std::string(item.Get("answers_fnv1a64").RequireString()),
                       {}});
  }
}

void Rounds::WriteState() const {
  io::JsonWriter json;
  json.BeginObject();
  json.Key("rasterproof_rounds").Integer(kRoundsVersion);
  json.Key("program").Text(RASTERPROOF_VERSION);
  json.Key("task").BeginArray();
  for (const auto& [name, value] : task_) {
    if (name == kProgram) continue;
    json.BeginObjectLine();
    json.Key("name").Text(name);
    json.Key("value").Text(value);
    json.EndObject();
  }
  json.EndArray();
  json.Key("rounds").BeginArray();
  for (const Round& round : rounds_) {
    json.BeginObjectLine();
    json.Key("requests").Integer(round.requests);
    json.Key("requests_fnv1a64").Text(round.hash_of_requests);
    json.Key("answers_fnv1a64").Text(round.hash_of_answers);
    json.EndObject();
  }
  json.EndArray();
  json.EndObject();
  io::WriteFile(StatePath(), json.Finish());
}

void Rounds::ReadRound(std::size_t number) {
  Round& round = rounds_[number - 1];
  const std::string asked = PathOf(number, "requests");
  const std::string answered = PathOf(number, "answers");
  const std::string requests = io::ReadFile(asked);
  if (HashText(requests) != round.hash_of_requests) {
    throw InputError(asked, "it changed after it was written", "begin again in another folder");
  }
  if (round.hash_of_answers.empty() && !std::filesystem::exists(answered)) {
    waits_for_ = answered;
    return;
  }
  round.answers = io::ReadFile(answered);
  const std::string hash = HashText(round.answers);
  if (!round.hash_of_answers.empty() && hash != round.hash_of_answers) {
    throw InputError(answered, "it changed after it was read",
                     "restore it, or begin again in another folder");
  }
  AnswersText text(round.answers, 0, 1);
  std::size_t read = 0;
  for (const DrawJob& job : JobsOf(requests, asked)) {
    const Place place{number, text.next(), text.line(), ++last_id_};
    const DrawOutcome outcome = OutcomeAt(text, place.id, job, info_);
    const std::string where = fmt::format("{}: line {}", answered, text.line() - 1);
    if (text.was_short()) {
      throw InputError(where,
                       fmt::format("the file ends before request {} is answered: {} of {} are",
                                   place.id, read, round.requests),
                       "let the program answer all of " + asked);
    }
    if (IsBreakdown(outcome.end.stop) && !SaysFault(round.answers, place.begin, place.id)) {
      throw InputError(where, fmt::format("no answer to request {}: {}", place.id, outcome.end.why),
                       "let the program answer " + asked + " again");
    }
    Note(job, place);
    ++read;
  }
  if (!text.AtEnd()) {
    throw InputError(fmt::format("{}: line {}", answered, text.line()),
                     "it goes on after the last answer: " + Quoted(text.NextLine(), 60),
                     "let the program answer " + asked + " and nothing else");
  }
  round.hash_of_answers = hash;
}

void Rounds::Note(const DrawJob& job, const Place& place) {
  const auto [it, is_new] = known_.try_emplace(KeyOf(job), place);
  if (is_new) {
    answered_.push_back(job);
    return;
  }
  Place& first = it->second;
  const auto said_at = [&](const Place& at) {
    AnswersText text(rounds_[at.round - 1].answers, at.begin, at.line);
    return AnswerAsText(OutcomeAt(text, at.id, job, info_), job, info_);
  };
  ++first.times;
  if (said_at(first) == said_at(place)) return;
  throw ChangedAnswer(
      fmt::format("{}: line {}: request {} asks what request {} asked, and the answer differs from "
                  "the one in {}, line {}: the program is not deterministic; make it so, and begin "
                  "again in another folder",
                  PathOf(place.round, "answers"), place.line, place.id, first.id,
                  PathOf(first.round, "answers"), first.line));
}

std::optional<DrawOutcome> Rounds::Find(const DrawJob& job) const {
  const auto it = known_.find(KeyOf(job));
  if (it == known_.end()) return std::nullopt;
  const Place& at = it->second;
  AnswersText text(rounds_[at.round - 1].answers, at.begin, at.line);
  return OutcomeAt(text, at.id, job, info_);
}

int Rounds::TimesAnswered(const DrawJob& job) const {
  const auto it = known_.find(KeyOf(job));
  return it == known_.end() ? 0 : it->second.times;
}

void Rounds::Ask(const DrawJob& job) {
  if (!is_asked_.insert(KeyOf(job)).second) return;
  asked_.push_back(job);
  asked_.back().onto = nullptr;
  asked_samples_ += CoverageCounts::Size(job.scene->width, job.scene->height, job.samples);
}

bool Rounds::HasRoom() const { return asked_.size() < most_ && asked_samples_ < kMostSamples; }

std::size_t Rounds::Write() {
  io::MakeFolder(folder_);
  const std::string answers = PathOf(rounds_.size() + 1, "answers");
  if (std::filesystem::exists(answers)) {
    throw InputError(answers, "it exists before anything was asked",
                     "remove it: it belongs to other rounds");
  }
  Round& round = rounds_.emplace_back();
  const std::string requests = subjects::RequestsText(last_id_ + 1, asked_, info_);
  round.requests = asked_.size();
  round.hash_of_requests = HashText(requests);
  io::WriteFile(PathOf(rounds_.size(), "requests"), requests);
  WriteState();
  return rounds_.size();
}

namespace {

DrawOutcome NotYet(AnswersOfRounds::Unanswered unanswered) {
  const bool ends = unanswered == AnswersOfRounds::Unanswered::kEndsTheCall;
  return {{}, {ends ? Stop::kTooSlow : Stop::kRefused, "it is not answered yet"}};
}

}  // namespace

std::vector<DrawOutcome> AnswersOfRounds::DrawMany(std::span<const DrawJob> jobs) {
  std::vector<DrawOutcome> outcomes;
  for (const DrawJob& job : jobs) {
    if (rounds_->TimesAnswered(job) < times_) rounds_->Ask(job);
    std::optional<DrawOutcome> known = rounds_->Find(job);
    if (!known) {
      ++missed_;
      known = guess_ ? guess_(job) : NotYet(unanswered_);
    }
    outcomes.push_back(*std::move(known));
    DrawOutcome& outcome = outcomes.back();
    if (outcome.end.stop == Stop::kNone && job.onto != nullptr) {
      outcome.drawing.counts += *job.onto;
    }
  }
  const auto ends = std::ranges::find_if(
      outcomes, [](const DrawOutcome& outcome) { return EndsTheCall(outcome.end.stop); });
  if (ends != outcomes.end()) outcomes.erase(ends + 1, outcomes.end());
  return outcomes;
}

}  // namespace rasterproof::tool
