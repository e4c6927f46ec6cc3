#include "tool/legal/legality.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/sample_text.h"
#include "core/subject_info.h"
#include "core/tie_rule.h"
#include "fmt/format.h"
#include "fmt/ranges.h"
#include "io/case_file.h"
#include "io/counts_file.h"
#include "model/target_profile.h"
#include "props/judging/witness.h"
#include "tool/exit_status.h"
#include "tool/legal/cmd_legal.h"
#include "tool/legal/legal_hints.h"
#include "tool/scene_source.h"
#include "tool/session.h"
#include "tool/shared_files.h"

namespace rasterproof::tool {
namespace {

std::string GridText(const Snap& grid) {
  return grid.IsNone() ? "no grid" : fmt::format("{} subpixel bits", grid.bits);
}

// "2", "1 or more", "1 front and 0 back".
std::string SeenOf(const legal::Requirement& seen) {
  if (seen.by_side)
    return fmt::format("{} front and {} back", (*seen.by_side)[0], (*seen.by_side)[1]);
  return seen.least == seen.most ? fmt::format("{}", seen.least)
                                 : fmt::format("{} or more", seen.least);
}

// The triangles that may be seen there: "7 or 8", "none or 7".
std::string VisibleText(const legal::Requirement& seen) {
  constexpr std::size_t kMostNamed = 8;
  std::vector<std::string> names;
  if (seen.legal_least == 0) names.emplace_back("none");
  for (std::size_t k = 0; k < seen.legal_visible.size() && k < kMostNamed; ++k)
    names.push_back(fmt::format("{}", seen.legal_visible[k]));
  if (seen.legal_visible.size() > kMostNamed)
    names.push_back(fmt::format("{} more", seen.legal_visible.size() - kMostNamed));
  return fmt::format("{}", fmt::join(names, " or "));
}

// `legal` says how the legal values are called: those of one sample, if others are not looked at.
std::string RequirementText(const legal::Requirement& seen, std::string_view legal) {
  if (seen.triangles.empty()) return "no legal model lets any triangle cover it\n";
  if (seen.visible) {
    const std::string shown =
        *seen.visible == kNoPrimitive ? "no triangle" : fmt::format("triangle {}", *seen.visible);
    if (seen.wrong_front) {
      const auto [here, there] =
          *seen.wrong_front ? std::pair("front", "back") : std::pair("back", "front");
      return fmt::format("shows the {} of {}; legal: its {}\n", here, shown, there);
    }
    return fmt::format("shows {}; {}: {}\n", shown, legal, VisibleText(seen));
  }
  std::string text =
      fmt::format("{} of triangles {} cover it", SeenOf(seen), fmt::join(seen.triangles, ", "));
  if (seen.legal_by_side) {
    const auto [front, back] = *seen.legal_by_side;
    text += fmt::format("; {}: {} front and {} back", legal, RangeText(front.least, front.most),
                        RangeText(back.least, back.most));
  } else if (seen.legal_least == seen.legal_most) {
    text += fmt::format("; in every legal model {} {}", seen.legal_most,
                        seen.legal_most == 1 ? "does" : "do");
  } else {
    text += fmt::format("; {}: {}", legal, RangeText(seen.legal_least, seen.legal_most));
  }
  return text + "\n";
}

std::string_view LegalValuesOf(const legal::Core& core) {
  return core.wrong_by_themselves != 0 ? "legal" : "legal, if it were alone";
}

std::string HeadOf(const legal::Core& core) {
  const std::size_t samples = core.requirements.size();
  if (core.wrong_by_themselves > 1) {
    return fmt::format(
        "the values of {} samples contradict every legal model, each by itself; "
        "the first:\n",
        core.wrong_by_themselves);
  }
  if (core.wrong_by_themselves == 1)
    return "the value of one sample contradicts every legal model by itself:\n";
  if (!core.is_minimal)
    return fmt::format("a set of {} samples that no legal model explains together:\n", samples);
  return fmt::format(
      "a minimal set of {} samples that no legal model explains together; without "
      "any of them one does:\n",
      samples);
}

}  // namespace

legal::Observed OneCall::Observed() const {
  legal::Observed observed;
  observed.last_is_visible = last_is_visible;
  observed.any_is_visible = any_is_visible;
  if (has_counts) {
    observed.together = &drawing.counts;
    observed.is_mask = is_mask;
  } else {
    observed.primitive_ids = &drawing.primitive_ids;
    if (has_facings) observed.visible_front = &visible_front;
  }
  return observed;
}

OneCall DrawInOneCall(Subject& subject, const Scene& scene) {
  const SubjectInfo& info = subject.Info();
  DrawJob job(scene, {}, info.profile.pattern.samples());
  job.wants = kCoverageAndPrimitiveIds;
  OneCall drawn{DrawOne(subject, job)};
  const bool counts =
      info.coverage == CoverageKind::kFacingCounts || info.coverage == CoverageKind::kCounts;
  drawn.has_counts = counts || drawn.drawing.primitive_ids.empty();
  drawn.is_mask = !counts;
  drawn.has_facings = info.coverage == CoverageKind::kFacingCounts;
  drawn.last_is_visible = info.fragments.visible == Visible::kLastDrawn;
  return drawn;
}

std::string FamilyText(const legal::Family& family, const Profile& profile) {
  std::string text = GridText(family.grid);
  const TieOwnership ties = profile.freedom.ties;
  if (ties == TieOwnership::kStated || ties == TieOwnership::kAxisAligned)
    text += ", tie rule " + TieRuleName(family.rule);
  return text;
}

std::string LegalityName(legal::Legality legality) {
  switch (legality) {
    case legal::Legality::kLegal:
      return "legal";
    case legal::Legality::kNotLegal:
      return "not legal";
    case legal::Legality::kNotJudged:
      break;
  }
  return "not judged";
}

std::string SearchText(const legal::JointVerdict& verdict, const Profile& profile) {
  switch (verdict.legality) {
    case legal::Legality::kLegal:
      return fmt::format("one model with {} explains all {} samples",
                         FamilyText(verdict.family, profile), verdict.samples);
    case legal::Legality::kNotLegal:
      return fmt::format("no model explains the image; {} tried",
                         verdict.families == 1
                             ? "one grid and tie rule was"
                             : fmt::format("{} grids and tie rules were", verdict.families));
    case legal::Legality::kNotJudged:
      break;
  }
  return fmt::format("a component of {} triangles is too large to judge", verdict.largest_given_up);
}

int StatusOf(legal::Legality legality) {
  switch (legality) {
    case legal::Legality::kLegal:
      return kExitHolds;
    case legal::Legality::kNotLegal:
      return kExitViolated;
    case legal::Legality::kNotJudged:
      break;
  }
  return kExitInconclusive;
}

namespace {

// A bare scene states no profile.
io::CaseFile LoadCaseOrScene(const SceneOptions& options) {
  if (!IsMeshPath(options.path) && options.camera.empty())
    return io::ReadCase(Located(options.path));
  io::CaseFile file;
  file.value.scene = LoadScene(options);
  return file;
}

Profile LegalProfileOf(const LegalOptions& options, const io::CaseFile& file,
                       const Subject* subject) {
  const bool is_named = !options.profile.empty();
  if (file.states_profile && !is_named) return file.value.profile;
  if (subject != nullptr) return subject->Info().profile;
  if (!is_named) {
    throw InputError("legal", "no profile is given",
                     "give --profile: vulkan, gl, d3d11, webgpu or a file");
  }
  return io::ReadProfile(options.profile);
}

// Parts what was seen at each sample into fronts and backs.
void PartFacings(const std::vector<std::uint32_t>& fronts, const std::string& place,
                 const Scene& scene, OneCall& drawn) {
  CoverageCounts& counts = drawn.drawing.counts;
  for (std::size_t s = 0; s < fronts.size(); ++s) {
    const bool is_shown = !drawn.has_counts && drawn.drawing.primitive_ids[s] != kNoPrimitive;
    const std::uint32_t seen = drawn.has_counts ? counts.front[s] : is_shown ? 1 : 0;
    if (fronts[s] > seen) {
      throw InputError(
          place + ": " + SampleText(s, scene.width, counts.samples),
          fmt::format("{} front-facing, but the image shows {} there", fronts[s], seen),
          drawn.has_counts ? "write how many of the image's count are front-facing"
                           : "write 1 where the image's triangle is front-facing, else 0");
    }
  }
  drawn.has_facings = true;
  if (!drawn.has_counts) {
    for (const std::uint32_t front : fronts) drawn.visible_front.push_back(front != 0);
    return;
  }
  for (std::size_t s = 0; s < fronts.size(); ++s) {
    counts.back[s] = counts.front[s] - fronts[s];
    counts.front[s] = fronts[s];
  }
}

OneCall DrawnAs(io::CountsFile file, bool ids, std::string_view visible) {
  OneCall drawn;
  drawn.drawing.counts = std::move(file.counts);
  drawn.drawing.primitive_ids = std::move(file.primitive_ids);
  drawn.has_counts = !ids;
  drawn.is_mask = file.is_mask;
  drawn.is_picture = file.is_mask;
  drawn.corners = std::move(file.corners);
  drawn.last_is_visible = visible == "last";
  drawn.any_is_visible = visible == "any";
  return drawn;
}

// What the case's numbers are called in errors.
OneCall DrawingOf(const io::CaseDrawing& saved, const std::string& path, const Scene& scene,
                  io::CountsFormat format) {
  const bool ids = saved.shows == io::DrawingShows::kIds;
  const bool is_mask = saved.shows == io::DrawingShows::kMask;
  format.holds = ids       ? io::FileHolds::kIds
                 : is_mask ? io::FileHolds::kDrawing
                           : io::FileHolds::kCounts;
  OneCall drawn = DrawnAs(io::CountsFrom(saved.numbers, path + ": drawing.numbers", format), ids,
                          saved.visible);
  if (saved.fronts.empty()) return drawn;
  const std::string place = path + ": drawing.fronts";
  if (is_mask) throw InputError(place, "a mask has no facings", "leave them out, or show counts");
  format.holds = io::FileHolds::kCounts;
  PartFacings(io::CountsFrom(saved.fronts, place, format).counts.front, place, scene, drawn);
  return drawn;
}

}  // namespace

InputError NotOneDrawing() {
  return InputError("legal", "there is no drawing, or more than one",
                    "give the file of an image, or --subject, --plugin or --exec, not both, or a "
                    "case that `legal --save` wrote; --decided says what legal models leave open");
}

JudgedScene LoadJudgedScene(const LegalOptions& options, const Subject* subject) {
  return JudgedSceneOf(options, LoadCaseOrScene(options.scene), subject);
}

JudgedScene JudgedSceneOf(const LegalOptions& options, io::CaseFile file, const Subject* subject) {
  if (file.value.options.cull != Cull::kNone || file.value.options.scissor) {
    throw InputError(options.scene.path, "the case culls or has a scissor",
                     "'rasterproof replay' judges it; this verb judges whole drawings");
  }
  if (subject == nullptr && options.image.empty() && !file.drawing) throw NotOneDrawing();
  JudgedScene judged{std::move(file.value.scene), {}, std::move(file.drawing)};
  judged.profile = WithAssumptions(LegalProfileOf(options, file, subject), options);
  if (subject != nullptr) {
    RequireTakes(*subject, judged.scene, options.scene.path);
    RequireDrawsSamples(*subject, judged.profile, options.scene.path);
  }
  if (const auto why = legal::WhyNotJoint(judged.scene, {judged.profile, judged.scene})) {
    throw InputError("profile " + judged.profile.name, *why, RemedyOf(*why));
  }
  return judged;
}

OneCall ReadDrawing(const LegalOptions& options, const JudgedScene& judged) {
  const Scene& scene = judged.scene;
  io::CountsFormat format{.width = scene.width,
                          .height = scene.height,
                          .samples = TargetProfile(judged.profile, scene).pattern.samples(),
                          .background = options.background,
                          .holds = options.ids      ? io::FileHolds::kIds
                                   : options.counts ? io::FileHolds::kCounts
                                                    : io::FileHolds::kDrawing,
                          .triangles = scene.triangles.size()};
  if (options.image.empty()) return DrawingOf(*judged.drawing, options.scene.path, scene, format);
  OneCall drawn = DrawnAs(io::ReadCounts(options.image, format), options.ids, options.visible);
  if (options.facings.empty()) return drawn;
  if (drawn.is_picture) {
    throw InputError("--facings " + options.facings,
                     "the image shows where, not how often, samples are covered",
                     "give counts, as text or with --counts, or ids with --ids");
  }
  format.holds = io::FileHolds::kCounts;
  PartFacings(io::ReadCounts(options.facings, format).counts.front, options.facings, scene, drawn);
  return drawn;
}

namespace {

std::string ComparedIn(const OneCall& drawn) {
  if (drawn.is_picture)
    return "covered or not; double coverage is not seen: give counts (or --ids)";
  if (drawn.is_mask && drawn.has_counts) return "covered or not; double coverage is not seen";
  if (drawn.has_counts) return "counts; facings are not seen";
  if (drawn.any_is_visible)
    return "ids: each covers its sample; which of several triangles is on top is not judged";
  return fmt::format("ids; of several triangles, the {} one's",
                     drawn.last_is_visible ? "last" : "first");
}

// How many samples a core convicts by themselves, or 1 for a set of them.
std::size_t WeightOf(const legal::JointVerdict& verdict) {
  return verdict.core ? std::max<std::size_t>(verdict.core->wrong_by_themselves, 1) : 0;
}

}  // namespace

Judgement JudgeDrawing(const JudgedScene& judged, const OneCall& drawn) {
  const TargetProfile profile(judged.profile, judged.scene);
  legal::Observed observed = drawn.Observed();
  const auto judge = [&](legal::Sides sides) {
    observed.sides = sides;
    return legal::JudgeJointly(judged.scene, profile, observed);
  };
  const auto with_rules = [&](legal::JointVerdict verdict, std::string compared) -> Judgement {
    std::vector<BrokenRule> broken = BrokenRules(judged.scene, judged.profile, observed, verdict);
    return {std::move(verdict), std::move(compared), std::move(broken)};
  };
  if (!drawn.has_facings) return with_rules(judge(legal::Sides::kNotCompared), ComparedIn(drawn));
  const bool either = judged.profile.front_face == FrontFace::kUnstated;
  const std::string what = drawn.has_counts ? "counts" : "ids";
  std::string compared =
      drawn.has_counts ? "counts and facings" : "facings and " + ComparedIn(drawn);
  legal::Sides sides = legal::Sides::kPositiveArea;
  legal::JointVerdict verdict = judge(sides);
  if (verdict.legality != legal::Legality::kLegal && either) {
    legal::JointVerdict other = judge(legal::Sides::kNegativeArea);
    if (other.legality == legal::Legality::kLegal || WeightOf(other) < WeightOf(verdict)) {
      verdict = std::move(other);
      sides = legal::Sides::kNegativeArea;
      compared += "; the front is the side that is clockwise on screen";
    }
  }
  if (verdict.legality != legal::Legality::kNotLegal) return {std::move(verdict), compared};
  legal::JointVerdict counts = judge(legal::Sides::kNotCompared);
  if (counts.legality == legal::Legality::kNotLegal)
    return with_rules(std::move(counts), what + "; no model explains them, whatever the facings");
  if (counts.legality == legal::Legality::kLegal)
    compared += "; a model explains the " + what + " alone";
  observed.sides = sides;
  return with_rules(std::move(verdict), compared);
}

std::string CoreText(const legal::Core& core, const Scene& scene, int samples) {
  constexpr std::size_t kMostTold = 8;
  std::string text = HeadOf(core);
  const auto& told = core.wrong.empty() ? core.requirements : core.wrong;
  const std::size_t all = std::max(told.size(), core.wrong_by_themselves);
  const std::size_t lines = std::min(told.size(), kMostTold);
  for (std::size_t k = 0; k < lines; ++k) {
    text += "  " + SampleText(told[k].sample, scene.width, samples) + ": " +
            RequirementText(told[k], LegalValuesOf(core));
  }
  if (all > lines) text += fmt::format("  and {} more\n", all - lines);
  if (!core.vertices.empty()) text += "the positions of these vertices decide them:\n";
  for (std::size_t k = 0; k < core.vertices.size() && k < kMostTold; ++k) {
    const Vertex& v = scene.vertices[core.vertices[k]];
    text += fmt::format("  vertex {} at ({}, {})\n", core.vertices[k], props::HexText(v.x),
                        props::HexText(v.y));
  }
  if (core.vertices.size() > kMostTold)
    text += fmt::format("  and {} more\n", core.vertices.size() - kMostTold);
  return text;
}

std::string CoreLine(const legal::Core& core, const Scene& scene, int samples) {
  const legal::Requirement& first = core.requirements.front();
  std::string line = HeadOf(core) + SampleText(first.sample, scene.width, samples) + ": " +
                     RequirementText(first, LegalValuesOf(core));
  line.pop_back();
  std::ranges::replace(line, '\n', ' ');
  return line;
}

}  // namespace rasterproof::tool
