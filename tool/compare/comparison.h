// What `compare` and `certify --catalogue` share: the families of stiff cases by own model, by real
// geometry and by other subjects.
#ifndef RASTERPROOF_TOOL_COMPARE_COMPARISON_H_
#define RASTERPROOF_TOOL_COMPARE_COMPARISON_H_

#include <functional>
#include <string>
#include <vector>

#include "core/case.h"
#include "core/comparison.h"
#include "props/compare/compare.h"
#include "props/compare/families.h"
#include "report/comparison.h"
#include "tool/resolve.h"

namespace rasterproof::tool {

/// A yardstick of a table.
struct Column {
  std::string name;      ///< "own model"
  std::string file;      ///< of its saved cases, the end of their names; empty: as without
  std::string property;  ///< that a saved case is about
  bool convicts = true;  ///< what it finds wrong fails the run
  bool is_saved = true;  ///< a replay shows its cases again
  /// The case as it judges it. Empty: as it is.
  std::function<Case(Case)> judged = {};
  /// For the subject of one worker. Empty: the cells come from elsewhere.
  std::function<props::Yardstick(Subject& subject)> make = {};
};

/// "own" and "real", in this order.
std::vector<Column> OwnAndReal();

/// The cells of the families, in their order, by column. After an interrupt some have no cases.
std::vector<std::vector<Cell>> CompareFamilies(const SubjectFactory& subject,
                                               const std::vector<props::Family>& families,
                                               const std::vector<Column>& columns,
                                               const props::FamilyPlan& plan, int jobs);

/// A table of these rows and columns, without subjects.
ComparisonTable TableOf(const std::vector<props::Family>& families,
                        const std::vector<Column>& columns, const props::FamilyPlan& plan);

/// Prints the newest subject of the table, unless JSON takes standard output's place, and saves its
/// worst cases in the folder, unless that is empty.
void TellNewest(const ComparisonTable& table, const std::vector<Column>& columns,
                const std::string& json, const std::string& folder);

/// All families: a column for each subject whose profile is about samples, with the folder of its
/// page beside the report, and for each family a picture of its worst case.
///
/// Returns:    after an interrupt, what was measured until then.
report::Catalogue MeasureCatalogues(const std::vector<SubjectFactory>& subjects,
                                    const props::FamilyPlan& plan, int jobs);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_COMPARE_COMPARISON_H_
