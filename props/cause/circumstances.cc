// What must be so for a draw to be wrong.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "props/cause/cause.h"
#include "props/cause/suspect.h"
#include "props/judging/redraw.h"
#include "props/run/submit.h"

namespace rasterproof::props {
namespace {

// Whether the subject answers as the stated model does; nothing if either gives no answer.
std::optional<bool> IsRight(Subject& subject, Subject& stated, const PlacedCase& placed,
                            Questions questions) {
  const Observation asked{Observation::kAround, nullptr, {std::move(questions), {}, {}}};
  const Request request{&placed, &asked.check, nullptr};
  Answers answers = std::move(Submit(subject, {&request, 1}).front());
  if (answers.end.stop != Stop::kNone) return std::nullopt;
  const bool is_answered = std::move(Submit(stated, {&request, 1}).front()).end.stop == Stop::kNone;
  if (!is_answered) return std::nullopt;
  Observation seen = asked;
  seen.placed = std::make_shared<const PlacedCase>(placed);
  seen.seen = std::move(answers.draws);
  return Reproduces(stated, seen);
}

// A change of a check's questions. Returns false if it changes nothing.
struct Toggle {
  std::string_view name;
  std::string_view what;
  bool (*change)(Questions&);
  /// Before it is tried, the draw is asked for by itself, without the draws of its check.
  bool asks_by_itself_first = false;
};

template <class Change>
bool Each(Questions& questions, const Change& change) {
  bool is_changed = false;
  for (DrawQuestion& draw : questions.draws) is_changed |= change(draw);
  return is_changed;
}

constexpr auto kToggles = std::to_array<Toggle>({
    {"target-contents", "on a target that holds nothing yet",
     [](Questions& q) {
       return Each(q, [](DrawQuestion& d) {
         const bool fills = std::exchange(d.fill, 0U) != 0;
         return std::exchange(d.onto_the_last, false) || fills;
       });
     }},
    {"scissor", "without the scissor",
     [](Questions& q) {
       return Each(q, [](DrawQuestion& d) {
         return std::exchange(d.job.options.scissor, std::nullopt).has_value();
       });
     },
     true},
    {"culling", "where nothing is culled",
     [](Questions& q) {
       return Each(q, [](DrawQuestion& d) {
         return std::exchange(d.job.options.cull, Cull::kNone) != Cull::kNone;
       });
     }},
    {"threads", "with one thread",
     [](Questions& q) {
       return Each(q, [](DrawQuestion& d) { return std::exchange(d.job.options.threads, 1) > 1; });
     }},
    {"tile-size", "where the size of tiles is left to the subject",
     [](Questions& q) {
       return Each(q, [](DrawQuestion& d) { return std::exchange(d.job.options.tile, 0) != 0; });
     }},
});

// A draw as a scene of its own.
Questions Alone(const DrawQuestion& question, std::optional<std::size_t> triangle) {
  DrawQuestion alone = question;
  alone.onto_the_last = false;
  alone.by_twin = false;
  Scene scene = SceneOf(question.job);
  if (triangle) scene.triangles = {scene.triangles[*triangle]};
  alone.job.scene = std::make_shared<const Scene>(std::move(scene));
  alone.job.triangles.reset();
  Questions questions;
  questions.draws = {std::move(alone)};
  return questions;
}

using Asks = std::function<std::optional<bool>(const Observation&)>;

class Toggling {
 public:
  Toggling(const MakesSubject& make, const SubjectInfo& info)
      : make_(make), stated_(MakeSuspect(info, {})) {}

  // The same draws once more, by a subject that has drawn nothing else.
  std::optional<bool> Again(const Observation& o) {
    const std::unique_ptr<Subject> fresh = make_();
    return IsRight(*fresh, *stated_, *o.placed, o.check.questions);
  }

  // Whether the same question has different answers, each of a subject that has drawn nothing else.
  bool IsAnsweredByChance(const Observation& o) {
    constexpr int kTries = 4;
    std::optional<Seen> first;
    for (int k = 0; k < kTries; ++k) {
      const std::unique_ptr<Subject> fresh = make_();
      Seen now = DrawnBy(*fresh, o);
      if (now.size() != o.seen.size()) return false;  // it gave no answer
      if (!first)
        first = std::move(now);
      else if (!AreAlike(*first, now))
        return true;
    }
    return false;
  }

