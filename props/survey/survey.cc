#include "props/survey/survey.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

#include "core/coverage.h"
#include "core/question.h"
#include "core/subject_info.h"
#include "props/domains/domain.h"
#include "props/infer/observer.h"
#include "props/judging/gate.h"
#include "props/judging/redraw.h"
#include "props/placed_case.h"
#include "props/run/description.h"
#include "props/run/property_domains.h"
#include "props/run/submit.h"
#include "props/shrink/shrink.h"

namespace rasterproof::props {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint64_t kMostStops = 4;  // of one domain: each costs a process or a time limit

// Plain domains, those near an edge, those near the limits, and meshes.
constexpr auto kSurveyed = std::to_array<SurveyedDomain>({{"uniform-subpixel"},
                                                          {"vertices-on-samples"},
                                                          {"near-edge"},
                                                          {"snap-ties"},
                                                          {"degenerate"},
                                                          {"axis-aligned"},
                                                          {"long-rows"},
                                                          {"mixed-magnitude", true},
                                                          {"far-negative-corners", true},
                                                          {"range-ends", true},
                                                          {"fans"},
                                                          {"grids"},
                                                          {"triangulations"},
                                                          {"subdivisions"},
                                                          {"covering-fans", true}});

// The profile says something of the case, and the oracle decides it.
constexpr Gate kCompared{
    .space = Space::kEither, .judges_shared_edge_samples = true, .asks_oracle = true};

double Since(Clock::time_point began) {
  return std::chrono::duration<double>(Clock::now() - began).count();
}

// What came of one case.
struct Look {
  bool is_judged = false;
  CallEnd end;
  CoverageCounts counts;  ///< all in front
  bool batch_differs = false;
  double whole_seconds = 0;
  double alone_seconds = 0;

  bool IsWhole() const { return is_judged && end.stop == Stop::kNone; }
  bool Ended() const { return IsBreakdown(end.stop); }
};

class Looker {
 public:
  Looker(Subject& subject, const Profile& model)
      : subject_(subject), description_(DescriptionOf(subject)) {
    description_.info.profile = model;
  }

  /// The case as it is judged, and what the subject draws of it.
  std::pair<PlacedCase, Look> At(const Case& given) {
    PlacedCase c = Place(given, false);
    Look look;
    const Description& subject = c.before ? AsJudged(description_) : description_;
    look.is_judged = !FlatnessNotDecided(c, false) && !Refusal(kCompared, subject, c);
    if (look.is_judged) Draw(c, look);
    return {std::move(c), std::move(look)};
  }

 private:
  std::vector<CoverageCounts> Submit(const PlacedCase& c, const Check& check, Look& look,
                                     double& seconds) {
    const Request request{&c, &check, nullptr};
    const Clock::time_point began = Clock::now();
    Answers answers = std::move(props::Submit(subject_, {&request, 1}).front());
    seconds += Since(began);
    look.end = std::move(answers.end);
    std::vector<CoverageCounts> drawn;
    for (const auto& drawing : answers.draws) {
      drawn.push_back(drawing->counts);
      JoinFacings(drawn.back());
    }
    return drawn;
  }

  // In one call, and once more triangle by triangle. Who shows no counts shows overlaps only so.
  void Draw(const PlacedCase& c, Look& look) {
    const DrawQuestion whole = WholeCallOf(c.scene, c.profile, c.options);
    Check check;
    check.questions.draws = {whole};
    std::vector<CoverageCounts> drawn = Submit(c, check, look, look.whole_seconds);
    if (look.end.stop != Stop::kNone) return;
    look.counts = std::move(drawn.front());
    if (c.scene.triangles.size() < 2) return;
    check.questions.draws.assign(c.scene.triangles.size(), whole);
    for (std::size_t t = 0; t < c.scene.triangles.size(); ++t) {
      check.questions.draws[t].job.triangles = {c.scene.triangles[t]};
    }
    drawn = Submit(c, check, look, look.alone_seconds);
    if (look.end.stop != Stop::kNone) return;
    CoverageCounts sum(c.scene.width, c.scene.height, look.counts.samples);
    for (const CoverageCounts& one : drawn) sum += one;
    const CoverageKind kind = description_.info.coverage;
    if (kind == CoverageKind::kFacingCounts || kind == CoverageKind::kCounts) {
      look.batch_differs = look.counts != sum;
      return;
    }
    const auto shown = [](std::uint32_t count) { return std::min(count, 1U); };
    look.batch_differs = !std::ranges::equal(look.counts.front, sum.front, {}, {}, shown);
    look.counts = std::move(sum);
  }

