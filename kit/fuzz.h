// A fuzz target of your own rasterizer, in one statement:
//
//     #include "kit/fuzz.h"
//     struct Mine {
//       void Draw(const rasterproof::Scene& scene, rasterproof::CoverageCounts& counts);
//     };
//     RASTERPROOF_FUZZ_TARGET(Mine, "SharedEdgeSamplesAreCoveredOnce")
//
// kit/main.h lists what else Mine may have. Link rasterproof::fuzz_target; with clang
// and -fsanitize=fuzzer libFuzzer drives it, else a driver that replays files and tries random
// bytes. It runs in this process: a crash ends it, and the input is saved.
#ifndef RASTERPROOF_KIT_FUZZ_H_
#define RASTERPROOF_KIT_FUZZ_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <span>
#include <string_view>

#include "core/rasterizer.h"
#include "core/subject.h"

namespace rasterproof::kit {

/// A subject and the properties that every input checks on it, bound at the first input.
class FuzzTarget {
 public:
  /// Domain:     names of properties, as `rasterproof list properties` prints them; none: the
  ///             properties of the contract that the subject states.
  /// Error:      aborts if there is no property of a name, or one does not apply to the subject.
  FuzzTarget(std::unique_ptr<Subject> subject, std::initializer_list<std::string_view> properties);
  FuzzTarget(const FuzzTarget&) = delete;
  FuzzTarget& operator=(const FuzzTarget&) = delete;
  ~FuzzTarget();

  /// Decodes a case and checks the properties; a violation is printed, and aborts.
  ///
  /// Returns:    the value for LLVMFuzzerTestOneInput.
  int Run(std::span<const std::uint8_t> bytes) const;

 private:
  struct Parts;
  std::unique_ptr<const Parts> parts_;
};

}  // namespace rasterproof::kit

/// Defines LLVMFuzzerTestOneInput. `Type` models rasterproof::Rasterizer; the names of the
/// properties follow it, none or several.
#define RASTERPROOF_FUZZ_TARGET(Type, ...)                                             \
  extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {  \
    static const rasterproof::kit::FuzzTarget target(                                  \
        std::make_unique<rasterproof::RasterizerSubject<Type>>(#Type), {__VA_ARGS__}); \
    return target.Run(std::span(data, size));                                          \
  }

#endif  // RASTERPROOF_KIT_FUZZ_H_
