// Text for messages about an unknown name: the name that may be meant, and the list of all names.
#ifndef RASTERPROOF_CORE_SUGGESTION_H_
#define RASTERPROOF_CORE_SUGGESTION_H_

#include <string>
#include <string_view>
#include <vector>

namespace rasterproof {

/// Returns "did you mean NAME? " with the name nearest to `wrong`, if inserting, deleting or
/// exchanging few letters makes them equal, ignoring case; else "".
std::string Suggestion(std::string_view wrong, const std::vector<std::string_view>& names);
std::string Suggestion(std::string_view wrong, const std::vector<std::string>& names);

/// Returns the names as they follow introducing words: " a, b, c", or, if that is too long, on
/// separate lines of at most 80 columns, each after a newline and two blanks.
std::string ListedNames(const std::vector<std::string_view>& names);
std::string ListedNames(const std::vector<std::string>& names);

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_SUGGESTION_H_
