// A subject that keeps a digest of all that it is asked.
#ifndef RASTERPROOF_TESTS_BASELINE_RECORDING_H_
#define RASTERPROOF_TESTS_BASELINE_RECORDING_H_

#include <memory>

#include "core/subject.h"
#include "tests/baseline/digest.h"

namespace rasterproof::baseline {

/// What reached a subject, in the order in which it came.
struct Record {
  /// Scenes to draw as a rasterizer sees them, whichever call they came by.
  Stream draws;
  /// Calls as they were made, indices and unused vertices included.
  Stream calls;
  // Queries, each kind by itself: no two kinds have an order among them. Bounds are no queries.
  Stream edges;
  Stream steps;
  Stream barycentrics;
  Stream interpolations;
  Stream distances;
};

/// Passes every call on to the given subject, and adds it to the record.
///
/// Domain:     a subject that wraps no other one; a record that outlives this.
std::unique_ptr<Subject> Recording(std::unique_ptr<Subject> subject, Record& record);

}  // namespace rasterproof::baseline

#endif  // RASTERPROOF_TESTS_BASELINE_RECORDING_H_
