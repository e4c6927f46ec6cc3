// Conversions between numbers and text, one in each direction.
#ifndef RASTERPROOF_IO_NUMBER_TEXT_H_
#define RASTERPROOF_IO_NUMBER_TEXT_H_

#include <string>
#include <string_view>

#include "core/scene.h"

namespace rasterproof::io {

/// A number read from text, or why there is none.
struct NumberFromText {
  double value = 0;
  std::string_view fault;   ///< empty: the value is good
  std::string_view remedy;  ///< the text to write instead
};

/// Converts the text of a JSON number to the nearest value of the precision, ties to even.
///
/// Domain:     the grammar of a JSON number. Any length; -0 keeps its sign.
/// Error:      half a unit in the last place, once: float32 is never reached through float64 (which
///             would round twice). A number that rounds to infinity is a fault; one that rounds to
///             zero is not.
NumberFromText DecimalNumber(std::string_view text, Precision precision);

/// Converts "inf", "-inf", "nan" or a C99 hexadecimal float ("-0x1.8p+3").
///
/// Domain:     any text; the binary exponent is required, as C99 does. No blanks, no suffix.
/// Error:      none: a hex float that the precision does not hold exactly is a fault.
NumberFromText ExactNumber(std::string_view text, Precision precision);

/// The text that ExactNumber turns back into the same bits (of a NaN only that it is one).
std::string ExactText(double value);

}  // namespace rasterproof::io

#endif  // RASTERPROOF_IO_NUMBER_TEXT_H_
