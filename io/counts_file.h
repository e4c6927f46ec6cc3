// Coverage that some other program wrote down: rows of integers, or a picture.
#ifndef RASTERPROOF_IO_COUNTS_FILE_H_
#define RASTERPROOF_IO_COUNTS_FILE_H_

#include <string>

#include "core/coverage.h"

namespace rasterproof::io {

/// What a file says of a target's coverage.
struct CountsFile {
  CoverageCounts counts;  ///< in `front`
  bool is_mask = false;   ///< 1 where a picture differs from its background: not how often
};

/// Reads what `rasterproof coverage` writes: the count of every sample, row by row from the top,
/// the samples of a pixel side by side. Or a PNG picture of one sample a pixel: what is not of the
/// background's colour is covered.
///
/// Domain:     the file has the shape that is asked for; `background` is RRGGBB in hexadecimal.
/// Error:      InputError with the line and what is wrong there.
CountsFile ReadCounts(const std::string& path, int width, int height, int samples,
                      const std::string& background);

}  // namespace rasterproof::io

#endif  // RASTERPROOF_IO_COUNTS_FILE_H_
