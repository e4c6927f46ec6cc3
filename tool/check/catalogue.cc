#include "tool/check/catalogue.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/error.h"
#include "core/suggestion.h"
#include "fmt/format.h"
#include "io/case_file.h"
#include "io/output.h"
#include "report/catalogue.h"
#include "report/picture.h"
#include "report/text.h"
#include "tool/exit_status.h"
#include "tool/failure.h"
#include "tool/file_names.h"
#include "tool/interrupt.h"
#include "tool/progress.h"
#include "tool/session.h"
#include "tool/workers.h"

namespace rasterproof::tool {
namespace {

using props::FamilyCell;
using props::FamilyResult;
using props::Yardstick;

constexpr std::array kYardsticks{Yardstick::kOwnModel, Yardstick::kRealGeometry};

std::string Table(const std::vector<props::Family>& families,
                  const report::CatalogueColumn& column) {
  std::string text;
  const props::Theme* theme = nullptr;
  for (std::size_t k = 0; k < families.size(); ++k) {
    if (families[k].theme != theme) {
      theme = families[k].theme;
      text += fmt::format("\n{}: {}\n", theme->name, theme->right);
    }
    text +=
        fmt::format("  {:<22} {:<44} {}\n", families[k].name,
                    report::FamilyText(column.cells[k][0]), report::FamilyText(column.cells[k][1]));
  }
  return text;
}

struct FamilySummary {
  std::array<std::size_t, 2> fails{};
  std::array<std::size_t, 2> stands{};
  std::array<std::size_t, 2> excused{};
};

FamilySummary SummaryOf(const std::vector<FamilyResult>& results) {
  FamilySummary sum;
  for (const FamilyResult& result : results) {
    for (std::size_t k = 0; k < result.cells.size(); ++k) {
      const FamilyCell& cell = result.cells[k];
      ++(cell.Fails() ? sum.fails : cell.cases != 0 ? sum.stands : sum.excused)[k];
    }
  }
  return sum;
}

std::string SummaryLine(const std::string& subject, const FamilySummary& sum) {
  std::string line = subject + ":";
  for (std::size_t k = 0; k < props::kYardstickNames.size(); ++k) {
    line += fmt::format("{} {}: {} families stand, {} fail, {} excused", k == 0 ? "" : ";",
                        props::kYardstickNames[k], sum.stands[k], sum.fails[k], sum.excused[k]);
  }
  return line + "\n";
}

// The case as the yardstick judges it.
Case JudgedBy(Yardstick yardstick, Case c) {
  if (yardstick == Yardstick::kRealGeometry) c.profile = props::RealProfileOf(c.profile);
  return c;
}

void SaveWorst(const std::string& folder, const std::string& subject,
               const std::vector<FamilyResult>& results) {
  io::MakeFolder(folder);
  for (const FamilyResult& result : results) {
    for (const Yardstick yardstick : kYardsticks) {
      const FamilyCell& cell = result.By(yardstick);
      if (!cell.worst) continue;
      io::WriteFile(
          fmt::format("{}/{}-{}-{}.json", folder, FileNameOf(subject), result.family,
                      yardstick == Yardstick::kOwnModel ? "own" : "real"),
          io::CaseToJson({JudgedBy(yardstick, *cell.worst), subject, "CoverageEqualsTheModel"}));
    }
  }
}

std::vector<props::Family> FamiliesNamed(const std::vector<std::string>& names) {
  std::vector<props::Family> all = props::Catalogue();
  if (names.empty()) return all;
  std::vector<props::Family> chosen;
  for (const std::string& name : names) {
    const auto found = std::ranges::find(all, name, &props::Family::name);
    if (found == all.end()) {
      std::vector<std::string_view> known;
      for (const props::Family& family : all) known.push_back(family.name);
      throw InputError(
          fmt::format("family '{}'", name), "the catalogue has no such family",
          Suggestion(name, known) + "'rasterproof list domains' and 'list worlds' name all");
    }
    chosen.push_back(*found);
  }
  return chosen;
}

report::CatalogueCell AsReported(const FamilyCell& cell, bool is_proved) {
  return {.cases = cell.cases,
          .wrong = cell.wrong,
          .samples = cell.samples,
          .wrong_samples = cell.wrong_samples,
          .worst_pixels = cell.worst_pixels,
          .worst_case = cell.worst ? cell.worst->origin : "",
          .excused = cell.excused,
          .why = cell.why,
          .is_exhausted = cell.is_exhausted,
          .is_proved = is_proved && cell.wrong == 0};
}

report::CatalogueColumn ColumnOf(const SubjectInfo& info,
                                 const std::vector<FamilyResult>& results) {
  report::CatalogueColumn column{.subject = info.name, .folder = {}, .cells = {}};
  const bool is_proved = info.states_exact && !info.proofs.empty();
  const bool is_real = SameModel(info.profile, props::RealProfileOf(info.profile));
  for (const FamilyResult& result : results) {
    column.cells.push_back({AsReported(result.By(Yardstick::kOwnModel), is_proved),
                            AsReported(result.By(Yardstick::kRealGeometry), is_proved && is_real)});
  }
  return column;
}

report::Catalogue CatalogueOf(const std::vector<props::Family>& families,
                              const props::CataloguePlan& plan) {
  report::Catalogue catalogue{
      .seed = plan.seed, .cases = plan.cases, .families = {}, .columns = {}};
  for (const props::Family& family : families) {
    catalogue.families.push_back({std::string(family.name), std::string(family.summary),
                                  std::string(family.theme->name),
                                  std::string(family.theme->right)});
  }
  return catalogue;
}

// By the order of the families; after an interrupt some results have no cases.
std::vector<FamilyResult> MeasureCatalogue(const SubjectFactory& subject,
                                           const std::vector<props::Family>& families,
                                           const props::CataloguePlan& plan, int jobs) {
  Progress progress(static_cast<std::size_t>(jobs));
  Crew crew(jobs, [&](std::size_t) { return subject.Make(); });
  std::vector<FamilyResult> results(families.size());
  for (std::size_t k = 0; k < families.size(); ++k) results[k].family = families[k].name;
  const auto order = OrderOfWork(jobs, families.size(),
                                 [&](std::size_t k) { return families[k].world != nullptr; });
  ShareWork(jobs, order, [&](std::size_t worker, std::size_t k) {
    if (Interrupted()) return;
    progress.Stage(fmt::format("{} {}", subject.name(), families[k].name), 0, worker);
    results[k] = props::MeasureFamily(crew.Of(worker), families[k], plan);
    progress.Stage("", 0, worker);
  });
  return results;
}

// A failing case of a family, and whose it is.
struct Worst {
  double pixels = -1;
  Case value;
  const SubjectFactory* subject = nullptr;
};

void KeepWorst(const SubjectFactory& subject, const FamilyResult& result, Worst& worst) {
  for (const Yardstick yardstick : kYardsticks) {
    const FamilyCell& cell = result.By(yardstick);
    if (!cell.worst || !std::isfinite(cell.worst_pixels) || cell.worst_pixels <= worst.pixels) {
      continue;
    }
    worst = {cell.worst_pixels, JudgedBy(yardstick, *cell.worst), &subject};
  }
}

std::optional<report::FamilyPicture> PictureOf(const Worst& worst) {
  if (worst.subject == nullptr) return std::nullopt;
  const std::unique_ptr<Subject> subject = worst.subject->Make();
  try {
    report::Explanation explanation = Explain(*subject, worst.value, {}, "");
    explanation.edge_values.clear();
    const bool is_real = !SameModel(worst.value.profile, subject->Info().profile);
    return report::FamilyPicture{
        fmt::format("{} by {}: {:.2g} pixels", worst.subject->name(),
                    is_real ? "real geometry" : "its own model", worst.pixels),
        worst.subject->name(), report::ExplanationToSvg(explanation)};
  } catch (const InputError&) {
    return std::nullopt;  // a case that it drew before and refuses now
  } catch (const SubjectStop&) {
    return std::nullopt;
  }
}

}  // namespace

report::Catalogue MeasureCatalogues(const std::vector<SubjectFactory>& subjects,
                                    const props::CataloguePlan& plan, int jobs) {
  const std::vector<props::Family> families = props::Catalogue();
  report::Catalogue catalogue = CatalogueOf(families, plan);
  std::vector<Worst> worst(families.size());
  for (const SubjectFactory& subject : subjects) {
    const SubjectInfo info = subject.Make()->Info();
    if (info.profile.squares || Interrupted()) continue;
    const std::vector<FamilyResult> results = MeasureCatalogue(subject, families, plan, jobs);
    for (std::size_t k = 0; k < families.size(); ++k) KeepWorst(subject, results[k], worst[k]);
    report::CatalogueColumn& column = catalogue.columns.emplace_back(ColumnOf(info, results));
    column.folder = FileNameOf(info.name);
  }
  for (std::size_t k = 0; k < families.size(); ++k) {
    catalogue.families[k].picture = PictureOf(worst[k]);
  }
  return catalogue;
}

int CheckCatalogue(const CheckOptions& options) {
  const ResolvedCheck asked = ResolveCheck(options);
  if (!options.save.empty()) io::RequireFolderCanBe(options.save);
  const std::vector<props::Family> families = FamiliesNamed(options.families);
  props::CataloguePlan plan;
  plan.seed = options.campaign.seed;
  plan.cases = options.campaign.cases;
  plan.seconds = options.campaign.seconds;
  plan.stop = Interrupted;
  report::Catalogue catalogue = CatalogueOf(families, plan);
  int status = kExitHolds;
  for (const SubjectFactory& subject : asked.subjects) {
    RequireSamples(subject.Make()->Info());
    const std::vector<FamilyResult> results =
        MeasureCatalogue(subject, families, plan, options.jobs);
    catalogue.columns.push_back(ColumnOf(subject.Make()->Info(), results));
    const FamilySummary sum = SummaryOf(results);
    io::WriteStandardOutput(report::CleanText(
        fmt::format("{}, seed {}, {} cases a family\n{:<25}{:<45}{}\n", subject.name(), plan.seed,
                    plan.cases, "", props::kYardstickNames[0], props::kYardstickNames[1]) +
        Table(families, catalogue.columns.back()) + "\n" + SummaryLine(subject.name(), sum)));
    if (!options.save.empty()) SaveWorst(options.save, subject.name(), results);
    if (sum.fails[0] != 0) status = WorseStatus(status, kExitViolated);
    if (sum.stands[0] + sum.fails[0] == 0) status = WorseStatus(status, kExitInconclusive);
    if (Interrupted()) return WorseStatus(status, kExitInconclusive);
  }
  return status;
}

}  // namespace rasterproof::tool
