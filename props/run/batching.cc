#include "props/run/batching.h"

#include <algorithm>
#include <array>
#include <bit>
#include <exception>
#include <future>
#include <optional>
#include <utility>

#include "core/error.h"
#include "props/run/guarded.h"
#include "props/run/look_ahead.h"

namespace rasterproof::props {
namespace {

// A call is kept to so many samples and vertices: what is at hand of it takes memory on either
// side.
constexpr std::size_t kMostInACall = std::size_t{1} << 20;
// After so many calls what a case still asks for is drawn at once: each put-off draw costs another
// run of the property up to it.
constexpr std::size_t kMostRounds = 2;

bool HasSameBits(const Vertex& a, const Vertex& b) {
  const auto bits = [](const Vertex& v) {
    return std::bit_cast<std::array<std::uint64_t, 4>>(std::array<double, 4>{v.x, v.y, v.z, v.w});
  };
  return bits(a) == bits(b);
}

bool AsksTheSame(const DrawJob& a, const DrawJob& b) {
  const Scene& x = *a.scene;
  const Scene& y = *b.scene;
  return x.width == y.width && x.height == y.height && x.clip_space == y.clip_space &&
         a.samples == b.samples && a.options == b.options && a.wants == b.wants &&
         std::ranges::equal(a.Triangles(), b.Triangles()) &&
         (&x == &y || std::ranges::equal(x.vertices, y.vertices, HasSameBits));
}

std::size_t SizeOf(const DrawJob& job) {
  return CoverageCounts::Size(job.scene->width, job.scene->height, job.samples) +
         job.scene->vertices.size();
}

// The open jobs of some ledgers, in their order, as many as fit a call.
struct Call {
  std::vector<DrawJob> jobs;
  std::vector<DrawLedger*> ledgers;  ///< where the outcome of each job goes
};

Call NextCall(std::span<DrawLedger> ledgers) {
  Call call;
  std::size_t size = 0;
  for (DrawLedger& ledger : ledgers) {
    for (std::size_t k = ledger.outcomes.size(); k < ledger.jobs.size(); ++k) {
      size += SizeOf(ledger.jobs[k]);
      if (!call.jobs.empty() && size > kMostInACall) return call;
      call.jobs.push_back(ledger.jobs[k]);
      call.ledgers.push_back(&ledger);
    }
  }
  return call;
}

// Draws what the ledgers ask for. After a breakdown the rest is left open: the case that caused it
// is judged first. Returns whether there was none.
bool DrawOpenJobs(Subject& subject, std::span<DrawLedger> ledgers) {
  for (;;) {
    const Call call = NextCall(ledgers);
    if (call.jobs.empty()) return true;
    std::vector<DrawOutcome> outcomes = subject.DrawMany(call.jobs);
    const bool broke_down_at_its_end = outcomes.back().BrokeDown();
    for (std::size_t k = 0; k < outcomes.size(); ++k) {
      call.ledgers[k]->outcomes.push_back(std::move(outcomes[k]));
    }
    if (!broke_down_at_its_end) continue;
    DrawLedger& broke_down = *call.ledgers[outcomes.size() - 1];
    broke_down.jobs.resize(broke_down.outcomes.size());
    return false;
  }
}

}  // namespace

BatchingSubject::BatchingSubject(std::unique_ptr<Subject> behind)
    : behind_(std::make_unique<GuardedSubject>(std::move(behind))), info_(behind_->Info()) {}

BatchingSubject::BatchingSubject(SubjectInfo info) : info_(std::move(info)) {}

const EdgeEvaluator* BatchingSubject::Edges() const { return behind_ ? behind_->Edges() : nullptr; }

const WeightEvaluator* BatchingSubject::Weights() const {
  return behind_ ? behind_->Weights() : nullptr;
}

void BatchingSubject::SetDeadline(std::chrono::steady_clock::time_point deadline) {
  if (behind_) behind_->SetDeadline(deadline);
}

void BatchingSubject::Follow(DrawLedger& ledger, OnMiss on_miss) {
  ledger_ = &ledger;
  on_miss_ = on_miss;
  next_ = 0;
}

void BatchingSubject::Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
  if (ledger_ == nullptr) {
    behind_->Draw(scene, options, counts);
  } else {
    counts += Show({scene, options, counts.samples}).counts;
  }
}

Drawing BatchingSubject::Show(const DrawJob& job) {
  if (ledger_ == nullptr) return behind_->Show(job);
  DrawOutcome outcome = std::move(DrawMany({&job, 1}).front());
  outcome.Get();  // or it throws
  return std::move(outcome.drawing);
}

std::vector<DrawOutcome> BatchingSubject::DrawMany(std::span<const DrawJob> jobs) {
  if (ledger_ == nullptr) return behind_->DrawMany(jobs);
  if (on_miss_ == OnMiss::kDrawNow && next_ >= ledger_->outcomes.size()) {
    return behind_->DrawMany(jobs);
  }
  std::vector<DrawOutcome> outcomes;
  bool put_off = false;
  for (const DrawJob& job : jobs) {
    const DrawOutcome* const found = Find(job);
    put_off = put_off || (found == nullptr && on_miss_ == OnMiss::kPutOff);
    outcomes.push_back(found != nullptr ? *found : Missing(job));
    if (outcomes.back().BrokeDown()) return outcomes;
  }
  if (put_off) throw PutOff{};
  return outcomes;
}

