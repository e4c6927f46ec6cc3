#include "tool/survey/survey.h"

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "core/coverage.h"
#include "core/error.h"
#include "core/subject.h"
#include "core/subject_info.h"
#include "exact/coverage.h"
#include "exact/environment.h"
#include "io/case_file.h"
#include "io/output.h"
#include "props/run/facings.h"
#include "props/shrink/shrink.h"
#include "subjects/plugin/plugin.h"
#include "tool/outside.h"
#include "tool/survey/isolated.h"

namespace rasterproof::tool {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kStallSeconds = 10;
constexpr int kMostEnds = 4;  // deaths of one family before it is given up

double Since(Clock::time_point begun) {
  return std::chrono::duration<double>(Clock::now() - begun).count();
}

// A library in this process, or a program on a pipe and what it says of itself.
subjects::LoadedPlugin Load(const std::string& path) {
  if (!path.ends_with(kDescriptionEnding)) return subjects::LoadPlugin(path);
  OutsideLimits() = {.seconds = kStallSeconds, .bytes = 0};  // as for a library
  std::unique_ptr<Subject> subject = MakeOutside(path);
  std::string profile = io::ProfileToJson(subject->Info().profile);
  return {std::move(subject), std::move(profile)};
}

bool ShowsOverlaps(CoverageKind coverage) {
  return coverage == CoverageKind::kFacingCounts || coverage == CoverageKind::kCounts;
}

// The oracle computes in the process that the library is loaded into, and in its threads.
void RequireHonest() {
  if (const exact::Environment environment = exact::InspectEnvironment(); !environment.Honest()) {
    throw std::runtime_error("the library left this process unfit to judge: " +
                             environment.Complaint());
  }
}

// The subject's counts of a scene, and the time it took. Who gives no counts is asked triangle by
// triangle, so that overlaps show; who does, in one call, whose order and company may matter.
CoverageCounts Drawn(Subject& subject, const Scene& scene, double& seconds) {
  CoverageCounts counts(scene.width, scene.height);
  const Clock::time_point begun = Clock::now();
  if (ShowsOverlaps(subject.Info().coverage)) {
    subject.Draw(scene, {}, counts);
  } else {
    props::DrawByFacing(subject, scene, {}, counts);
  }
  seconds += Since(begun);
  RequireHonest();
  return counts;
}

CoverageCounts DrawnAlone(Subject& subject, const Scene& scene, double& seconds) {
  CoverageCounts sum(scene.width, scene.height);
  for (const Triangle& t : scene.triangles) {
    Scene one = scene;
    one.triangles = {t};
    const CoverageCounts counts = Drawn(subject, one, seconds);
    for (std::size_t k = 0; k < sum.size(); ++k) {
      sum.front[k] += counts.front[k];
      sum.back[k] += counts.back[k];
    }
  }
  return sum;
}

struct Findings {
  std::uint64_t wrong = 0;
  std::uint64_t gaps = 0;
  std::uint64_t overlaps = 0;
  bool batch_differs = false;

