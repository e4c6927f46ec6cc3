#include "tool/catalogue.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "core/error.h"
#include "core/suggestion.h"
#include "fmt/format.h"
#include "io/case_file.h"
#include "io/output.h"
#include "report/proportion.h"
#include "report/text.h"
#include "tool/exit_status.h"
#include "tool/file_names.h"
#include "tool/interrupt.h"
#include "tool/session.h"
#include "tool/workers.h"

namespace rasterproof::tool {
namespace {

using props::FamilyCell;
using props::FamilyResult;
using props::Yardstick;

constexpr std::array kYardsticks{Yardstick::kOwnModel, Yardstick::kRealGeometry};

std::string Displacement(double pixels) {
  return std::isfinite(pixels) ? fmt::format("{:.2g} px", pixels) : "ended";
}

// "fails 3 of 100, 1.0 to 8.5 %, 0.0017 px", "100 tested", "exhausted, 117649".
std::string CellText(const FamilyCell& cell) {
  if (cell.cases == 0) return cell.excused == 0 ? "not run" : "excused";
  if (cell.Fails()) {
    const report::Interval rate = report::ProportionInterval(cell.wrong, cell.cases);
    return fmt::format("fails {} of {}, {:.2g} to {:.2g} %, {}", cell.wrong, cell.cases,
                       100 * rate.low, 100 * rate.high, Displacement(cell.worst_pixels));
  }
  if (cell.is_exhausted) return fmt::format("exhausted, {}", cell.cases);
  return cell.excused == 0 ? fmt::format("{} tested", cell.cases)
                           : fmt::format("{} tested, {} excused", cell.cases, cell.excused);
}

std::string Table(const std::vector<props::Family>& families,
                  const std::vector<FamilyResult>& results) {
  std::string text;
  const props::Theme* theme = nullptr;
  for (std::size_t k = 0; k < families.size(); ++k) {
    if (families[k].theme != theme) {
      theme = families[k].theme;
      text += fmt::format("\n{}: {}\n", theme->name, theme->right);
    }
    text += fmt::format("  {:<22} {:<44} {}\n", families[k].name,
                        CellText(results[k].By(Yardstick::kOwnModel)),
                        CellText(results[k].By(Yardstick::kRealGeometry)));
  }
  return text;
}

struct Summary {
  std::array<std::size_t, 2> fails{};
  std::array<std::size_t, 2> stands{};
  std::array<std::size_t, 2> excused{};
};

Summary SummaryOf(const std::vector<FamilyResult>& results) {
  Summary sum;
  for (const FamilyResult& result : results) {
    for (std::size_t k = 0; k < result.cells.size(); ++k) {
      const FamilyCell& cell = result.cells[k];
      ++(cell.Fails() ? sum.fails : cell.cases != 0 ? sum.stands : sum.excused)[k];
    }
  }
  return sum;
}

std::string SummaryLine(const std::string& subject, const Summary& sum) {
  std::string line = subject + ":";
  for (std::size_t k = 0; k < props::kYardstickNames.size(); ++k) {
    line += fmt::format("{} {}: {} families stand, {} fail, {} excused", k == 0 ? "" : ";",
                        props::kYardstickNames[k], sum.stands[k], sum.fails[k], sum.excused[k]);
  }
  return line + "\n";
}

void SaveWorst(const std::string& folder, const std::string& subject,
               const std::vector<FamilyResult>& results) {
  io::MakeFolder(folder);
  for (const FamilyResult& result : results) {
    for (const Yardstick yardstick : kYardsticks) {
      const FamilyCell& cell = result.By(yardstick);
      if (!cell.worst) continue;
      Case worst = *cell.worst;
      const bool is_own = yardstick == Yardstick::kOwnModel;
      if (!is_own) worst.profile = props::RealProfileOf(worst.profile);
      io::WriteFile(fmt::format("{}/{}-{}-{}.json", folder, FileNameOf(subject), result.family,
                                is_own ? "own" : "real"),
                    io::CaseToJson({worst, subject, "CoverageEqualsTheModel"}));
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

}  // namespace

std::vector<FamilyResult> MeasureCatalogue(const SubjectFactory& subject,
                                           const std::vector<props::Family>& families,
                                           const props::CataloguePlan& plan, int jobs,
                                           Progress& progress) {
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

int CheckCatalogue(const CheckOptions& options) {
  const ResolvedCheck asked = ResolveCheck(options);
  if (!options.save.empty()) io::RequireFolderCanBe(options.save);
  const std::vector<props::Family> families = FamiliesNamed(options.families);
  props::CataloguePlan plan;
  plan.seed = options.campaign.seed;
  plan.cases = options.campaign.cases;
  plan.seconds = options.campaign.seconds;
  plan.stop = Interrupted;
  int status = kExitHolds;
  for (const SubjectFactory& subject : asked.subjects) {
    RequireSamples(subject.Make()->Info());
    Progress progress(static_cast<std::size_t>(options.jobs));
    const std::vector<FamilyResult> results =
        MeasureCatalogue(subject, families, plan, options.jobs, progress);
    const Summary sum = SummaryOf(results);
    io::WriteStandardOutput(report::CleanText(
        fmt::format("{}, seed {}, {} cases a family\n{:<25}{:<45}{}\n", subject.name(), plan.seed,
                    plan.cases, "", props::kYardstickNames[0], props::kYardstickNames[1]) +
        Table(families, results) + "\n" + SummaryLine(subject.name(), sum)));
    if (!options.save.empty()) SaveWorst(options.save, subject.name(), results);
    if (sum.fails[0] != 0) status = WorseStatus(status, kExitViolated);
    if (sum.stands[0] + sum.fails[0] == 0) status = WorseStatus(status, kExitInconclusive);
    if (Interrupted()) return WorseStatus(status, kExitInconclusive);
  }
  return status;
}

}  // namespace rasterproof::tool
