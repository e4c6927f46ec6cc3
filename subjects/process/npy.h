// Arrays in NumPy's format NPY, on a pipe: a head that says what follows, and the numbers' bytes.
#ifndef RASTERPROOF_SUBJECTS_PROCESS_NPY_H_
#define RASTERPROOF_SUBJECTS_PROCESS_NPY_H_

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "subjects/process/protocol.h"

namespace rasterproof::subjects {

/// Returns an array of two dimensions as NPY 1.0: little-endian, row by row.
///
/// Domain:     numbers.size() is a multiple of `columns`.
std::string NpyOf(std::span<const double> numbers, std::size_t columns);
std::string NpyOf(std::span<const std::int32_t> numbers, std::size_t columns);

/// Reads an array of integers or booleans, of 1 to 8 bytes, row by row.
///
/// Domain:     `shapes` are those allowed, each of equally many numbers.
/// Error:      SubjectStop (it broke down) if what comes is not such an array, with what it is and
///             what is wanted.
std::vector<std::int64_t> ReadNpyIntegers(std::span<const std::vector<std::size_t>> shapes,
                                          const NextBytes& next_bytes);

/// Reads an array of doubles of rows times columns.
///
/// Error:      as ReadNpyIntegers.
std::vector<double> ReadNpyDoubles(std::size_t rows, std::size_t columns,
                                   const NextBytes& next_bytes);

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_PROCESS_NPY_H_