  Subject& subject_;
  Description description_;
};

CoverageCounts Expected(const PlacedCase& c, const TieRule& rule) {
  CoverageCounts counts = CoverageUnder(c, rule, c.options);
  JoinFacings(counts);
  return counts;
}

// What of a covering mesh is to be 1 everywhere. Rules that give a sample to both sides of an edge,
// or to neither, have no such meshes.
TieRule OneSidedRule(const Profile& model) {
  return model.tie_rule.IsConsistent() ? model.tie_rule : kTopLeft;
}

struct Differences {
  std::uint64_t wrong = 0;
  std::uint64_t gaps = 0;
  std::uint64_t overlaps = 0;
  bool is_mesh = false;
};

Differences Compared(const PlacedCase& c, const CoverageCounts& observed) {
  Differences found;
  const CoverageCounts expected = Expected(c, c.profile.tie_rule);
  const bool has_edges = c.scene.triangles.size() > 1;
  const TieRule rule = OneSidedRule(c.profile);
  const CoverageCounts once =
      has_edges && rule != c.profile.tie_rule ? Expected(c, rule) : expected;
  found.is_mesh =
      has_edges && std::ranges::all_of(once.front, [](std::uint32_t count) { return count == 1; });
  for (std::size_t k = 0; k < expected.size(); ++k) {
    const std::uint32_t count = observed.front[k];
    found.wrong += count != expected.front[k] ? 1U : 0U;
    found.gaps += found.is_mesh && count == 0 ? 1U : 0U;
    found.overlaps += found.is_mesh && count > 1 ? 1U : 0U;
  }
  return found;
}

// Whether the real triangles cover sample s of the pixel and of its eight neighbours once.
bool IsDeepInside(const CoverageCounts& real, int i, int row, int s) {
  for (int y = row - 1; y <= row + 1; ++y) {
    for (int x = i - 1; x <= i + 1; ++x) {
      if (real.front[real.Index(x, y, s)] != 1) return false;
    }
  }
  return true;
}

// A gap or an overlap, asked so that a smaller scene can be asked it too: of a sample deep inside
// that the model covers once, whether or not the mesh covers its target.
bool HasSeam(const PlacedCase& c, const CoverageCounts& observed, Fault fault) {
  const CoverageCounts once = Expected(c, OneSidedRule(c.profile));
  Case unsnapped = c.Value();
  unsnapped.profile.snap = {};
  const CoverageCounts real = Expected(PlacedCase(unsnapped), kTopLeft);
  for (int row = 1; row + 1 < once.height; ++row) {
    for (int i = 1; i + 1 < once.width; ++i) {
      for (int s = 0; s < once.samples; ++s) {
        const std::size_t k = once.Index(i, row, s);
        const bool is_fault = fault == Fault::kGap ? observed.front[k] == 0 : observed.front[k] > 1;
        if (is_fault && once.front[k] == 1 && IsDeepInside(real, i, row, s)) return true;
      }
    }
  }
  return false;
}

bool Shows(Looker& looker, const Case& candidate, Fault fault) {
  const auto [c, look] = looker.At(candidate);
  if (fault == Fault::kEnd) return look.Ended();
  if (!look.IsWhole()) return false;
  if (fault == Fault::kBatch) return look.batch_differs;
  if (fault == Fault::kWrong) return Compared(c, look.counts).wrong != 0;
  return HasSeam(c, look.counts, fault);
}

Finding Shrunk(Subject& subject, Fault fault, const Case& failing, const SurveyPlan& options) {
  Looker looker(subject, options.model);
  const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                      std::chrono::duration<double>(options.shrink_seconds));
  subject.SetDeadline(end);
  const auto fails = [&](const Case& candidate) {
    const bool is_stopped = Clock::now() >= end || (options.stop && options.stop());
    return !is_stopped && Shows(looker, candidate, fault);
  };
  Finding finding{fault, failing.origin, failing, ""};
  if (fails(failing)) finding.minimal = Shrink(failing, fails, options.shrink_budget).minimal;
  subject.SetDeadline(Clock::time_point::max());
  return finding;
}

