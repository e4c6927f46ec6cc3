#include "props/run/look_ahead.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>

#include "props/run/description.h"
#include "props/run/judge.h"
#include "props/run/submit.h"

namespace rasterproof::props {
namespace {

// Cases after one of these outcomes are discarded.
bool EndsTheBatch(Outcome outcome) {
  return outcome == Outcome::kViolated || outcome == Outcome::kInconclusive;
}

// Draws the next check of every case in one call, judges them, and so on.
class Together {
 public:
  Together(Subject& subject, const Property& property, std::span<const Case> cases,
           const std::function<bool()>& stop)
      : subject_(subject),
        property_(property),
        cases_(cases),
        stop_(stop),
        description_(DescriptionOf(subject)),
        hands_(cases.size()),
        end_(cases.size()) {}

  std::vector<Trial> Run() {
    Begin();
    while (DrawAndJudge()) {
    }
    return Done();
  }

 private:
  bool IsStopped() {
    is_stopped_ = is_stopped_ || (stop_ && stop_());
    return is_stopped_;
  }

  void Begin() {
    for (std::size_t k = 0; k < end_ && !IsStopped(); ++k) {
      hands_[k] = std::make_unique<CaseJudge>(property_, cases_[k], description_);
      NoteEnd(k);
    }
  }

  // Returns whether anything was left to draw.
  bool DrawAndJudge() {
    std::vector<std::size_t> asked;
    std::vector<Request> requests;
    for (std::size_t k = 0; k < end_ && !IsStopped(); ++k) {
      if (hands_[k] == nullptr || hands_[k]->IsDone()) continue;
      asked.push_back(k);
      requests.push_back(hands_[k]->Next());
    }
    if (requests.empty() || is_stopped_) return false;
    // There are fewer answers if the subject broke down: later requests are asked again, unless
    // the breakdown ends the batch.
    const std::vector<Answers> answers = Submit(subject_, requests);
    for (std::size_t n = 0; n < answers.size() && asked[n] < end_ && !IsStopped(); ++n) {
      hands_[asked[n]]->Take(answers[n]);
      NoteEnd(asked[n]);
    }
    return !is_stopped_;
  }

  void NoteEnd(std::size_t k) {
    const CaseJudge& hand = *hands_[k];
    if (hand.IsDone() && EndsTheBatch(hand.Result().verdict.outcome)) end_ = std::min(end_, k + 1);
  }

  std::vector<Trial> Done() {
    std::vector<Trial> done;
    for (std::size_t k = 0; k < end_ && hands_[k] != nullptr && hands_[k]->IsDone(); ++k) {
      done.push_back(hands_[k]->Result());
    }
    return done;
  }

  Subject& subject_;
  const Property& property_;
  std::span<const Case> cases_;
  const std::function<bool()>& stop_;
  Description description_;
  std::vector<std::unique_ptr<CaseJudge>> hands_;
  std::size_t end_;  ///< one past the case that ends the batch
  bool is_stopped_ = false;
};

}  // namespace

std::vector<Trial> TryTogether(Subject& subject, const Property& property,
                               std::span<const Case> cases, const std::function<bool()>& stop) {
  return WorkedOut(PlaceOfFault(property, cases),
                   [&] { return Together(subject, property, cases, stop).Run(); });
}

}  // namespace rasterproof::props
