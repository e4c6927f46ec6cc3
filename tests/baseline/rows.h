// The rows of a dump: one a case, of columns that tabs part.
#ifndef RASTERPROOF_TESTS_BASELINE_ROWS_H_
#define RASTERPROOF_TESTS_BASELINE_ROWS_H_

#include <cstdint>
#include <string>
#include <vector>

#include "tests/baseline/subjects.h"

namespace rasterproof::baseline {

struct DumpOptions {
  std::vector<std::uint64_t> seeds{1, 2, 3};
  std::uint64_t cases = 64;      ///< a property and seed
  std::uint64_t bug_cases = 16;  ///< the same for subjects with a bug
  bool digests = false;          ///< one row a property: how many rows, and their digest
};

/// The first row: the names of the columns. Those of scripts/compare_dumps.
std::string HeaderRow(const DumpOptions& options);

/// All rows of the property about the subject, which is made afresh for each seed. None if it is
/// not asked about that property.
std::string PropertyRows(const NamedSubject& subject, const std::string& property,
                         const DumpOptions& options);

}  // namespace rasterproof::baseline

#endif  // RASTERPROOF_TESTS_BASELINE_ROWS_H_
