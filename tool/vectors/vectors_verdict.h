// Whether answers contradict what vectors state.
#ifndef RASTERPROOF_TOOL_VECTORS_VECTORS_VERDICT_H_
#define RASTERPROOF_TOOL_VECTORS_VECTORS_VERDICT_H_

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/test_vector.h"
#include "io/vectors_file.h"

namespace rasterproof::tool {

/// What a look at all answers found. No contradiction is no acquittal: the samples that a vector
/// leaves open need one model that explains all of them, which no list of samples says.
struct VectorsVerdict {
  std::vector<std::string> contradictions;  ///< a line each, the first ones
  std::uint64_t contradicted = 0;  ///< all of them: (triangle, sample), or joint constraint
  std::uint64_t cases_contradicted = 0;
  std::uint64_t cases = 0;    ///< with an answer for each triangle
  std::uint64_t partly = 0;   ///< cases with answers for some triangles
  std::uint64_t missing = 0;  ///< triangles without an answer
  std::uint64_t joint = 0;    ///< joint constraints looked at
};

/// What a rasterizer covered.
struct VectorsDrawn {
  io::VectorAnswers triangles;
  /// Where triangles were drawn in calls of their own, joint constraints are not about them: a
  /// legal rasterizer may place a vertex otherwise in another call.
  bool in_one_call = true;
  /// By vector: how often each sample was counted as all its triangles were drawn in one call. Its
  /// joint constraints are then judged by that.
  std::map<std::size_t, std::vector<std::uint32_t>> together = {};
};

/// Judges what was drawn; keeps the first `shown` contradictions as lines.
VectorsVerdict JudgeDrawn(const io::VectorsFile& file, const VectorsDrawn& drawn,
                          std::uint64_t shown);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_VECTORS_VECTORS_VERDICT_H_
