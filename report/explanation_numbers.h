// How pictures show numbers beside coverage: the exact ones, the shown ones, and how far apart they
// are.
#ifndef RASTERPROOF_REPORT_EXPLANATION_NUMBERS_H_
#define RASTERPROOF_REPORT_EXPLANATION_NUMBERS_H_

#include <string>
#include <vector>

#include "core/compared_numbers.h"
#include "report/palette.h"
#include "report/picture.h"

namespace rasterproof::report {

/// Whether the explanation is one of numbers.
inline bool HasNumbers(const Explanation& explanation) {
  return explanation.numbers && !explanation.numbers->list.empty();
}

/// The number of a sample; nullptr if it has none.
const ComparedNumber* NumberAt(const Explanation& explanation, int x, int y, int sample);
/// That of the pixel's samples which is farthest off.
const ComparedNumber* NumberAt(const Explanation& explanation, int x, int y);

/// From the least to the greatest of the expected numbers.
struct NumberScale {
  double low = 0;
  double high = 1;
};
NumberScale ScaleOf(const ComparedNumbers& numbers);

/// From dark blue to yellow, which all eyes order alike; ink below the scale, vermilion above it,
/// purple what is no number.
Colour NumberColour(const NumberScale& scale, double number);
/// Muted within what is allowed; beyond it blue below and vermilion above, louder with the size.
Colour OffColour(double off);

/// '0' to '9' along the scale, '<' and '>' beside it, '?' of what is no number.
char NumberCharacter(const NumberScale& scale, double number);
/// '.' within what is allowed, '-' below, '+' above, '?' of what is no number.
char OffCharacter(double off);
/// In three characters or so: "12", "3e5".
std::string OffText(double off);

/// "0.25": the shortest decimal of up to six digits, for the eye.
std::string ShortNumber(double number);
/// "1.6e+06 times what is allowed", "3 ulps, where none is allowed".
std::string UnitsText(const ComparedNumbers& numbers, double off);
/// What the failing sample shows, with exact digits; its place; what stands beside it.
std::vector<std::string> NumberLines(const ComparedNumbers& numbers);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_EXPLANATION_NUMBERS_H_
