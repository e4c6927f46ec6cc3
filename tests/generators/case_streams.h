// Ways of drawing test cases that docs/generators.md compares. None knows what it is put to.
#ifndef RASTERPROOF_TESTS_GENERATORS_CASE_STREAMS_H_
#define RASTERPROOF_TESTS_GENERATORS_CASE_STREAMS_H_

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "core/case.h"
#include "core/subject_info.h"
#include "props/property.h"

namespace rasterproof::generators {

/// What a tester writes in five minutes draws onto a target of this side, with vertices in the
/// target and half as much around it.
inline constexpr int kSide = 32;

/// Cases, one after the other.
class CaseStream {
 public:
  virtual ~CaseStream() = default;
  /// The next case, with the subject's profile. One that is passed over, as fuzz targets do with
  /// large ones (fuzz::Limits), has no triangles.
  virtual Case Next() = 0;
};

/// "uniform", "rapidcheck", "domains", "code-bytes", "raw-bytes".
///
///   uniform      x and y uniform in [-kSide/2, 3 kSide/2), of the subject's precision. Even odds
///                for one triangle, or a quad split by its diagonal. In clip space they are
///                multiplied by a w uniform in [1/8, 8).
///   rapidcheck   the same scenes; every coordinate is rc::gen::arbitrary, sizes 0 to 100 in turn
///   domains      what `check` draws for the properties, a case for each in turn
///   code-bytes   one to 128 random bytes, decoded as fuzz targets decode them
///   raw-bytes    the same bytes as fuzz::FloatsOf takes them
std::span<const std::string_view> StreamNames();

/// The stream of that name, or nullptr. The seed alone decides what is drawn.
///
/// Domain:     at least one property, each with domains that the subject takes.
std::unique_ptr<CaseStream> MakeStream(std::string_view name, const SubjectInfo& info,
                                       const std::vector<const props::Property*>& properties,
                                       std::uint64_t seed);

}  // namespace rasterproof::generators

#endif  // RASTERPROOF_TESTS_GENERATORS_CASE_STREAMS_H_
