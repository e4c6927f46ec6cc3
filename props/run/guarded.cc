#include "props/run/guarded.h"

#include <array>
#include <exception>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/subject_errors.h"

namespace rasterproof::props {
namespace {

// Throws again what is being handled, as the subject's fault unless it is a word of Subject's.
[[noreturn]] void ThrowAsItsFault() {
  try {
    throw;
  } catch (const InputError&) {
    throw;
  } catch (const SubjectFault&) {
    throw;
  } catch (const SubjectTooSlow&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw SubjectFault(std::string("it threw: ") + error.what());
  } catch (...) {
    throw SubjectFault("it threw something that is no std::exception");
  }
}

template <class Call>
auto Guard(const Call& call) {
  try {
    return call();
  } catch (...) {
    ThrowAsItsFault();
  }
}

std::exception_ptr AsItsFault(const std::exception_ptr& error) {
  try {
    Guard([&] { std::rethrow_exception(error); });
  } catch (...) {
    return std::current_exception();
  }
  return error;
}

}  // namespace

class GuardedSubject::GuardedEdges final : public EdgeEvaluator {
 public:
  explicit GuardedEdges(const EdgeEvaluator& edges) : edges_(edges) {}
  double Value(Point2 a, Point2 b, Point2 p) const override {
    return Guard([&] { return edges_.Value(a, b, p); });
  }
  double ErrorBound(Point2 a, Point2 b, Point2 p) const override {
    return Guard([&] { return edges_.ErrorBound(a, b, p); });
  }
  std::vector<double> Walk(Point2 a, Point2 b, Point2 p, Step step, int steps) const override {
    return Guard([&] { return edges_.Walk(a, b, p, step, steps); });
  }
  std::vector<double> WalkErrorBounds(Point2 a, Point2 b, Point2 p, Step step,
                                      int steps) const override {
    return Guard([&] { return edges_.WalkErrorBounds(a, b, p, step, steps); });
  }

 private:
  const EdgeEvaluator& edges_;
};

class GuardedSubject::GuardedWeights final : public WeightEvaluator {
 public:
  using Corners3 = std::array<Corner, 3>;
  using Points3 = std::array<Point2, 3>;
  using Numbers3 = std::array<double, 3>;

  explicit GuardedWeights(const WeightEvaluator& weights) : weights_(weights) {}
  Numbers3 Weights(BarycentricForm form, const Points3& v, Point2 p) const override {
    return Guard([&] { return weights_.Weights(form, v, p); });
  }
  Numbers3 WeightErrorBounds(BarycentricForm form, const Points3& v, Point2 p) const override {
    return Guard([&] { return weights_.WeightErrorBounds(form, v, p); });
  }
  double SumErrorBound(BarycentricForm form, const Points3& v, Point2 p) const override {
    return Guard([&] { return weights_.SumErrorBound(form, v, p); });
  }
  double Interpolate(InterpolationForm form, const Corners3& v, const Numbers3& attribute,
                     Point2 p) const override {
    return Guard([&] { return weights_.Interpolate(form, v, attribute, p); });
  }
  double InterpolationErrorBound(InterpolationForm form, const Corners3& v,
                                 const Numbers3& attribute, Point2 p) const override {
    return Guard([&] { return weights_.InterpolationErrorBound(form, v, attribute, p); });
  }
  Numbers3 EdgeDistances(WireframeForm form, const Points3& v, Point2 p) const override {
    return Guard([&] { return weights_.EdgeDistances(form, v, p); });
  }

 private:
  const WeightEvaluator& weights_;
};

GuardedSubject::GuardedSubject(Subject& subject) : subject_(subject) {
  if (subject_.Edges() != nullptr) edges_ = std::make_unique<GuardedEdges>(*subject_.Edges());
  if (subject_.Weights() != nullptr) {
    weights_ = std::make_unique<GuardedWeights>(*subject_.Weights());
  }
}

GuardedSubject::GuardedSubject(std::unique_ptr<Subject> subject) : GuardedSubject(*subject) {
  owned_ = std::move(subject);
}

GuardedSubject::~GuardedSubject() = default;

void GuardedSubject::Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
  Guard([&] { subject_.Draw(scene, options, counts); });
}

Drawing GuardedSubject::Show(const DrawJob& job) {
  return Guard([&] { return subject_.Show(job); });
}

std::vector<DrawOutcome> GuardedSubject::DrawMany(std::span<const DrawJob> jobs) {
  std::vector<DrawOutcome> outcomes = Guard([&] { return subject_.DrawMany(jobs); });
  for (DrawOutcome& outcome : outcomes) {
    if (outcome.error != nullptr) outcome.error = AsItsFault(outcome.error);
  }
  return outcomes;
}

Subject& GuardedSubject::Whole() {
  Subject& whole = subject_.Whole();
  if (&whole == &subject_) return *this;
  if (whole_ == nullptr) whole_ = std::make_unique<GuardedSubject>(whole);
  return *whole_;
}

void GuardedSubject::SetDeadline(std::chrono::steady_clock::time_point deadline) {
  subject_.SetDeadline(deadline);
}

const EdgeEvaluator* GuardedSubject::Edges() const { return edges_.get(); }

const WeightEvaluator* GuardedSubject::Weights() const { return weights_.get(); }

}  // namespace rasterproof::props
