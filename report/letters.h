// Letters of 5 x 7 dots and 2 below the line, for pictures that must need no font.
#ifndef RASTERPROOF_REPORT_LETTERS_H_
#define RASTERPROOF_REPORT_LETTERS_H_

namespace rasterproof::report {

inline constexpr int kLetterWidth = 5;
inline constexpr int kLetterHeight = 9;
/// Rows above the line that letters stand on.
inline constexpr int kLetterAscent = 7;

/// Returns whether the dot in `column` from the left and `row` from the top of the letter is ink.
///
/// Domain:     any character (outside printable ASCII it looks like "?"); 0 <= column <
///             kLetterWidth, 0 <= row < kLetterHeight.
bool IsInk(char c, int column, int row);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_LETTERS_H_
