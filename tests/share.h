// How many of its cases a test runs in this build.
#ifndef RASTERPROOF_TESTS_SHARE_H_
#define RASTERPROOF_TESTS_SHARE_H_

#include <algorithm>
#include <cstdlib>

namespace rasterproof {

// Sanitizers cost a factor of about ten; one case in sixteen keeps their stage as long as the
// others.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr int kOneCaseIn = 16;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
inline constexpr int kOneCaseIn = 16;
#else
inline constexpr int kOneCaseIn = 1;
#endif
#else
inline constexpr int kOneCaseIn = 1;
#endif

/// Returns how many of `full` cases to run: all of them, or a share under AddressSanitizer or
/// ThreadSanitizer.
///
/// Domain:     full >= 1. At least one case is run.
template <class Integer>
constexpr Integer Cases(Integer full) {
  return std::max<Integer>(full / kOneCaseIn, 1);
}

/// Returns whether scripts/test_more runs the test: then nothing is left out.
inline bool RunsMore() { return std::getenv("RASTERPROOF_MORE") != nullptr; }

}  // namespace rasterproof

#endif  // RASTERPROOF_TESTS_SHARE_H_