class Surveying {
 public:
  Surveying(Subject& subject, const Domain& domain, const SurveyPlan& options)
      : subject_(subject), options_(options), looker_(subject, options.model), domain_(domain) {
    survey_.domain = domain.name;
  }

  DomainSurvey Run() {
    const Clock::time_point began = Clock::now();
    if (!Suits(domain_, subject_.Info())) return std::move(survey_);
    for (std::uint64_t index = 0; index < options_.cases && !IsOver(Since(began)); ++index) {
      Case c = DrawCase(subject_.Info(), {std::string(domain_.name), index, options_.seed});
      c.profile = options_.model;
      Take(c);
      if (options_.progress) options_.progress(index + 1);
    }
    survey_.seconds = Since(began);
    for (std::size_t k = 0; k < first_.size(); ++k) {
      if (first_[k]) survey_.findings.push_back(FindingOf(static_cast<Fault>(k), *first_[k]));
    }
    return std::move(survey_);
  }

 private:
  bool IsOver(double seconds) const {
    return stops_ >= kMostStops || (options_.seconds > 0 && seconds >= options_.seconds) ||
           (options_.stop && options_.stop());
  }

  void Take(const Case& given) {
    const auto [c, look] = looker_.At(given);
    survey_.subject_seconds += look.whole_seconds;
    survey_.alone_seconds += look.alone_seconds;
    if (look.IsWhole()) return Count(given, c, look);
    if (look.Ended()) {
      if (survey_.Faulty(Fault::kEnd) == 0) end_ = look.end.why;
      hung_ = hung_ || look.end.stop == Stop::kHung;
      Note(Fault::kEnd, given);
    }
    const bool is_limited = IsALimit(look.end.stop);
    stops_ += look.Ended() || is_limited ? 1 : 0;
    survey_.refused += look.end.stop == Stop::kRefused ? 1 : 0;
    const bool is_unjudged = !look.is_judged || is_limited || look.end.stop == Stop::kNotDrawable;
    survey_.unjudged += is_unjudged ? 1 : 0;
  }

  void Count(const Case& given, const PlacedCase& c, const Look& look) {
    const Differences found = Compared(c, look.counts);
    ++survey_.cases;
    survey_.meshes += found.is_mesh ? 1 : 0;
    survey_.triangles += c.scene.triangles.size();
    survey_.samples += look.counts.size();
    survey_.wrong += found.wrong;
    survey_.gaps += found.gaps;
    survey_.overlaps += found.overlaps;
    if (found.wrong != 0) Note(Fault::kWrong, given);
    if (found.gaps != 0) Note(Fault::kGap, given);
    if (found.overlaps != 0) Note(Fault::kOverlap, given);
    if (look.batch_differs) Note(Fault::kBatch, given);
  }

  void Note(Fault fault, const Case& c) {
    const auto k = static_cast<std::size_t>(fault);
    if (survey_.faulty[k]++ == 0) first_[k] = c;
  }

  // What hung would hang again, each time for a whole time limit.
  Finding FindingOf(Fault fault, const Case& failing) {
    if (fault != Fault::kEnd) return Shrunk(subject_, fault, failing, options_);
    Finding finding{fault, failing.origin, failing, ""};
    if (!hung_) finding = Shrunk(subject_, fault, failing, options_);
    finding.end = end_;
    return finding;
  }

  Subject& subject_;
  const SurveyPlan& options_;
  Looker looker_;
  const Domain& domain_;
  DomainSurvey survey_;
  std::array<std::optional<Case>, kFaultNames.size()> first_;
  std::uint64_t stops_ = 0;
  std::string end_;
  bool hung_ = false;
};

}  // namespace

std::span<const SurveyedDomain> SurveyedDomains() { return kSurveyed; }

DomainSurvey SurveyDomain(Subject& subject, std::string_view name, const SurveyPlan& options) {
  const Domain& domain = *FindDomain(name);
  return Surveying(subject, domain, options).Run();
}

}  // namespace rasterproof::props
