// The page's part on error against run time, in the order of a reader's questions.
#ifndef RASTERPROOF_REPORT_BENCH_PAGE_H_
#define RASTERPROOF_REPORT_BENCH_PAGE_H_

#include <string>
#include <string_view>
#include <vector>

#include "core/bench_result.h"
#include "core/scene.h"

namespace rasterproof::report {

/// A wrong decision as a separate scene, beside the page.
struct BenchCase {
  std::string file;  ///< as a path from the page: "bench/fan-f32-affine.json"
  Scene scene;
};

/// The worst known case of each method on each family, and the case of each cliff.
std::vector<BenchCase> BenchCases(const BenchResult& bench);

/// What proved coverage costs, in a sentence. Empty if no family has a proved method.
std::string BenchSentence(const BenchResult& bench);

/// Returns the sections. `folder` is the page's folder, as a shell word: commands lead there.
std::string BenchSections(const BenchResult& bench, std::string_view folder);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_BENCH_PAGE_H_
