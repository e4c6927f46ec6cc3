#include "tool/rounds/rounds.h"

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

// The answers of a file.
class AnswersText {
 public:
  explicit AnswersText(std::string_view text) : text_(text) {}

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
  std::size_t next_ = 0;
  std::size_t line_ = 1;
  bool was_short_ = false;
};

DrawOutcome NextOutcome(AnswersText& text, std::uint64_t id, const DrawJob& job,
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

Rounds::Rounds(std::string folder, std::string stated, props::PulledEngine& engine)
    : folder_(std::move(folder)), stated_(std::move(stated)), engine_(engine) {
  if (std::filesystem::exists(StatePath())) ReadState();
  for (std::size_t n = 1; n <= rounds_.size() && !waits_for_; ++n) ReadRound(n);
}

std::string Rounds::PathOf(std::size_t round, std::string_view ending) const {
  return fmt::format("{}/round-{}.{}", folder_, round, ending);
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
  const auto require = [&](std::string_view key, std::string_view value, const std::string& what) {
    if (root.Get(key).RequireString() == value) return;
    throw InputError(StatePath(), "its rounds are about another " + what, "give another folder");
  };
  require("program", RASTERPROOF_VERSION, "version of rasterproof");
  require("stated_fnv1a64", stated_, "description or profile");
  for (const io::JsonValue item : root.Get("rounds").RequireArray()) {
    rounds_.push_back({integer(item.Get("requests")),
                       std::string(item.Get("requests_fnv1a64").RequireString()),
                       std::string(item.Get("answers_fnv1a64").RequireString())});
  }
}

void Rounds::WriteState() const {
  io::JsonWriter json;
  json.BeginObject();
  json.Key("rasterproof_rounds").Integer(kRoundsVersion);
  json.Key("program").Text(RASTERPROOF_VERSION);
  json.Key("stated_fnv1a64").Text(stated_);
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
  const std::string answers = io::ReadFile(answered);
  const std::string hash = HashText(answers);
  if (!round.hash_of_answers.empty() && hash != round.hash_of_answers) {
    throw InputError(answered, "it changed after it was read",
                     "restore it, or begin again in another folder");
  }
  AnswersText text(answers);
  std::size_t read = 0;
  for (const DrawJob& job : JobsOf(requests, asked)) {
    const std::size_t begin = text.next();
    const Place place{number, text.line(), ++last_id_};
    const DrawOutcome outcome = NextOutcome(text, place.id, job, engine_.answers().Info());
    const std::string where = fmt::format("{}: line {}", answered, text.line() - 1);
    if (text.was_short()) {
      throw InputError(where,
                       fmt::format("the file ends before request {} is answered: {} of {} are",
                                   place.id, read, round.requests),
                       "let the program answer all of " + asked);
    }
    if (IsBreakdown(outcome.end.stop) && !SaysFault(answers, begin, place.id)) {
      throw InputError(where, fmt::format("no answer to request {}: {}", place.id, outcome.end.why),
                       "let the program answer " + asked + " again");
    }
    Note(job, outcome, place);
    ++read;
  }
  if (!text.AtEnd()) {
    throw InputError(fmt::format("{}: line {}", answered, text.line()),
                     "it goes on after the last answer: " + Quoted(text.NextLine(), 60),
                     "let the program answer " + asked + " and nothing else");
  }
  round.hash_of_answers = hash;
}

void Rounds::Note(const DrawJob& job, const DrawOutcome& outcome, const Place& place) {
  const Place first = first_.try_emplace(Spelled(job), place).first->second;
  if (engine_.answers().Learn(job, outcome)) return;
  throw ChangedAnswer(
      fmt::format("{}: line {}: request {} asks what request {} asked, and the answer differs from "
                  "the one in {}, line {}: the program is not deterministic; make it so, and begin "
                  "again in another folder",
                  PathOf(place.round, "answers"), place.line, place.id, first.id,
                  PathOf(first.round, "answers"), first.line));
}

std::string Rounds::Spelled(const DrawJob& job) const {
  return HashText(subjects::RequestsText(1, {&job, 1}, engine_.answers().Info()));
}

std::size_t Rounds::Write(std::span<const DrawJob> jobs) {
  io::MakeFolder(folder_);
  const std::string answers = PathOf(rounds_.size() + 1, "answers");
  if (std::filesystem::exists(answers)) {
    throw InputError(answers, "it exists before anything was asked",
                     "remove it: it belongs to other rounds");
  }
  Round& round = rounds_.emplace_back();
  const std::string requests = subjects::RequestsText(last_id_ + 1, jobs, engine_.answers().Info());
  round.requests = jobs.size();
  round.hash_of_requests = HashText(requests);
  io::WriteFile(PathOf(rounds_.size(), "requests"), requests);
  WriteState();
  return rounds_.size();
}

}  // namespace rasterproof::tool
