#include "props/compare/survey.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <utility>

#include "core/coverage.h"
#include "core/question.h"
#include "core/subject_info.h"
#include "props/compare/compare.h"
#include "props/compare/yardsticks.h"
#include "props/domains/domain.h"
#include "props/infer/observer.h"
#include "props/judging/gate.h"
#include "props/judging/redraw.h"
#include "props/placed_case.h"
#include "props/run/description.h"
#include "props/run/property_domains.h"
#include "props/shrink/shrink.h"

namespace rasterproof::props {
namespace {

using Clock = std::chrono::steady_clock;

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

CoverageCounts Expected(const PlacedCase& c, const TieRule& rule) {
  CoverageCounts counts = CoverageUnder(c, rule, c.options);
  JoinFacings(counts);
  return counts;
}

// The rule under which a covering mesh counts 1 everywhere. Rules that give a sample to both sides
// of an edge, or to neither, have no such meshes.
TieRule OneSidedRule(const Profile& model) {
  return model.tie_rule.IsConsistent() ? model.tie_rule : kTopLeft;
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

// The samples at which the test holds.
template <class Test>
Reading WrongAt(const CoverageCounts& counts, Test is_wrong) {
  Reading reading;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    if (is_wrong(k)) reading.wrong.push_back(k);
  }
  return reading;
}

// A subject's draws, and the yardsticks by which they are read: a row's yardstick a fault.
class Surveyor {
 public:
  Surveyor(Subject& subject, const Profile& model)
      : subject_(subject), description_(DescriptionOf(subject)) {
    description_.info.profile = model;
    const CoverageKind kind = description_.info.coverage;
    shows_counts_ = kind == CoverageKind::kFacingCounts || kind == CoverageKind::kCounts;
  }

  double whole_seconds = 0;
  double alone_seconds = 0;
  std::uint64_t triangles = 0;  ///< of cases that were drawn whole

  /// In the order of Fault. The model's yardstick comes before those of meshes.
  std::vector<Yardstick> Yardsticks() {
    return {[this](const CaseAtHand& at) { return ByModel(at); },
            [this](const CaseAtHand& at) { return ByMesh(at, Fault::kGap); },
            [this](const CaseAtHand& at) { return ByMesh(at, Fault::kOverlap); },
            [this](const CaseAtHand& at) { return ByItsTriangles(at); }};
  }

  /// By which a smaller case shows the fault, too.
  Yardstick YardstickOf(Fault fault) {
    return [this, fault](const CaseAtHand& at) {
      if (fault == Fault::kBatch) return ByItsTriangles(at);
      const bool is_seam = fault == Fault::kGap || fault == Fault::kOverlap;
      return is_seam ? BySeam(at, fault) : ByModel(at);
    };
  }

  // In one call, and once more triangle by triangle. Who shows no counts shows overlaps only so.
  Drawn Draw(const PlacedCase& c) {
    const DrawQuestion whole = WholeCallOf(c.scene, c.profile, c.options);
    Drawn drawn;
    std::vector<CoverageCounts> counts = DrawTimed(c, {whole}, drawn.end, whole_seconds);
    if (drawn.end.stop != Stop::kNone) return drawn;
    Drawing drawing;
    drawing.counts = std::move(counts.front());
    if (c.scene.triangles.size() >= 2) {
      std::vector<DrawQuestion> each(c.scene.triangles.size(), whole);
      for (std::size_t t = 0; t < each.size(); ++t) {
        each[t].job.triangles = {c.scene.triangles[t]};
      }
      counts = DrawTimed(c, std::move(each), drawn.end, alone_seconds);
      if (drawn.end.stop != Stop::kNone) return drawn;
      CoverageCounts sum(c.scene.width, c.scene.height, drawing.counts.samples);
      for (const CoverageCounts& one : counts) sum += one;
      drawn.alone = std::make_shared<const CoverageCounts>(std::move(sum));
    }
    drawn.drawing = std::make_shared<const Drawing>(std::move(drawing));
    triangles += c.scene.triangles.size();
    return drawn;
  }

 private:
  std::string WhyNot(const CaseAtHand& at) const {
    return WhyNotCompared(kCompared, at.placed().before ? AsJudged(description_) : description_,
                          at.placed());
  }

  std::vector<CoverageCounts> DrawTimed(const PlacedCase& c, std::vector<DrawQuestion> draws,
                                        CallEnd& end, double& seconds) {
    const Clock::time_point began = Clock::now();
    Answers answers = AnswersTo(subject_, c, std::move(draws));
    seconds += Since(began);
    end = std::move(answers.end);
    std::vector<CoverageCounts> drawn;
    for (const auto& drawing : answers.draws) {
      drawn.push_back(drawing->counts);
      JoinFacings(drawn.back());
    }
    return drawn;
  }

  const CoverageCounts& Shown(const Drawn& drawn) const {
    return shows_counts_ || drawn.alone == nullptr ? drawn.drawing->counts : *drawn.alone;
  }

  Judging ByModel(const CaseAtHand& at) {
    why_not_ = WhyNot(at);
    if (!why_not_.empty()) return {why_not_};
    expected_ = Expected(at.placed(), at.placed().profile.tie_rule);
    return {"", [this](const Drawn& drawn) {
              const CoverageCounts& shown = Shown(drawn);
              return WrongAt(shown,
                             [&](std::size_t k) { return shown.front[k] != expected_.front[k]; });
            }};
  }

  bool IsMesh(const PlacedCase& c) const {
    if (c.scene.triangles.size() < 2) return false;
    const TieRule rule = OneSidedRule(c.profile);
    const auto is_one = [](std::uint32_t count) { return count == 1; };
    return std::ranges::all_of((rule == c.profile.tie_rule ? expected_ : Expected(c, rule)).front,
                               is_one);
  }

