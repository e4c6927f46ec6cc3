// The mode of a thread's floating-point arithmetic, and another one for a while.
#ifndef RASTERPROOF_CORE_FLOAT_MODE_H_
#define RASTERPROOF_CORE_FLOAT_MODE_H_

#include <array>
#include <cfenv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/float_environment.h"

namespace rasterproof {

/// Modes that a caller, or a library that it uses, may leave set in the thread that draws.
enum class FloatMode : std::uint8_t {
  kUsual,             ///< rounds to nearest, keeps subnormal numbers, traps nothing
  kFlushToZero,       ///< subnormal results become 0
  kDenormalsAreZero,  ///< subnormal operands count as 0
  kUpward,
  kDownward,
  kTowardZero,
  kTrapping  ///< as usual, but overflow, division by zero and invalid operations end the program
};

inline constexpr std::array<std::string_view, 7> kFloatModeNames{"usual", "ftz",  "daz", "up",
                                                                 "down",  "zero", "trap"};
constexpr std::string_view FloatModeName(FloatMode mode) {
  return kFloatModeNames[static_cast<std::size_t>(mode)];
}
/// The mode of that name; nothing if there is none.
std::optional<FloatMode> FindFloatMode(std::string_view name);

/// True if the processor has the mode: only x86-64 can take subnormal operands for 0 alone.
bool HasFloatMode(FloatMode mode);

/// The mode as bits of the register that FloatEnvironment reads and writes.
FloatEnvironment::Bits ControlBits(FloatMode mode);

/// While one lives, its thread computes in the mode; then its environment is back, flags included.
/// Under kUsual it changes nothing and finds nothing: a library may draw in a mode of its choice.
class WithinFloatMode {
 public:
  /// Domain:     HasFloatMode(mode).
  explicit WithinFloatMode(FloatMode mode);
  ~WithinFloatMode();
  WithinFloatMode(const WithinFloatMode&) = delete;
  WithinFloatMode& operator=(const WithinFloatMode&) = delete;

  /// What the code that ran since then did that the mode's owner would mind, as a sentence: it left
  /// another mode, or under kTrapping it raised what is trapped. Empty: nothing.
  ///
  /// Properties: a trap is found by the flag that its exception raises, so that no signal is
  ///             needed; code that clears the flags itself hides it.
  std::string Complaint() const;

 private:
  FloatMode mode_;
  std::fenv_t before_{};
};

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_FLOAT_MODE_H_
