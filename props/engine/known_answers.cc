#include "props/engine/known_answers.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "core/call_end.h"
#include "core/coverage.h"
#include "core/error.h"
#include "core/hash_text.h"

namespace rasterproof::props {
namespace {

constexpr std::string_view kSavedAnswers = "rasterproof answers 1\n";
constexpr std::size_t kNumberBytes = 8;

void AddNumber(std::string& bytes, std::uint64_t n) {
  for (std::size_t k = 0; k < kNumberBytes; ++k) bytes.push_back(static_cast<char>(n >> (8 * k)));
}

template <class T>
void AddRaw(std::string& bytes, const T& value) {
  const auto* raw = reinterpret_cast<const char*>(&value);
  bytes.append(raw, sizeof(T));
}

void AddChannels(std::string& bytes, const std::vector<Channel>& channels) {
  AddNumber(bytes, channels.size());
  for (const Channel& channel : channels) {
    AddNumber(bytes, channel.name.size());
    bytes += channel.name;
    AddRaw(bytes, channel.interpolation);
    AddRaw(bytes, channel.at);
    AddNumber(bytes, channel.values.size());
    for (const double x : channel.values) AddRaw(bytes, x);
  }
}

// All that a draw may depend on.
std::string BytesOfJob(const DrawJob& job) {
  const Scene& scene = *job.scene;
  const DrawOptions& o = job.options;
  const PixelRect whole{0, 0, -1, -1};
  const PixelRect& r = o.scissor ? *o.scissor : whole;
  std::string bytes;
  for (const int n :
       {scene.width, scene.height, job.samples, scene.clip_space ? 1 : 0,
        static_cast<int>(scene.precision), static_cast<int>(o.cull), o.tile, o.threads,
        static_cast<int>(o.float_mode), r.x0, r.y0, r.x1, r.y1, job.wants.primitive_ids ? 1 : 0,
        job.wants.barycentrics ? 1 : 0, job.wants.depths ? 1 : 0, job.wants.centroids ? 1 : 0,
        job.wants.values ? 1 : 0, job.wants.derivatives ? 1 : 0}) {
    AddRaw(bytes, n);
  }
  AddNumber(bytes, scene.vertices.size());
  for (const Vertex& v : scene.vertices) {
    for (const double x : {v.x, v.y, v.z, v.w}) AddRaw(bytes, x);
  }
  if (job.wants.values) AddChannels(bytes, scene.channels);
  for (const Triangle& t : job.Triangles()) AddRaw(bytes, t);
  return bytes;
}

std::optional<std::uint64_t> TakeNumber(std::string_view& bytes) {
  if (bytes.size() < kNumberBytes) return std::nullopt;
  std::uint64_t n = 0;
  for (std::size_t k = 0; k < kNumberBytes; ++k) {
    n |= std::uint64_t{static_cast<unsigned char>(bytes[k])} << (8 * k);
  }
  bytes.remove_prefix(kNumberBytes);
  return n;
}

}  // namespace

KnownAnswers::KnownAnswers(const SubjectInfo& info, RoundSize size, Spelling spelling)
    : info_(info), size_(size), spelling_(spelling ? std::move(spelling) : BytesOfJob) {}

// Two hashes of one text, begun in different states: as good as 128 bits, if they are independent,
// which is supposed and not proved.
KnownAnswers::Key KnownAnswers::KeyOf(const DrawJob& job) const {
  const std::string text = spelling_(job);
  return {Fnv1a(text), Fnv1a(text, Fnv1a("2"))};
}

bool KnownAnswers::Learn(const DrawJob& job, const DrawOutcome& outcome) {
  const auto [it, is_new] = known_.try_emplace(KeyOf(job), Entry{OutcomeBytes(outcome)});
  if (is_new) return true;
  ++it->second.times;
  return it->second.answer == OutcomeBytes(outcome);
}

int KnownAnswers::TimesAnswered(const DrawJob& job) const {
  const auto it = known_.find(KeyOf(job));
  return it == known_.end() ? 0 : it->second.times;
}

void KnownAnswers::Want(const DrawJob& job) {
  if (!is_wanted_.insert(KeyOf(job)).second) return;
  wanted_.push_back(job);
  wanted_.back().onto = nullptr;
  samples_ += CoverageCounts::Size(job.scene->width, job.scene->height, job.samples);
}

std::vector<DrawJob> KnownAnswers::TakeWanted() {
  is_wanted_.clear();
  samples_ = 0;
  return std::exchange(wanted_, {});
}

DrawOutcome KnownAnswers::OutcomeOf(const DrawJob& job) {
  const auto it = known_.find(KeyOf(job));
  if (it == known_.end() || it->second.times < times_) Want(job);
  if (it != known_.end()) return *ReadOutcome(it->second.answer);
  ++missed_;
  if (guess_) return guess_(job);
  const bool ends = missing_ == Missing::kEndsTheCall;
  return {{}, {ends ? Stop::kTooSlow : Stop::kRefused, "it is not answered yet"}};
}

std::vector<DrawOutcome> KnownAnswers::DrawMany(std::span<const DrawJob> jobs) {
  std::vector<DrawOutcome> outcomes;
  std::size_t count = jobs.size();  // with the first that ends the call; all are wanted
  for (const DrawJob& job : jobs) {
    DrawOutcome& outcome = outcomes.emplace_back(OutcomeOf(job));
    if (outcome.end.stop == Stop::kNone && job.onto) outcome.drawing.counts += *job.onto;
    if (EndsTheCall(outcome.end.stop)) count = std::min(count, outcomes.size());
  }
  outcomes.resize(count);
  return outcomes;
}

std::string KnownAnswers::Save() const {
  std::string saved(kSavedAnswers);
  for (const auto& [key, entry] : known_) {
    for (const std::uint64_t half : key) AddNumber(saved, half);
    AddNumber(saved, static_cast<std::uint64_t>(entry.times));
    AddNumber(saved, entry.answer.size());
    saved += entry.answer;
  }
  return saved;
}

void KnownAnswers::Load(std::string_view saved) {
  const InputError error("saved answers", "these are none", "give what Save() returned");
  if (!saved.starts_with(kSavedAnswers)) throw error;
  saved.remove_prefix(kSavedAnswers.size());
  std::map<Key, Entry> known;
  while (!saved.empty()) {
    std::array<std::uint64_t, 4> head{};
    for (std::uint64_t& n : head) {
      const std::optional<std::uint64_t> number = TakeNumber(saved);
      if (!number) throw error;
      n = *number;
    }
    const auto& [first, second, times, size] = head;
    const bool is_count = times >= 1 && times <= INT32_MAX;
    if (!is_count || size > saved.size()) throw error;
    const std::string_view answer = saved.substr(0, static_cast<std::size_t>(size));
    if (!ReadOutcome(answer)) throw error;
    known[{first, second}] = {std::string(answer), static_cast<int>(times)};
    saved.remove_prefix(answer.size());
  }
  known_ = std::move(known);
}

}  // namespace rasterproof::props
