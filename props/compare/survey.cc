#include "props/compare/survey.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>

#include "core/coverage.h"
#include "core/question.h"
#include "core/subject_info.h"
#include "props/compare/yardsticks.h"
#include "props/domains/domain.h"
#include "props/infer/observer.h"
#include "props/judging/gate.h"
#include "props/judging/redraw.h"
#include "props/placed_case.h"
#include "props/run/description.h"
#include "props/run/property_domains.h"

namespace rasterproof::props {
namespace {

// Plain domains, those near an edge, and meshes; then those near the limits.
constexpr auto kSurveyed = std::to_array<SurveyedDomain>({{"uniform-subpixel"},
                                                          {"vertices-on-samples"},
                                                          {"near-edge"},
                                                          {"snap-ties"},
                                                          {"degenerate"},
                                                          {"axis-aligned"},
                                                          {"long-rows"},
                                                          {"fans"},
                                                          {"grids"},
                                                          {"triangulations"},
                                                          {"subdivisions"},
                                                          {"mixed-magnitude", true},
                                                          {"far-negative-corners", true},
                                                          {"range-ends", true},
                                                          {"covering-fans", true}});

// The profile says something of the case, and the oracle decides it.
constexpr Gate kCompared{
    .space = Space::kEither, .judges_shared_edge_samples = true, .asks_oracle = true};

CoverageCounts Expected(const PlacedCase& c, const TieRule& rule) {
  CoverageCounts counts = CoverageUnder(c, rule, c.options);
  JoinFacings(counts);
  return counts;
}

// The samples at which the test holds.
template <class Test>
Reading WrongAt(const PlacedCase& c, const CoverageCounts& counts, Test is_wrong) {
  std::vector<std::size_t> wrong;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    if (is_wrong(k)) wrong.push_back(k);
  }
  return Measured(c, counts, std::move(wrong));
}

// A subject's draws, and the yardsticks by which they are read.
class Surveyor {
 public:
  Surveyor(Subject& subject, const Profile& model)
      : subject_(subject), description_(DescriptionOf(subject)) {
    description_.info.profile = model;
    const CoverageKind kind = description_.info.coverage;
    shows_counts_ = kind == CoverageKind::kFacingCounts || kind == CoverageKind::kCounts;
  }

  /// In the order of kSurveyYardsticks. The model's comes before those of meshes.
  std::vector<Yardstick> Yardsticks() {
    return {[this](const CaseAtHand& at) { return ByModel(at); },
            [this](const CaseAtHand& at) {
              return ByMesh(at, [](std::uint32_t count) { return count == 0; });
            },
            [this](const CaseAtHand& at) {
              return ByMesh(at, [](std::uint32_t count) { return count > 1; });
            },
            [this](const CaseAtHand& at) { return ByItsTriangles(at); }};
  }

  // In one call, and once more triangle by triangle. Who shows no counts shows overlaps only so.
  Drawn Draw(const PlacedCase& c) {
    const DrawQuestion whole = WholeCallOf(c.scene, c.profile, c.options);
    Drawn drawn;
    std::vector<CoverageCounts> counts = DrawEach(c, {whole}, drawn.end);
    if (drawn.end.stop != Stop::kNone) return drawn;
    Drawing drawing;
    drawing.counts = std::move(counts.front());
    if (c.scene.triangles.size() >= 2) {
      std::vector<DrawQuestion> each(c.scene.triangles.size(), whole);
      for (std::size_t t = 0; t < each.size(); ++t) {
        each[t].job.triangles = {c.scene.triangles[t]};
      }
      counts = DrawEach(c, std::move(each), drawn.end);
      if (drawn.end.stop != Stop::kNone) return drawn;
      CoverageCounts sum(c.scene.width, c.scene.height, drawing.counts.samples);
      for (const CoverageCounts& one : counts) sum += one;
      drawn.alone = std::make_shared<const CoverageCounts>(std::move(sum));
    }
    drawn.drawing = std::make_shared<const Drawing>(std::move(drawing));
    return drawn;
  }

 private:
  std::vector<CoverageCounts> DrawEach(const PlacedCase& c, std::vector<DrawQuestion> draws,
                                       CallEnd& end) {
    Answers answers = AnswersTo(subject_, c, std::move(draws));
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
    const PlacedCase& c = at.placed();
    why_not_ = WhyNotCompared(kCompared, c.before ? AsJudged(description_) : description_, c);
    why_no_mesh_ = why_not_;
    if (!why_not_.empty()) return {why_not_};
    expected_ = Expected(c, c.profile.tie_rule);
    if (!IsMesh(c)) why_no_mesh_ = "it is no covering mesh";
    return {"", [this, &c](const Drawn& drawn) {
              const CoverageCounts& shown = Shown(drawn);
              return WrongAt(c, shown,
                             [&](std::size_t k) { return shown.front[k] != expected_.front[k]; });
            }};
  }

  // Rules that give a sample to both sides of an edge, or to neither, have no covering meshes.
  bool IsMesh(const PlacedCase& c) const {
    if (c.scene.triangles.size() < 2) return false;
    const auto is_one = [](std::uint32_t count) { return count == 1; };
    const bool is_one_sided = c.profile.tie_rule.IsConsistent();
    return std::ranges::all_of((is_one_sided ? expected_ : Expected(c, kTopLeft)).front, is_one);
  }

  Judging ByMesh(const CaseAtHand& at, bool (*is_wrong)(std::uint32_t count)) const {
    if (!why_no_mesh_.empty()) return {why_no_mesh_};
    return {"", [this, is_wrong, &c = at.placed()](const Drawn& drawn) {
              const CoverageCounts& shown = Shown(drawn);
              return WrongAt(c, shown, [&](std::size_t k) { return is_wrong(shown.front[k]); });
            }};
  }

  // One call with all triangles is to be the sum of calls with each.
  Judging ByItsTriangles(const CaseAtHand& at) const {
    if (!why_not_.empty()) return {why_not_};
    return {"", [this, &c = at.placed()](const Drawn& drawn) -> Reading {
              if (drawn.alone == nullptr) return {};
              const CoverageCounts& whole = drawn.drawing->counts;
              const auto shown = [this](std::uint32_t count) {
                return shows_counts_ ? count : std::min(count, 1U);
              };
              return WrongAt(c, whole, [&](std::size_t k) {
                return shown(whole.front[k]) != shown(drawn.alone->front[k]);
              });
            }};
  }

  Subject& subject_;
  Description description_;
  bool shows_counts_ = false;
  // Of the case at hand, worked out by the model's yardstick.
  std::string why_not_;
  std::string why_no_mesh_;
  CoverageCounts expected_;
};

}  // namespace

std::span<const SurveyedDomain> SurveyedDomains() { return kSurveyed; }

std::vector<Cell> SurveyDomain(Subject& subject, std::string_view name, const SurveyPlan& plan) {
  if (!Suits(*FindDomain(name), subject.Info())) {
    return std::vector<Cell>(
        kSurveyYardsticks.size(),
        {.excused = 1, .why = "the subject takes none of the domain's scenes"});
  }
  Surveyor surveyor(subject, plan.model);
  Row row;
  row.cases = plan.cases;
  row.at = [&](std::uint64_t index) {
    Case c = DrawCase(subject.Info(), {std::string(name), index, plan.seed});
    c.profile = plan.model;
    return c;
  };
  row.draw = [&](const CaseAtHand& at) { return surveyor.Draw(at.placed()); };
  return CompareRow(row, surveyor.Yardsticks(), plan.limits);
}

}  // namespace rasterproof::props
