// The code itself: any bytes are a case that the subject takes, and the bytes of that case are it.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/case.h"
#include "core/subject_info.h"
#include "fuzz/fuzz_target.h"
#include "props/codec/codec.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace rasterproof;  // NOLINT: a whole program
  using rasterproof::fuzz::Bound;
  using rasterproof::fuzz::Checked;
  // They lend their lattices: of float32, of float64, of a grid, of fixed point, of clip space.
  constexpr std::string_view kAny = "CoverageEqualsTheModel";
  static const Bound bound(std::to_array<Checked>({{"f32-direct", kAny},
                                                   {"spans-exact", kAny},
                                                   {"i64-snap8", kAny},
                                                   {"legal:fixed-wraps", kAny},
                                                   {"hom-f32", kAny},
                                                   {"hom-exact", kAny}}));
  return bound.ForEachCase(std::span(data, size), [](const fuzz::Group& group, const Case& c) {
    if (!Takes(group.info, c.scene)) fuzz::Fail("the subject does not take the decoded case");
    const std::vector<std::uint8_t> bytes = props::EncodeCase(c, group.info);
    if (!props::SameCase(props::DecodeCase(bytes, group.info), c)) {
      fuzz::Fail("the case's own bytes are another case");
    }
  });
}