  bool Has(Fault fault) const {
    switch (fault) {
      case Fault::kWrong:
        return wrong != 0;
      case Fault::kGap:
        return gaps != 0;
      case Fault::kTwice:
        return overlaps != 0;
      case Fault::kBatch:
        return batch_differs;
      case Fault::kEnd:
        return false;
    }
    return false;
  }
};

Findings Look(Subject& subject, const Scene& scene, FamilyKind kind, const Profile& model,
              SubjectTimes& times) {
  const CoverageCounts observed = Drawn(subject, scene, times.at_once);
  const CoverageCounts expected = exact::Coverage(scene, model);
  Findings found;
  for (std::size_t k = 0; k < observed.size(); ++k) {
    const std::uint32_t count = observed.Count(k);
    found.wrong += count != expected.Count(k) ? 1U : 0U;
    if (kind != FamilyKind::kCover) continue;
    found.gaps += count == 0 ? 1U : 0U;
    found.overlaps += count > 1 ? 1U : 0U;
  }
  if (scene.triangles.size() > 1) {
    found.batch_differs = DrawnAlone(subject, scene, times.alone) != observed;
  }
  return found;
}

struct Progress {
  std::atomic<std::uint64_t> step{0};
  std::uint64_t next = 0;
  FamilyTally tally;
};

void Note(FamilyTally& tally, const Findings& found, std::uint64_t index) {
  tally.wrong += found.wrong;
  tally.gaps += found.gaps;
  tally.overlaps += found.overlaps;
  for (std::size_t k = 0; k < kFaults; ++k) {
    if (!found.Has(static_cast<Fault>(k))) continue;
    ++tally.faulty[k];
    if (tally.first[k] < 0) tally.first[k] = static_cast<std::int64_t>(index);
  }
}

void DrawFamily(const SurveyOptions& options, const Family& family, const Profile& model,
                Progress& progress) {
  const std::unique_ptr<Subject> subject = Load(options.path).subject;
  FamilyTally& tally = progress.tally;
  const Clock::time_point begun = Clock::now();
  const double before = tally.seconds;
  while (progress.next < options.cases && tally.seconds < options.seconds) {
    const std::uint64_t index = progress.next;
    const Scene scene = family.draw(index, model, subject->Info().input);
    try {
      Note(tally, Look(*subject, scene, family.kind, model, tally.subject_seconds), index);
      ++tally.scenes;
      tally.triangles += scene.triangles.size();
      tally.samples += CoverageCounts::Size(scene.width, scene.height, 1);
    } catch (const InputError&) {
      ++tally.refused;
    }
    tally.seconds = before + Since(begun);
    ++progress.next;
    ++progress.step;
  }
}

// Whether a sample deep inside, which the model covers once, is covered `wanted`: 0 times, or more
// than once. Deep inside: the real triangles cover it and its eight neighbours once. Unlike "the
// mesh covers the target" this can be asked of every smaller scene.
bool HasSeam(Subject& subject, const Scene& scene, const Profile& model, Fault fault) {
  double unused = 0;
  const CoverageCounts observed = Drawn(subject, scene, unused);
  const CoverageCounts expected = exact::Coverage(scene, model);
  Profile real = model;
  real.snap = {};
  const CoverageCounts unsnapped = exact::Coverage(scene, real);
  const auto deep = [&](int i, int j) {
    for (int row = j - 1; row <= j + 1; ++row) {
      for (int column = i - 1; column <= i + 1; ++column) {
        if (unsnapped.Count(unsnapped.Index(column, row)) != 1) return false;
      }
    }
    return true;
  };
  for (int j = 1; j + 1 < scene.height; ++j) {
    for (int i = 1; i + 1 < scene.width; ++i) {
      const std::size_t k = observed.Index(i, j);
      const bool wanted = fault == Fault::kGap ? observed.Count(k) == 0 : observed.Count(k) > 1;
      if (wanted && expected.Count(k) == 1 && deep(i, j)) return true;
    }
  }
  return false;
}

bool StillFails(Subject& subject, const Case& c, Fault fault) {
  try {
    if (fault == Fault::kGap || fault == Fault::kTwice) {
      return HasSeam(subject, c.scene, c.profile, fault);
    }
    SubjectTimes unused;
    return Look(subject, c.scene, FamilyKind::kSingles, c.profile, unused).Has(fault);
  } catch (const InputError&) {
    return false;
  }
}

// Shrinks in a child; if it dies over a smaller case, the case it began with is left.
Case Shrunk(const SurveyOptions& options, Fault fault, const Case& failing) {
  const std::string path = options.path + ".shrunk.json";
  io::WriteFile(path, io::CaseToJson({failing, "", ""}));
  Shared<Progress> progress;
  const auto work = [&] {
    const std::unique_ptr<Subject> subject = Load(options.path).subject;
    const auto fails = [&](const Case& c) {
      ++progress->step;
      return StillFails(*subject, c, fault);
    };
    if (!fails(failing)) return;
    const Case small = props::Shrink(failing, fails, options.shrink_budget).minimal;
    io::WriteFile(path, io::CaseToJson({small, "", ""}));
  };
  const std::string end = RunIsolated(work, progress->step, kStallSeconds);
  if (!end.empty()) std::fprintf(stderr, "%s: shrinking %s\n", options.path.c_str(), end.c_str());
  Case small = io::ReadCase(path).value;
  std::remove(path.c_str());
  return small;
}

FamilySurvey SurveyFamily(const SurveyOptions& options, const Family& family, const Profile& model,
                          Precision precision) {
  Shared<Progress> progress;
  FamilySurvey survey{&family, {}, {}};
  const auto case_of = [&](std::uint64_t index) {
    return Case{family.draw(index, model, precision),
                model,
                {},
                std::string(family.name) + ", case " + std::to_string(index)};
  };
  for (int ends = 0; ends < kMostEnds;) {
    const auto work = [&] { DrawFamily(options, family, model, *progress); };
    const std::string end = RunIsolated(work, progress->step, kStallSeconds);
    if (end.empty()) break;
    const std::uint64_t index = progress->next++;
    constexpr auto kDied = static_cast<std::size_t>(Fault::kEnd);
    if (progress->tally.faulty[kDied]++ == 0) {
      progress->tally.first[kDied] = static_cast<std::int64_t>(index);
      survey.counterexamples.push_back({Fault::kEnd, case_of(index), end});
    }
    ++ends;
  }
  survey.tally = progress->tally;
  for (const Fault fault : {Fault::kWrong, Fault::kGap, Fault::kTwice, Fault::kBatch}) {
    const std::int64_t first = survey.tally.first[static_cast<std::size_t>(fault)];
    if (first < 0) continue;
    const Case failing = case_of(static_cast<std::uint64_t>(first));
    survey.counterexamples.push_back({fault, Shrunk(options, fault, failing), ""});
  }
  return survey;
}

// What the child that fits hands back; this process never loads the library itself.
struct PlainFit {
  Snap snap;
  Point2 location;
  FillRule rule;
  std::uint64_t wrong;
  std::uint64_t samples;
};
struct Introduction {
  std::atomic<std::uint64_t> step{0};
  std::array<char, 128> name{};
  std::array<char, 512> summary{};
  std::array<char, 4096> profile{};
  Precision input = Precision::kFloat32;
  bool loaded = false;
  std::size_t fits = 0;
  std::array<PlainFit, 8> fit{};
};

template <std::size_t n>
void Put(const std::string& text, std::array<char, n>& into) {
  std::snprintf(into.data(), n, "%s", text.c_str());
}

Profile ProfileOf(const std::string& text, const std::string& place) {
  if (const std::optional<Profile> preset = PresetProfile(text)) return *preset;
  const std::string scene = R"({"rasterproof_scene": 1, "name": "", "width": 1, "height": 1,
    "vertices": [], "triangles": []})";
  return io::ParseCase(
             R"({"rasterproof_case": 1, "scene": )" + scene + ", \"profile\": " + text + "}", place)
      .value.profile;
}

