// Coverage that some other program wrote down: rows of integers, or a picture.
#ifndef RASTERPROOF_IO_COUNTS_FILE_H_
#define RASTERPROOF_IO_COUNTS_FILE_H_

#include <string>

#include "core/coverage.h"

namespace rasterproof::io {

/// A target's coverage, as read from a file.
struct CountsFile {
  CoverageCounts counts;  ///< in `front`
  bool is_mask = false;   ///< 1 where a picture differs from its background: not how often
};

/// Reads the output of `rasterproof coverage`: the count of every sample, row by row from the top,
/// the samples of a pixel side by side. Or reads a PNG picture with one sample in a pixel: pixels
/// that do not have the background's colour are covered.
///
/// Domain:     the file has the requested shape; `background` is RRGGBB in hexadecimal.
/// Error:      InputError with the line and its fault.
CountsFile ReadCounts(const std::string& path, int width, int height, int samples,
                      const std::string& background);

}  // namespace rasterproof::io

#endif  // RASTERPROOF_IO_COUNTS_FILE_H_
