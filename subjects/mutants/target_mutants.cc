// Bugs in what a draw does to its target: scissor, culling, sizes, threads, writes.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "subjects/mutants/mutant.h"

namespace rasterproof::subjects::mutants {
namespace {

FixedStages Changing(void (*options)(DrawOptions&, const Scene&)) { return {{.options = options}}; }
FixedStages Dropping(bool (*is_dropped)(const Sample&)) {
  return {{.times = [is_dropped](const Sample& at, const GridTriangle&) {
    return is_dropped(at) ? 0U : 1U;
  }}};
}
// A rectangle of the whole target if the options name none.
PixelRect Rect(const DrawOptions& options, const Scene& scene) {
  return options.scissor.value_or(PixelRect{0, 0, scene.width, scene.height});
}

std::vector<Mutant> Scissors() {
  return {
      {"scissor-ignored", "the scissor is ignored", "",
       Changing([](DrawOptions& options, const Scene&) { options.scissor.reset(); }), "scissor"},
      {"scissor-right-inclusive", "the scissor's right edge is inclusive", "",
       Changing([](DrawOptions& options, const Scene& scene) {
         options.scissor = Rect(options, scene);
         ++options.scissor->x1;
       }),
       "scissor", "ScissorOnlyCutsCoverage|DrawStaysInsideItsTarget"},
      {"scissor-bottom-early", "the scissor ends one row early", "",
       Changing([](DrawOptions& options, const Scene&) {
         if (options.scissor) --options.scissor->y1;
       }),
       "scissor"},
      {"scissor-swapped", "the scissor's axes are exchanged", "",
       Changing([](DrawOptions& options, const Scene&) {
         if (!options.scissor) return;
         std::swap(options.scissor->x0, options.scissor->y0);
         std::swap(options.scissor->x1, options.scissor->y1);
       }),
       "scissor"},
      {"cull-exchanged", "culling takes front for back", "",
       Changing([](DrawOptions& options, const Scene&) {
         if (options.cull == Cull::kNone) return;
         options.cull = options.cull == Cull::kFront ? Cull::kBack : Cull::kFront;
       }),
       "culling", "CullingRemovesOneFacing"},
      {"cull-ignored-without-scissor", "back faces are culled only where there is a scissor", "",
       Changing([](DrawOptions& options, const Scene&) {
         if (!options.scissor && options.cull == Cull::kBack) options.cull = Cull::kNone;
       }),
       "culling"},
  };
}

// NOLINTNEXTLINE(readability-function-size): a table
std::vector<Mutant> Targets() {
  return {
      {"target-first-row", "the first row is never drawn", "",
       Dropping([](const Sample& at) { return at.row == 0; }), "target-border"},
      {"target-first-column", "the first column is never drawn", "",
       Dropping([](const Sample& at) { return at.x == 0; }), "target-border"},
      {"target-last-column", "the last column is never drawn", "",
       FixedStages{{.box = [](PixelRect& box, const GridTriangle&,
                              const Scene& scene) { box.x1 = std::min(box.x1, scene.width - 1); }}},
       "target-border"},
      {"target-last-row", "the last row is never drawn", "",
       FixedStages{
           {.box = [](PixelRect& box, const GridTriangle&,
                      const Scene& scene) { box.y1 = std::min(box.y1, scene.height - 1); }}},
       "target-border", "TargetHeightKeepsCoverage"},
      {"target-odd-width", "targets of odd width lose their last column", "",
       FixedStages{{.box =
                        [](PixelRect& box, const GridTriangle&, const Scene& scene) {
                          box.x1 = std::min(box.x1, scene.width - scene.width % 2);
                        }}},
       "target-border", "TargetWidthKeepsCoverage"},
      {"target-2048", "pixels from column 2048 on are never drawn", "llvmpipe 1165ff1",
       Dropping([](const Sample& at) { return at.x >= 2048; }), "target-border"},
      {"target-single-pixel", "a target of one column is not drawn", "",
       FixedStages{{.box =
                        [](PixelRect& box, const GridTriangle&, const Scene& scene) {
                          if (scene.width == 1) box.x1 = box.x0;
                        }}},
       "target-border"},
      {"target-wraps", "a span ends on a multiple of four pixels, in the next row if need be",
       "keeperfx #4668",
       FixedStages{{.index =
                        [](const CoverageCounts& counts, const Sample& at) {
                          const bool last = at.x == counts.width - 1 && counts.width % 4 == 3;
                          return counts.Index(at.x + (last ? 1 : 0), at.row, at.s);
                        }}}},
      {"target-index-in-float", "the index of a sample is rounded to float32", "",
       FixedStages{{.index =
                        [](const CoverageCounts& counts, const Sample& at) {
                          const auto index = counts.Index(at.x, at.row, at.s);
                          return static_cast<std::size_t>(static_cast<float>(index));
                        }}},
       "target-border", "LargeTargetIsCoveredLikeASmallOne"},
      {"target-bins-of-8-bits", "the number of a tile of 256 x 256 pixels is kept in 8 bits", "",
       FixedStages{{.index =
                        [](const CoverageCounts& counts, const Sample& at) {
                          const int columns = (counts.width + 255) / 256;
                          const int kept = (at.row / 256 * columns + at.x / 256) % 256;
                          const int x = kept % columns * 256 + at.x % 256;
                          return counts.Index(std::min(x, counts.width - 1),
                                              kept / columns * 256 + at.row % 256, at.s);
                        }}},
       "target-border", "LargeTargetIsCoveredLikeASmallOne"},
      {"target-overwritten", "counts are written, not added to", "",
       FixedStages{{.after =
                        [](CoverageCounts& counts, const CoverageCounts& before) {
                          for (std::size_t k = 0; k < counts.size(); ++k) {
                            if (counts.front[k] != before.front[k]) counts.front[k] = 1;
                          }
                        }}},
       "counting", "DrawStaysInsideItsTarget"},
      {"target-touched", "the first span of front faces is one sample too long", "",
       FixedStages{{.after =
                        [](CoverageCounts& counts, const CoverageCounts& before) {
                          for (std::size_t k = 1; k < counts.size(); ++k) {
                            const bool drawn = counts.front[k - 1] != before.front[k - 1];
                            if (!drawn || counts.front[k] != before.front[k]) continue;
                            ++counts.front[k];
                            return;
                          }
                        }}}},
      {"target-not-clear", "a draw into a target that holds something leaves out the first row", "",
       FixedStages{{.after =
                        [](CoverageCounts& counts, const CoverageCounts& before) {
                          if (std::ranges::all_of(before.front, [](auto n) { return n == 0; })) {
                            return;
                          }
                          const auto row = static_cast<std::ptrdiff_t>(counts.Index(0, 1));
                          std::copy(before.front.begin(), before.front.begin() + row,
                                    counts.front.begin());
                        }}},
       "target-contents"},
      {"target-every-third-draw", "every third draw leaves out the first row", "",
       FixedStages{{.options =
                        [draws = 0](DrawOptions& options, const Scene& scene) mutable {
                          if (++draws % 3 != 0) return;
                          options.scissor = Rect(options, scene);
                          options.scissor->y0 = std::max(1, options.scissor->y0);
                        }}},
       "earlier-draws", "EqualDrawsGiveEqualCounts"},
  };
}

std::vector<Mutant> Threads() {
  return {
      {"threads-last-row", "the last of several threads leaves out its last row", "",
       FixedStages{{.share =
                        [](int&, int& end, int worker, int workers) {
                          if (workers > 1 && worker == workers - 1) --end;
                        }}},
       "threads", "ThreadCountKeepsCoverage"},
      {"threads-overlap", "from three threads on two of them draw the row between them", "",
       FixedStages{{.share =
                        [](int& begin, int& end, int worker, int workers) {
                          if (workers >= 3 && worker == 1 && begin < end) --begin;
                        }}},
       "threads"},
      {"threads-of-eight", "the last of eight threads leaves out two rows", "",
       FixedStages{{.share =
                        [](int&, int& end, int worker, int workers) {
                          if (workers == 8 && worker == 7) end -= 2;
                        }}},
       "threads"},
  };
}

std::vector<Mutant> TargetMutants() {
  std::vector<Mutant> table = Scissors();
  for (Mutant& planted : Targets()) table.push_back(std::move(planted));
  for (Mutant& planted : Threads()) table.push_back(std::move(planted));
  return table;
}

}  // namespace

extern constinit const MutantTable kTargetMutants{MutantKind::kPlanted, 5, TargetMutants};

}  // namespace rasterproof::subjects::mutants
