// What `check --catalogue` and `certify --catalogue` do.
#ifndef RASTERPROOF_TOOL_CHECK_CATALOGUE_H_
#define RASTERPROOF_TOOL_CHECK_CATALOGUE_H_

#include <vector>

#include "props/catalogue/catalogue.h"
#include "report/catalogue.h"
#include "tool/commands.h"
#include "tool/resolve.h"

namespace rasterproof::tool {

/// All families: a column for each subject whose profile is about samples, with the folder of its
/// page beside the report, and for each family a picture of its worst case.
///
/// Returns:    after an interrupt, what was measured until then.
report::Catalogue MeasureCatalogues(const std::vector<SubjectFactory>& subjects,
                                    const props::CataloguePlan& plan, int jobs);

/// Prints each subject's table, and saves the worst case of each cell that fails.
///
/// Returns:    the exit status: violated if a cell of an own model fails.
int CheckCatalogue(const CheckOptions& options);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_CHECK_CATALOGUE_H_
