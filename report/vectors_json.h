// Test vectors as lines of JSON.
#ifndef RASTERPROOF_REPORT_VECTORS_JSON_H_
#define RASTERPROOF_REPORT_VECTORS_JSON_H_

#include <cstdint>
#include <string>
#include <string_view>

#include "core/test_vector.h"

namespace rasterproof::report {

/// The first line of a file, about the lines after it, whose hash it states.
std::string VectorsHeaderLine(const VectorsHeader& header, std::string_view body);

/// A vector's line, and a line for each of its joint constraints.
std::string VectorLines(const TestVector& vector, const VectorsHeader& header);

/// "exactly one of triangles 0 and 1 covers it", "0 or 2 of triangles 0, 1, 4 cover it".
std::string JointText(const JointVector& joint);

/// "ccw", "cw" or "none".
std::string_view FacingWord(int facing);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_VECTORS_JSON_H_
