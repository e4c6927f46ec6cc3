// What a message says of a name that nobody knows: the one that may be meant, and those there are.
#ifndef RASTERPROOF_CORE_SUGGESTION_H_
#define RASTERPROOF_CORE_SUGGESTION_H_

#include <string>
#include <string_view>
#include <vector>

namespace rasterproof {

/// "did you mean NAME? " with the nearest of the names, where few letters must be put in, taken out
/// or exchanged to make it of `wrong`, capitals or not; else nothing.
std::string Suggestion(std::string_view wrong, const std::vector<std::string_view>& names);
std::string Suggestion(std::string_view wrong, const std::vector<std::string>& names);

/// The names behind words that introduce them: " a, b, c", or on lines of their own of at most 80
/// columns, each begun by a new line and two blanks, where one line would not hold them.
std::string ListedNames(const std::vector<std::string_view>& names);
std::string ListedNames(const std::vector<std::string>& names);

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_SUGGESTION_H_
