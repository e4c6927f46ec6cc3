// What `check --catalogue` does.
#ifndef RASTERPROOF_TOOL_CATALOGUE_H_
#define RASTERPROOF_TOOL_CATALOGUE_H_

#include <vector>

#include "props/catalogue/catalogue.h"
#include "tool/commands.h"
#include "tool/progress.h"
#include "tool/resolve.h"

namespace rasterproof::tool {

/// Measures the subject on every family, families at once on the crew's workers.
///
/// Returns:    by Catalogue()'s order; after an interrupt some results have no cases.
std::vector<props::FamilyResult> MeasureCatalogue(const SubjectFactory& subject,
                                                  const std::vector<props::Family>& families,
                                                  const props::CataloguePlan& plan, int jobs,
                                                  Progress& progress);

/// Prints each subject's table, and saves the worst case of each cell that fails.
///
/// Returns:    the exit status: violated if a cell of an own model fails.
int CheckCatalogue(const CheckOptions& options);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_CATALOGUE_H_
