#include "props/run/look_ahead.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <future>
#include <memory>
#include <utility>

#include "props/run/judge.h"
#include "props/run/judged_case.h"
#include "props/run/put.h"

namespace rasterproof::props {
namespace {

// Behind these outcomes no case of the batch counts.
bool EndsTheBatch(Outcome outcome) {
  return outcome == Outcome::kViolated || outcome == Outcome::kInconclusive;
}

bool BrokeDown(const std::vector<Answers>& answers) {
  return std::ranges::any_of(answers, [](const Answers& each) {
    return each.stop != Stop::kNone && each.stop != Stop::kRefused && each.stop != Stop::kCantBePut;
  });
}

// Every other turn one half of the cases is drawn while the other is judged.
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
    const std::size_t half = cases_.size() / 2;
    const std::array<std::pair<std::size_t, std::size_t>, 2> halves{
        {{0, half}, {half, cases_.size()}}};
    Begin(halves[0]);
    std::size_t turn = 0;
    InFlight drawing = Launch(halves[0]);
    Begin(halves[1]);
    while (!is_stopped_) {
      const std::vector<Answers> answers = drawing.Wait();
      // Behind a breakdown most draws would be in vain, and might each cost a time limit.
      const bool judges_first = BrokeDown(answers);
      if (judges_first) Judge(drawing.asked, answers);
      InFlight next = Launch(halves[(turn + 1) % 2]);
      if (!judges_first) Judge(drawing.asked, answers);
      const bool is_done = next.asked.empty();
      drawing = is_done ? Launch(halves[turn % 2]) : std::move(next);
      if (is_done && drawing.asked.empty()) break;
      if (!is_done) ++turn;
    }
    drawing.Wait();
    return Done();
  }

 private:
  // What is being drawn.
  struct InFlight {
    std::vector<std::size_t> asked;
    std::future<std::vector<Answers>> answers;

    std::vector<Answers> Wait() { return answers.valid() ? answers.get() : std::vector<Answers>(); }
  };

  bool IsStopped() {
    is_stopped_ = is_stopped_ || (stop_ && stop_());
    return is_stopped_;
  }

  void Begin(std::pair<std::size_t, std::size_t> part) {
    for (std::size_t k = part.first; k < std::min(part.second, end_) && !IsStopped(); ++k) {
      hands_[k] = std::make_unique<CaseInHand>(property_, cases_[k], description_);
      NoteEnd(k);
    }
  }

  InFlight Launch(std::pair<std::size_t, std::size_t> part) {
    InFlight drawing;
    std::vector<Request> requests;
    for (std::size_t k = part.first; k < std::min(part.second, end_) && !IsStopped(); ++k) {
      if (hands_[k] == nullptr || hands_[k]->IsDone()) continue;
      drawing.asked.push_back(k);
      requests.push_back(hands_[k]->Next());
    }
    if (requests.empty()) return drawing;
    drawing.answers = std::async(std::launch::async, [this, requests = std::move(requests)] {
      return Put(subject_, requests);
    });
    return drawing;
  }

  void Judge(const std::vector<std::size_t>& asked, const std::vector<Answers>& answers) {
    for (std::size_t n = 0; n < answers.size(); ++n) {
      if (asked[n] >= end_ || IsStopped()) return;
      hands_[asked[n]]->Take(answers[n]);
      NoteEnd(asked[n]);
    }
  }

  void NoteEnd(std::size_t k) {
    const CaseInHand& hand = *hands_[k];
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
  std::vector<std::unique_ptr<CaseInHand>> hands_;
  std::size_t end_;  ///< behind the case that ends the batch
  bool is_stopped_ = false;
};

}  // namespace

std::vector<Trial> TryTogether(Subject& subject, const Property& property,
                               std::span<const Case> cases, const std::function<bool()>& stop) {
  return WorkedOut(PlaceOfFault(property, cases),
                   [&] { return Together(subject, property, cases, stop).Run(); });
}

}  // namespace rasterproof::props