  // Whether the wrong answer comes again when all that was asked before it is asked again.
  bool ComesAgainAfter(std::span<const Observation> all, const Observation& o) {
    std::vector<const Observation*> before;
    for (const Observation& other : all) {
      if (other.place < o.place) before.push_back(&other);
    }
    std::ranges::sort(before, {}, &Observation::place);
    const std::unique_ptr<Subject> fresh = make_();
    for (const Observation* other : before) {
      const Request request{other->placed.get(), &other->check, &other->bases};
      if (EndsTheCall(Submit(*fresh, {&request, 1}).front().end.stop)) return false;
    }
    return Reproduces(*fresh, o);
  }

  // Every draw by itself, by a subject that has drawn nothing else.
  std::optional<bool> ByItself(const Observation& o) {
    if (o.check.questions.draws.size() > 16) return std::nullopt;
    for (const DrawQuestion& draw : o.check.questions.draws) {
      const std::unique_ptr<Subject> fresh = make_();
      const auto right = IsRight(*fresh, *stated_, *o.placed, Alone(draw, std::nullopt));
      if (right != true) return right;
    }
    return true;
  }

  // Each triangle of each draw by itself.
  std::optional<bool> ByTriangles(const Observation& o) {
    const std::unique_ptr<Subject> fresh = make_();
    bool is_list = false;
    for (const DrawQuestion& draw : o.check.questions.draws) {
      const std::size_t count = draw.job.Triangles().size();
      is_list |= count > 1;
      for (std::size_t t = 0; t < std::min<std::size_t>(count, 64); ++t) {
        const auto right = IsRight(*fresh, *stated_, *o.placed, Alone(draw, t));
        if (right != true) return right;
      }
    }
    return is_list;
  }

  std::optional<bool> With(const Toggle& toggle, const Observation& o) {
    Questions changed = o.check.questions;
    if (!toggle.change(changed)) return false;
    const std::unique_ptr<Subject> fresh = make_();
    return IsRight(*fresh, *stated_, *o.placed, std::move(changed));
  }

 private:
  const MakesSubject& make_;
  std::unique_ptr<Subject> stated_;
};

bool AllRight(std::span<const Observation* const> wrong, const Asks& asks) {
  bool some = false;
  for (const Observation* o : wrong) {
    const std::optional<bool> right = asks(*o);
    if (right == false) return false;
    some |= right.has_value();
  }
  return some;
}

}  // namespace

Circumstance FindCircumstance(const MakesSubject& make, std::span<const Observation* const> wrong,
                              std::span<const Observation> all) {
  constexpr std::size_t kMostTried = 6;
  constexpr std::size_t kMostRepeated = 2;
  const auto tried = wrong.first(std::min(kMostTried, wrong.size()));
  Toggling toggling(make, make()->Info());
  const Toggle& one_thread = *std::ranges::find(kToggles, "threads", &Toggle::name);
  const auto with = [&](const Toggle& toggle) {
    return AllRight(tried, [&](const Observation& o) { return toggling.With(toggle, o); });
  };
  const Circumstance by_chance{"not-repeatable",
                               "or wrong by chance: equal questions have different answers"};
  if (std::ranges::any_of(tried,
                          [&](const Observation* o) { return toggling.IsAnsweredByChance(*o); })) {
    return with(one_thread) ? Circumstance{"threads", std::string(one_thread.what)} : by_chance;
  }
  // Right alone is not enough: what came before, a refusal apart, must make it wrong again.
  const auto after_others = [&]() -> Circumstance {
    const bool comes_again = std::ranges::all_of(
        tried.first(std::min(kMostRepeated, tried.size())),
        [&](const Observation* o) { return toggling.ComesAgainAfter(all, *o); });
    if (!comes_again) return {};
    return {"earlier-draws", "if no other draw comes before it"};
  };
  if (AllRight(tried, [&](const Observation& o) { return toggling.Again(o); }))
    return after_others();
  for (const Toggle& toggle : kToggles) {
    if (toggle.asks_by_itself_first &&
        AllRight(tried, [&](const Observation& o) { return toggling.ByItself(o); })) {
      return after_others();
    }
    if (with(toggle)) return {std::string(toggle.name), std::string(toggle.what)};
  }
  if (AllRight(tried, [&](const Observation& o) { return toggling.ByTriangles(o); })) {
    return {"list", "if each triangle is drawn alone"};
  }
  return {};
}

}  // namespace rasterproof::props
