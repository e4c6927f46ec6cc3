// rasterproof compare: cases by yardsticks. Rows are the families of stiff cases, scenes, or
// floating-point modes.
#include "tool/compare/cmd_compare.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/comparison.h"
#include "core/error.h"
#include "core/float_mode.h"
#include "core/suggestion.h"
#include "fmt/format.h"
#include "io/output.h"
#include "props/compare/families.h"
#include "props/compare/yardsticks.h"
#include "props/run/description.h"
#include "report/comparison.h"
#include "tool/compare/comparison.h"
#include "tool/compare/float_modes.h"
#include "tool/environment.h"
#include "tool/exit_status.h"
#include "tool/file_names.h"
#include "tool/interrupt.h"
#include "tool/progress.h"
#include "tool/resolve.h"
#include "tool/scene_source.h"

namespace rasterproof::tool {
namespace {

std::vector<props::Family> FamiliesNamed(const std::vector<std::string>& names) {
  std::vector<props::Family> all = props::Families();
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

// What the options name, once for all subjects.
class Asked {
 public:
  explicit Asked(const CompareOptions& options)
      : options_(options), modes_(ModesNamed(options.modes)) {
    plan_.seed = options.campaign.seed;
    plan_.cases = options.campaign.cases;
    plan_.limits = {.seconds = options.campaign.seconds, .stop = Interrupted};
    for (const std::string& path : options.scenes) {
      SceneOptions scene;
      scene.path = path;
      scenes_.push_back(LoadScene(scene));
    }
    if (scenes_.empty() || !options.families.empty()) {
      families_ = FamiliesNamed(options.families);
    }
    for (std::size_t k = 0; k < scenes_.size(); ++k) {
      static constexpr props::Theme kScenes{"scenes", "It covers what exact geometry covers."};
      families_.push_back({options.scenes[k], "", &kScenes, nullptr, nullptr, &scenes_[k]});
    }
    for (const std::string& name : options.by) AddColumn(name);
  }

  ComparisonTable Head() const {
    const bool by_modes = !modes_.empty();
    ComparisonTable table =
        by_modes ? TableOf({}, WaysOfModes(false), plan_) : TableOf(families_, columns_, plan_);
    if (by_modes) {
      table.what = "modes";
      table.one = "mode";
    } else if (scenes_.size() == families_.size()) {
      table.what = "scenes";
      table.one = "scene";
    }
    for (const FloatMode mode : modes_) {
      table.rows.push_back({std::string(FloatModeName(mode)), "", "", ""});
    }
    return table;
  }

  std::vector<Column> ColumnsFor(const SubjectInfo& info) const {
    if (modes_.empty()) return columns_;
    return WaysOfModes(info.states_exact || options_.fail_on == FailOn::kQuality);
  }

  std::vector<std::vector<Cell>> CellsOf(const SubjectFactory& subject,
                                         const ComparisonTable& table) const {
    if (modes_.empty()) {
      RequireSamples(subject.Make()->Info());
      return CompareFamilies(subject, families_, columns_, plan_, options_.jobs);
    }
    Progress progress(1);
    return CompareModes(subject, modes_, table, plan_.limits, progress);
  }

 private:
  void AddColumn(const std::string& name) {
    std::vector<Column> known = OwnAndReal();
    const auto found = std::ranges::find(known, name, &Column::file);
    if (found != known.end()) return columns_.push_back(std::move(*found));
    // Each worker's own: subjects are called by one thread at a time.
    const SubjectFactory other = ResolveSubject(name);
    columns_.push_back({.name = name,
                        .file = FileNameOf(name),
                        .property = "",
                        .make = [other](Subject& subject) -> props::Yardstick {
                          const std::shared_ptr<Subject> made = other.Make();
                          return [made,
                                  by = props::AnotherSubject(props::DescriptionOf(subject), *made)](
                                     const props::CaseAtHand& at) { return by(at); };
                        }});
  }

  const CompareOptions& options_;
  std::vector<FloatMode> modes_;
  props::FamilyPlan plan_;
  std::vector<Scene> scenes_;
  std::vector<props::Family> families_;
  std::vector<Column> columns_;
};

int StatusOf(const ComparedSubject& subject, const std::vector<Column>& columns) {
  int status = kExitHolds;
  bool is_compared = false;
  for (const std::vector<Cell>& row : subject.cells) {
    is_compared = is_compared || row.front().cases != 0;
    for (std::size_t y = 0; y < columns.size(); ++y) {
      if (columns[y].convicts && row[y].Fails()) status = WorseStatus(status, kExitViolated);
    }
  }
  return is_compared ? status : WorseStatus(status, kExitInconclusive);
}

}  // namespace

int RunCompare(const CompareOptions& options) {
  RequireHonestEnvironment();
  if (!options.save.empty()) io::RequireFolderCanBe(options.save);
  io::RequireFileCanBe(options.json);
  const Asked asked(options);
  std::vector<SubjectFactory> subjects;
  for (const std::string& name : options.subjects) {
    subjects.push_back(ResolveSubject(name, options.profile, options.device, options.list_length));
  }
  ComparisonTable table = asked.Head();
  int status = kExitHolds;
  for (const SubjectFactory& subject : subjects) {
    if (Interrupted()) break;
    const std::vector<Column> columns = asked.ColumnsFor(subject.Make()->Info());
    table.subjects.push_back({subject.name(), asked.CellsOf(subject, table)});
    TellNewest(table, columns, options.json, options.save);
    status = WorseStatus(status, StatusOf(table.subjects.back(), columns));
  }
  if (!options.json.empty()) io::WriteOutput(options.json, report::ComparisonToJson(table));
  return Interrupted() ? WorseStatus(status, kExitInconclusive) : status;
}

}  // namespace rasterproof::tool
