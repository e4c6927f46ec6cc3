#include "props/run/submit.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "core/call_end.h"
#include "core/error.h"
#include "core/target_size.h"
#include "props/placed_case.h"
#include "props/run/facing_draws.h"

namespace rasterproof::props {
namespace {

// A draw as the subject is given it: where its own transform takes the vertices to their places.
// Nothing, and a stop, if it can't be.
std::optional<DrawJob> AsGiven(const PlacedCase& placed, const std::string& subject,
                               const DrawJob& job, CallEnd& end) {
  if (const auto error =
          TargetSizeError("scene", job.scene->width, job.scene->height, job.samples)) {
    end = {Stop::kNotDrawable, error->what()};
    return std::nullopt;
  }
  if (!placed.before) return job;
  if (std::optional<Scene> scene = placed.before->AsGiven(*job.scene)) {
    DrawJob given = job;
    given.scene = std::make_shared<const Scene>(*std::move(scene));
    return given;
  }
  const InputError error("subject " + subject, placed.before->WhyNot(*job.scene),
                         "choose another property");
  end = {Stop::kNotDrawable, error.what()};
  return std::nullopt;
}

CoverageCounts Filled(std::uint32_t fill, const DrawJob& job) {
  CoverageCounts counts(job.scene->width, job.scene->height, job.samples);
  std::ranges::fill(counts.front, fill);
  std::ranges::fill(counts.back, fill);
  return counts;
}

// Where the outcome of one job of a call goes.
struct Destination {
  std::size_t request = 0;
  std::size_t draw = 0;      ///< among the drawings
  std::size_t question = 0;  ///< among the request's own
  FacingDraw part;
  bool is_whole = false;  ///< all that is shown is taken over; else the counts are added
};

class Submission {
 public:
  Submission(Subject& subject, std::span<const Request> requests)
      : subject_(subject),
        info_(subject.Info()),
        is_outside_(subject.SharesCalls()),
        requests_(requests),
        answers_(requests.size()),
        not_given_(requests.size()) {}

  std::vector<Answers> All() {
    for (std::size_t r = 0; r < requests_.size(); ++r) {
      for (const std::size_t base : requests_[r].check->bases) {
        answers_[r].draws.push_back((*requests_[r].drawn)[base]);
      }
      if (!PutInOrder(r)) AddDestinations(r);
    }
    DrawDestinations();
    for (std::size_t r = 0; r < answers_.size(); ++r) {
      Answers& answers = answers_[r];
      if (answers.end.stop == Stop::kNone) answers.end = not_given_[r];
      if (answers.end.stop == Stop::kNone) Evaluate(requests_[r].check->questions, answers);
    }
    return std::move(answers_);
  }

 private:
  std::optional<DrawJob> GivenOf(std::size_t r, const DrawJob& job, CallEnd& end) const {
    return AsGiven(*requests_[r].placed, info_.name, job, end);
  }

  // Facings are those of the question's scene; what is drawn is the scene as it is given.
  std::vector<FacingDraw> PartsOf(std::size_t r, const DrawQuestion& question,
                                  const DrawJob& job) const {
    if (question.parts == Parts::kWhole) return {{job, false}};
    std::vector<FacingDraw> parts =
        FacingDraws(question.job, info_.coverage, requests_[r].placed->stated);
    for (FacingDraw& part : parts) part.job.scene = job.scene;
    return parts;
  }

  // What a subject outside draws is added to its target here, whatever that held.
  bool NeedsItsTarget(const DrawQuestion& question) const {
    return (question.fill != 0 && !is_outside_) || question.onto_the_last;
  }

  // Draws that depend on what their target held, or on the calls before them. Returns whether the
  // request has such.
  bool PutInOrder(std::size_t r) {
    const Questions& questions = requests_[r].check->questions;
    const bool in_order =
        questions.company == Company::kInOrderAlone ||
        std::ranges::any_of(questions.draws, [&](const auto& q) { return NeedsItsTarget(q); });
    if (!in_order) return false;
    Answers& answers = answers_[r];
    std::shared_ptr<const Drawing> last;
    for (std::size_t k = 0; k < questions.draws.size(); ++k) {
      const DrawQuestion& question = questions.draws[k];
      answers.stopped_at = k;
      auto drawing = std::make_shared<Drawing>();
      if (const auto job = GivenOf(r, question.job, answers.end)) {
        answers.end = DrawInOrder(r, question, *job, last.get(), *drawing);
      }
      if (EndsTheCall(answers.end.stop) ||
          (answers.end.stop != Stop::kNone && !MayBeRefused(r, k))) {
        return true;
      }
      if (answers.end.stop != Stop::kNone) *drawing = Drawing();
      answers.end = {};
      last = drawing;
      answers.draws.push_back(std::move(drawing));
    }
    answers.stopped_at.reset();
    return true;
  }

  bool MayBeRefused(std::size_t r, std::size_t draw) const {
    const std::vector<std::size_t>& those = requests_[r].check->may_be_refused;
    return std::ranges::find(those, draw) != those.end();
  }