// The outcome of a job, or nullptr if there is none yet; the job is then among the ledger's, unless
// misses are refused.
const DrawOutcome* BatchingSubject::Find(const DrawJob& job) {
  std::vector<DrawJob>& jobs = ledger_->jobs;
  std::size_t k = next_++;
  if (on_miss_ == OnMiss::kCoverNothing || on_miss_ == OnMiss::kRefuse) {
    const auto same = [&](const DrawJob& other) { return AsksTheSame(job, other); };
    k = static_cast<std::size_t>(std::ranges::find_if(jobs, same) - jobs.begin());
  }
  const bool adds = on_miss_ == OnMiss::kPutOff || on_miss_ == OnMiss::kCoverNothing;
  if (k >= jobs.size() && adds) jobs.push_back(job);
  return k < ledger_->outcomes.size() ? &ledger_->outcomes[k] : nullptr;
}

DrawOutcome BatchingSubject::Missing(const DrawJob& job) {
  if (on_miss_ == OnMiss::kDrawNow) return std::move(behind_->DrawMany({&job, 1}).front());
  DrawOutcome outcome;
  if (on_miss_ == OnMiss::kRefuse) {
    outcome.error =
        std::make_exception_ptr(InputError("subject " + info_.name, "it was not asked to draw this",
                                           "use check --exec, which can ask again"));
    return outcome;
  }
  Drawing& drawing = outcome.drawing;
  drawing.counts = CoverageCounts(job.scene->width, job.scene->height, job.samples);
  if (ShowsWinners(info_)) {
    drawing.winners.assign(drawing.counts.size(), kNoTriangle);
    drawing.weights.resize(drawing.counts.size());
    drawing.depths.resize(drawing.counts.size());
  }
  return outcome;
}

BatchingSubject* BatchingOf(Subject& subject) {
  return dynamic_cast<BatchingSubject*>(&subject.Whole());
}

namespace {

// What came of the case, or nothing if a draw of it was put off.
std::optional<Trial> TryUnlessPutOff(Subject& subject, const Property& property, const Case& c) {
  try {
    return TryCase(subject, property, c);
  } catch (const PutOff&) {
    return std::nullopt;
  }
}

// Draws go to the rasterizer again, however a run in batches ends.
class Following {
 public:
  explicit Following(BatchingSubject& batching) : batching_(batching) {}
  ~Following() { batching_.FollowNone(); }
  Following(const Following&) = delete;
  Following& operator=(const Following&) = delete;

 private:
  BatchingSubject& batching_;
};

// Behind these outcomes no case of the batch counts.
bool EndsTheBatch(Outcome outcome) {
  return outcome == Outcome::kViolated || outcome == Outcome::kInconclusive;
}

}  // namespace

std::vector<Trial> RunCasesInBatches(Subject& subject, BatchingSubject& batching,
                                     const Property& property, std::span<const Case> cases,
                                     const std::function<bool()>& stop) {
  if (property.ask != nullptr) return TryTogether(subject, property, cases, stop);
  const Following following(batching);
  std::vector<DrawLedger> ledgers(cases.size());
  std::vector<std::optional<Trial>> trials(cases.size());
  std::size_t end = cases.size();  // behind the case that ends the batch
  const auto judge = [&](std::size_t first, std::size_t last, OnMiss on_miss) {
    for (std::size_t k = first; k < std::min(last, end); ++k) {
      if (trials[k] || (ledgers[k].HasOpenJobs() && on_miss == OnMiss::kPutOff)) continue;
      if (stop && stop()) return;
      batching.Follow(ledgers[k], on_miss);
      std::optional<Trial> trial = TryUnlessPutOff(subject, property, cases[k]);
      if (ledgers[k].HasOpenJobs() && on_miss == OnMiss::kPutOff) continue;
      trials[k] = std::move(trial);
      if (EndsTheBatch(trials[k]->verdict.outcome)) end = k + 1;
    }
  };
  const std::size_t half = cases.size() / 2;
  std::future<bool> drawing;  // of the half that is not being judged
  for (std::size_t turn = 0; turn < 2 * kMostRounds; ++turn) {
    const std::size_t first = turn % 2 == 0 ? 0 : half;
    const std::size_t count = turn % 2 == 0 ? half : cases.size() - half;
    judge(first, first + count, OnMiss::kPutOff);
    // Behind a breakdown most draws would be in vain, and might each cost a time limit.
    if (drawing.valid() && !drawing.get()) break;
    if (stop && stop()) break;
    drawing = std::async(std::launch::async, [&ledgers, &batching, first, count] {
      return DrawOpenJobs(batching.Behind(), std::span(ledgers).subspan(first, count));
    });
  }
  if (drawing.valid()) drawing.get();
  judge(0, end, OnMiss::kDrawNow);
  std::vector<Trial> done;
  for (std::size_t k = 0; k < end && trials[k]; ++k) done.push_back(std::move(*trials[k]));
  return done;
}

}  // namespace rasterproof::props
