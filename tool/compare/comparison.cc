#include "tool/compare/comparison.h"

#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>

#include "core/error.h"
#include "fmt/format.h"
#include "props/compare/yardsticks.h"
#include "props/run/description.h"
#include "report/picture.h"
#include "tool/failure.h"
#include "tool/file_names.h"
#include "tool/interrupt.h"
#include "tool/progress.h"
#include "tool/workers.h"

namespace rasterproof::tool {
namespace {

// A failing case of a family, and whose it is.
struct Worst {
  double pixels = -1;
  Case value;
  const SubjectFactory* subject = nullptr;
};

void KeepWorst(const SubjectFactory& subject, const std::vector<Cell>& cells,
               const std::vector<Column>& columns, Worst& worst) {
  for (std::size_t y = 0; y < cells.size(); ++y) {
    const Cell& cell = cells[y];
    if (!cell.worst || cell.ended != 0 || cell.furthest <= worst.pixels) continue;
    const Case& c = *cell.worst;
    worst = {cell.furthest, columns[y].judged ? columns[y].judged(c) : c, &subject};
  }
}

std::optional<report::FamilyPicture> PictureOf(const Worst& worst) {
  if (worst.subject == nullptr) return std::nullopt;
  const std::unique_ptr<Subject> subject = worst.subject->Make();
  try {
    Verdict verdict;
    See(*subject, worst.value, verdict);
    report::Explanation explanation = Explain(subject->Info(), worst.value, verdict, "");
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

// Proofs are of the decisions under the subject's own model.
void MarkProved(const SubjectInfo& info, std::vector<Cell>& cells) {
  if (!info.states_exact || info.proofs.empty()) return;
  const bool is_real = SameModel(info.profile, props::RealProfileOf(info.profile));
  for (std::size_t y = 0; y < cells.size(); ++y) {
    cells[y].is_proved = !cells[y].Fails() && (y == 0 || is_real);
  }
}

}  // namespace

std::vector<Column> OwnAndReal() {
  const char* const property = "CoverageEqualsTheModel";
  return {{.name = "own model",
           .file = "own",
           .property = property,
           .make = [](Subject& s) { return props::OwnModel(props::DescriptionOf(s)); }},
          {.name = "real geometry",
           .file = "real",
           .property = property,
           .convicts = false,
           .judged =
               [](Case c) {
                 c.profile = props::RealProfileOf(c.profile);
                 return c;
               },
           .make = [](Subject& s) { return props::RealGeometry(props::DescriptionOf(s)); }}};
}

std::vector<std::vector<Cell>> CompareFamilies(const SubjectFactory& subject,
                                               const std::vector<props::Family>& families,
                                               const std::vector<Column>& columns,
                                               const props::FamilyPlan& plan, int jobs) {
  Progress progress(static_cast<std::size_t>(jobs));
  Crew crew(jobs, [&](std::size_t) { return subject.Make(); });
  std::vector<std::vector<Cell>> cells(families.size(), std::vector<Cell>(columns.size()));
  const auto order = OrderOfWork(jobs, families.size(),
                                 [&](std::size_t k) { return families[k].world != nullptr; });
  ShareWork(jobs, order, [&](std::size_t worker, std::size_t k) {
    if (Interrupted()) return;
    progress.Stage(fmt::format("{} {}", subject.name(), families[k].name), 0, worker);
    std::vector<props::Yardstick> yardsticks;
    for (const Column& column : columns) yardsticks.push_back(column.make(crew.Of(worker)));
    cells[k] = props::CompareFamily(crew.Of(worker), families[k], yardsticks, plan);
    MarkProved(crew.Of(worker).Info(), cells[k]);
    progress.Stage("", 0, worker);
  });
  return cells;
}

ComparisonTable TableOf(const std::vector<props::Family>& families,
                        const std::vector<Column>& columns, const props::FamilyPlan& plan) {
  ComparisonTable table;
  table.seed = plan.seed;
  table.cases = plan.cases;
  for (const Column& column : columns) table.yardsticks.push_back(column.name);
  for (const props::Family& family : families) {
    const auto& [theme, right] = *family.theme;
    table.rows.push_back({std::string(family.name), std::string(family.summary), std::string(theme),
                          std::string(right)});
  }
  return table;
}

report::Catalogue MeasureCatalogues(const std::vector<SubjectFactory>& subjects,
                                    const props::FamilyPlan& plan, int jobs) {
  const std::vector<props::Family> families = props::Families();
  const std::vector<Column> columns = OwnAndReal();
  report::Catalogue catalogue{TableOf(families, columns, plan), {}, {}};
  std::vector<Worst> worst(families.size());
  for (const SubjectFactory& subject : subjects) {
    const SubjectInfo info = subject.Make()->Info();
    if (info.profile.squares || Interrupted()) continue;
    std::vector<std::vector<Cell>> cells = CompareFamilies(subject, families, columns, plan, jobs);
    for (std::size_t k = 0; k < families.size(); ++k) {
      KeepWorst(subject, cells[k], columns, worst[k]);
    }
    catalogue.table.subjects.push_back({info.name, std::move(cells)});
    catalogue.folders.push_back(FileNameOf(info.name));
  }
  for (const Worst& one : worst) catalogue.pictures.push_back(PictureOf(one));
  return catalogue;
}

}  // namespace rasterproof::tool