  Judging ByMesh(const CaseAtHand& at, Fault fault) {
    if (why_not_.empty() && fault == Fault::kGap && !IsMesh(at.placed())) why_not_ = "no mesh";
    if (!why_not_.empty()) return {why_not_};
    return {"", [this, fault](const Drawn& drawn) {
              const CoverageCounts& shown = Shown(drawn);
              return WrongAt(shown, [&](std::size_t k) {
                return fault == Fault::kGap ? shown.front[k] == 0 : shown.front[k] > 1;
              });
            }};
  }

  // One call with all triangles is to be the sum of calls with each.
  Judging ByItsTriangles(const CaseAtHand& at) const {
    if (std::string why = WhyNot(at); !why.empty()) return {std::move(why)};
    return {"", [this](const Drawn& drawn) -> Reading {
              if (drawn.alone == nullptr) return {};
              const CoverageCounts& whole = drawn.drawing->counts;
              const auto shown = [this](std::uint32_t count) {
                return shows_counts_ ? count : std::min(count, 1U);
              };
              return WrongAt(whole, [&](std::size_t k) {
                return shown(whole.front[k]) != shown(drawn.alone->front[k]);
              });
            }};
  }

  Judging BySeam(const CaseAtHand& at, Fault fault) const {
    if (std::string why = WhyNot(at); !why.empty()) return {std::move(why)};
    return {"", [this, &at, fault](const Drawn& drawn) {
              const bool has_seam = HasSeam(at.placed(), Shown(drawn), fault);
              return Reading{.wrong = std::vector<std::size_t>(has_seam ? 1 : 0)};
            }};
  }

  Subject& subject_;
  Description description_;
  bool shows_counts_ = false;
  // Of the case at hand: the model's yardstick works them out for gaps and overlaps.
  std::string why_not_;
  CoverageCounts expected_;
};

bool Shows(Surveyor& surveyor, const Case& candidate, Fault fault) {
  const Row row{.cases = 1,
                .at = [&](std::uint64_t) { return candidate; },
                .draw = [&](const CaseAtHand& at) { return surveyor.Draw(at.placed()); }};
  const Cell cell = CompareRow(row, {{surveyor.YardstickOf(fault)}}).front();
  return fault == Fault::kEnd ? cell.ended != 0 : cell.wrong > cell.ended;
}

FaultyCase Shrunk(Subject& subject, Fault fault, const Case& failing, const SurveyPlan& options) {
  Surveyor surveyor(subject, options.model);
  const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                      std::chrono::duration<double>(options.shrink_seconds));
  subject.SetDeadline(end);
  const auto fails = [&](const Case& candidate) {
    const bool is_stopped = Clock::now() >= end || (options.limits.stop && options.limits.stop());
    return !is_stopped && Shows(surveyor, candidate, fault);
  };
  FaultyCase finding{fault, failing.origin, failing, ""};
  if (fails(failing)) finding.minimal = Shrink(failing, fails, options.shrink_budget).minimal;
  subject.SetDeadline(Clock::time_point::max());
  return finding;
}

// What the cells count, in the order of Fault.
void Count(const std::vector<Cell>& cells, DomainSurvey& survey) {
  const Cell& model = cells[0];
  const Cell& gaps = cells[1];
  survey.cases = model.cases - model.ended;
  survey.refused = model.refused;
  survey.unjudged = model.excused - model.refused;
  survey.meshes = gaps.cases - gaps.ended;
  survey.samples = model.samples;
  survey.wrong = model.wrong_samples;
  survey.gaps = gaps.wrong_samples;
  survey.overlaps = cells[2].wrong_samples;
  for (std::size_t k = 0; k < cells.size(); ++k) survey.faulty[k] = cells[k].wrong - cells[k].ended;
  survey.faulty.back() = model.ended;
}

// What hung would hang again, each time for a whole time limit.
void AddFindings(Subject& subject, const std::vector<Cell>& cells, const SurveyPlan& options,
                 DomainSurvey& survey) {
  for (std::size_t k = 0; k < cells.size(); ++k) {
    if (!cells[k].worst) continue;
    survey.findings.push_back(Shrunk(subject, static_cast<Fault>(k), *cells[k].worst, options));
  }
  const Cell& model = cells.front();
  if (!model.ended_on) return;
  FaultyCase& end = survey.findings.emplace_back(
      model.has_hung ? FaultyCase{Fault::kEnd, model.ended_on->origin, *model.ended_on, ""}
                     : Shrunk(subject, Fault::kEnd, *model.ended_on, options));
  end.end = model.why;
}

}  // namespace

std::span<const SurveyedDomain> SurveyedDomains() { return kSurveyed; }

DomainSurvey SurveyDomain(Subject& subject, std::string_view name, const SurveyPlan& options) {
  DomainSurvey survey;
  survey.domain = name;
  if (!Suits(*FindDomain(name), subject.Info())) return survey;
  const Clock::time_point began = Clock::now();
  Surveyor surveyor(subject, options.model);
  Row row;
  row.cases = options.cases;
  row.at = [&](std::uint64_t index) {
    Case c = DrawCase(subject.Info(), {std::string(name), index, options.seed});
    c.profile = options.model;
    return c;
  };
  row.draw = [&](const CaseAtHand& at) { return surveyor.Draw(at.placed()); };
  const std::vector<Cell> cells = CompareRow(row, surveyor.Yardsticks(), options.limits);
  survey.seconds = Since(began);
  survey.triangles = surveyor.triangles;
  survey.subject_seconds = surveyor.whole_seconds;
  survey.alone_seconds = surveyor.alone_seconds;
  Count(cells, survey);
  AddFindings(subject, cells, options, survey);
  return survey;
}

}  // namespace rasterproof::props
