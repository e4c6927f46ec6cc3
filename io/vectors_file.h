// Reads files of test vectors, and of a rasterizer's answers to them.
#ifndef RASTERPROOF_IO_VECTORS_FILE_H_
#define RASTERPROOF_IO_VECTORS_FILE_H_

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/test_vector.h"

namespace rasterproof::io {

/// A file of vectors as `vectors generate --format jsonl` writes it.
struct VectorsFile {
  VectorsHeader header;
  std::vector<TestVector> vectors;  ///< each with another name
};

/// Reads the text of such a file, but for its values; `place` names it in errors.
///
/// Error:      InputError, with the line, for another version, a hash that is not the body's, and
///             whatever the writer would not have written.
VectorsFile ParseVectors(std::string_view text, const std::string& place);

/// The samples that each triangle of each vector covered, in rising order, by (index of the vector,
/// triangle). Nothing of triangles that were not drawn.
using VectorAnswers = std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>>;

/// Reads lines {"case": NAME, "triangle": K, "top": ROW, "rows": [HEX, ...]}; rows as of vectors,
/// and rows that are left out have no covered sample. Empty lines are passed over.
///
/// Returns:    by (index of the vector, triangle).
/// Error:      InputError, with the line, for a case or triangle that the vectors do not have, for
///             a second answer to one, for rows outside the target.
VectorAnswers ParseAnswers(std::string_view text, const std::string& place,
                           const std::vector<TestVector>& vectors);

}  // namespace rasterproof::io

#endif  // RASTERPROOF_IO_VECTORS_FILE_H_
