// A set of samples as rows of bits, in hexadecimal.
#ifndef RASTERPROOF_CORE_SAMPLE_ROWS_H_
#define RASTERPROOF_CORE_SAMPLE_ROWS_H_

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rasterproof {

/// The rows from the first that has a sample of the set to the last; none if the set is empty.
///
/// Bit k of a row is the k-th sample of that row of the target: column times samples a pixel plus
/// sample. A row is that number in hexadecimal, the most significant digit first.
struct SampleRows {
  std::size_t top = 0;            ///< the row of the target that `rows` begins with
  std::vector<std::string> rows;  ///< all of the same length: a digit for each four samples
};

/// Domain:     `samples` in rising order; `row_length` samples in a row of the target.
SampleRows RowsOf(const std::vector<std::size_t>& samples, std::size_t row_length);

/// The digits of one row, with those of `samples` that lie in it.
std::string RowOf(const std::vector<std::size_t>& samples, std::size_t row, std::size_t row_length);

/// Adds the samples of a row's digits to `samples`, in rising order.
///
/// Returns:    why the text is no row of that length; empty if it is one. Leading zeros may be
///             missing, capital letters are read.
std::string_view AddRow(std::string_view digits, std::size_t row, std::size_t row_length,
                        std::vector<std::size_t>& samples);

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_SAMPLE_ROWS_H_