void Introduce(const SurveyOptions& options, Introduction& into) {
  const std::string& path = options.path;
  const subjects::LoadedPlugin loaded = Load(path);
  const SubjectInfo& info = loaded.subject->Info();
  Put(std::filesystem::path(info.name).stem().string(), into.name);
  Put(info.summary, into.summary);
  Put(loaded.profile, into.profile);
  into.input = info.input;
  into.loaded = true;
  for (const Fit& fit :
       FitModels(*loaded.subject, ProfileOf(loaded.profile, path), options.fitting_triangles)) {
    const Profile& m = fit.model;
    into.fit[into.fits++] = {m.snap, m.lattice.locations[0], m.fill_rule, fit.wrong, fit.samples};
  }
}

}  // namespace

Survey RunSurvey(const SurveyOptions& options) {
  Shared<Introduction> met;
  Survey survey;
  survey.trouble = RunIsolated([&] { Introduce(options, *met); }, met->step, 120);
  if (!met->loaded) throw InputError(options.path, survey.trouble, "look at what it printed");
  survey.subject = met->name.data();
  survey.summary = met->summary.data();
  survey.declared = ProfileOf(met->profile.data(), options.path);
  for (std::size_t k = 0; k < met->fits; ++k) {
    const PlainFit& plain = met->fit[k];
    Fit fit{survey.declared, plain.wrong, plain.samples};
    fit.model.name = survey.subject + ", fitted";
    fit.model.snap = plain.snap;
    fit.model.lattice.locations = {plain.location};
    fit.model.fill_rule = plain.rule;
    survey.fits.push_back(fit);
  }
  if (survey.fits.empty()) return survey;
  for (const Family& family : Families()) {
    std::fprintf(stderr, "%s: %s\n", survey.subject.c_str(), std::string(family.name).c_str());
    survey.families.push_back(SurveyFamily(options, family, survey.fits[0].model, met->input));
  }
  return survey;
}

}  // namespace rasterproof::tool
