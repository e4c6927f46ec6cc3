// The table of methods: every way of evaluating edge functions that the field uses.
#ifndef RASTERPROOF_REFERENCE_METHOD_H_
#define RASTERPROOF_REFERENCE_METHOD_H_

#include <span>
#include <string_view>

#include "core/coverage.h"
#include "core/draw_options.h"
#include "core/evaluators.h"
#include "core/scene.h"
#include "core/subject_info.h"

namespace rasterproof::reference {

/// Drawing options and the one choice that belongs to the method, not to the caller of a subject.
struct RasterOptions : DrawOptions {
  /// Evaluate every edge from its lexicographically smaller end, so that both triangles of a shared
  /// edge see the same number. Float methods only; exact ones have no use for it.
  bool canonical_edges = false;
};

/// One row of the table.
struct Method {
  std::string_view name;     ///< "f32-direct"
  std::string_view summary;  ///< one line
  /// Number format, profile (its own), window or clip space; whether it claims to be exact inside
  /// its proven domain, and what is proved of its edge arithmetic.
  SubjectInfo info;
  bool can_be_canonical = false;
  void (*draw)(const Scene&, const RasterOptions&, CoverageCounts&) = nullptr;
  const EdgeEvaluator* edges = nullptr;
  /// The same with canonical edges; nullptr unless can_be_canonical.
  const EdgeEvaluator* canonical_edges = nullptr;
};

/// Every method, cheapest arithmetic first.
std::span<const Method> Methods();
/// nullptr if there is none of that name.
const Method* FindMethod(std::string_view name);

}  // namespace rasterproof::reference

#endif  // RASTERPROOF_REFERENCE_METHOD_H_