  CallEnd DrawInOrder(std::size_t r, const DrawQuestion& question, const DrawJob& job,
                      const Drawing* last, Drawing& drawing) {
    Subject& subject = question.by_twin ? *subject_.Twin() : subject_;
    const bool goes_on = question.onto_the_last && last != nullptr;
    CoverageCounts target = goes_on ? last->counts : Filled(question.fill, job);
    const bool has_target = goes_on || question.fill != 0;
    if (info_.coverage != CoverageKind::kFacingCounts &&
        (has_target || question.parts == Parts::kFacings)) {
      drawing.counts = std::move(target);
      return DrawFacings(subject, PartsOf(r, question, job), drawing.counts);
    }
    DrawJob onto = job;
    if (has_target) onto.onto = std::make_shared<const CoverageCounts>(std::move(target));
    DrawOutcome outcome = std::move(subject.DrawMany({&onto, 1}).front());
    drawing = std::move(outcome.drawing);
    return std::move(outcome.end);
  }

  void AddDestinations(std::size_t r) {
    const std::vector<DrawQuestion>& draws = requests_[r].check->questions.draws;
    for (std::size_t d = 0; d < draws.size(); ++d) {
      const std::optional<DrawJob> job = GivenOf(r, draws[d].job, not_given_[r]);
      if (!job) return;
      drawings_.push_back(std::make_shared<Drawing>());
      const bool is_added = draws[d].parts == Parts::kFacings || draws[d].fill != 0;
      if (is_added) drawings_.back()->counts = Filled(draws[d].fill, *job);
      for (FacingDraw& part : PartsOf(r, draws[d], *job)) {
        destinations_.push_back({r, drawings_.size() - 1, d, std::move(part), !is_added});
      }
      owners_.push_back(r);
    }
  }

  void DrawDestinations() {
    std::size_t first = 0;
    while (first < destinations_.size()) {
      const std::size_t last = EndOfCall(first);
      const std::size_t drawn = DrawCall(first, last);
      const std::size_t end = destinations_[first + (drawn == 0 ? 0 : drawn - 1)].request;
      if (first + drawn < last || EndsTheCall(answers_[end].end.stop)) {
        // Draws after a breakdown are left out: the case that caused it is judged first.
        answers_.resize(end + 1);
        break;
      }
      first = last;
    }
    for (std::size_t d = 0; d < drawings_.size(); ++d) {
      if (owners_[d] >= answers_.size()) break;
      Answers& answers = answers_[owners_[d]];
      if (answers.end.stop == Stop::kNone) answers.draws.push_back(std::move(drawings_[d]));
    }
  }

  // Shares that go in one call with the first, as many as fit.
  std::size_t EndOfCall(std::size_t first) const {
    const bool is_one_call =
        requests_[destinations_[first].request].check->questions.company == Company::kOneCallAlone;
    if (is_one_call) return destinations_.size();
    std::size_t size = 0;
    for (std::size_t n = first; n < destinations_.size(); ++n) {
      size += SizeInACall(destinations_[n].part.job);
      if (n > first && size > kMostInACall) return n;
    }
    return destinations_.size();
  }

  // Returns how many were drawn.
  std::size_t DrawCall(std::size_t first, std::size_t last) {
    std::vector<DrawJob> jobs;
    for (std::size_t n = first; n < last; ++n) jobs.push_back(destinations_[n].part.job);
    std::vector<DrawOutcome> outcomes = subject_.DrawMany(jobs);
    for (std::size_t n = 0; n < outcomes.size(); ++n) Take(destinations_[first + n], outcomes[n]);
    return outcomes.size();
  }

  void Take(const Destination& to, DrawOutcome& outcome) {
    Answers& answers = answers_[to.request];
    if (answers.end.stop != Stop::kNone) return;
    if (outcome.end.stop != Stop::kNone) {
      answers.end = std::move(outcome.end);
      answers.stopped_at = to.question;
      return;
    }
    Drawing& drawing = *drawings_[to.draw];
    if (to.is_whole) {
      drawing = std::move(outcome.drawing);
    } else {
      AddFacingDraw(to.part, info_.coverage, outcome.drawing.counts, drawing.counts);
    }
  }

  void Evaluate(const Questions& questions, Answers& answers) {
    answers.end = EndOf([&] {
      const EdgeEvaluator* const edges = subject_.Edges();
      if (!questions.edges.empty()) answers.edges = edges->Values(questions.edges);
      if (!questions.steps.empty()) answers.steps = edges->Steps(questions.steps);
      const BarycentricEvaluator* const barycentrics = subject_.Barycentrics();
      for (const BarycentricQuestion& q : questions.barycentrics) {
        answers.barycentrics.push_back(barycentrics->Barycentrics(q.form, q.v, q.p));
      }
      for (const InterpolationQuestion& q : questions.interpolations) {
        answers.interpolations.push_back(barycentrics->Interpolate(q.form, q.v, q.attribute, q.p));
      }
      for (const DistanceQuestion& q : questions.distances) {
        answers.distances.push_back(barycentrics->EdgeDistances(q.form, q.v, q.p));
      }
    });
  }

  Subject& subject_;
  const SubjectInfo& info_;
  bool is_outside_;
  std::span<const Request> requests_;
  std::vector<Answers> answers_;
  std::vector<CallEnd> not_given_;  ///< why, if a request has a draw that can't be given
  std::vector<Destination> destinations_;
  std::vector<std::shared_ptr<Drawing>> drawings_;
  std::vector<std::size_t> owners_;  ///< the request of each of them
};

}  // namespace

std::vector<Answers> Submit(Subject& subject, std::span<const Request> requests) {
  return Submission(subject, requests).All();
}

}  // namespace rasterproof::props
