// Members of a JSON object: optional ones, enumerations by name, pairs, small integers.
#ifndef RASTERPROOF_IO_JSON_MEMBERS_H_
#define RASTERPROOF_IO_JSON_MEMBERS_H_

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/quoted.h"
#include "core/suggestion.h"
#include "io/json_document.h"
#include "io/renamed.h"

namespace rasterproof::io {

/// An enumeration's values and their names in files.
template <class E>
using Names = std::span<const std::pair<E, std::string_view>>;

template <class E>
std::string_view NameOf(E value, Names<E> names) {
  return std::ranges::find(names, value, &std::pair<E, std::string_view>::first)->second;
}

/// Returns which of the words the text is.
inline std::size_t IndexOf(const JsonValue& value, std::span<const std::string_view> words) {
  const std::string_view text = value.RequireString();
  const auto found = std::ranges::find(words, text);
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  const std::vector<std::string_view> all(words.begin(), words.end());
  throw value.Error(Quoted(text) + " is unknown" + RenamedText(text),
                    Suggestion(text, all) + "known here are" + ListedNames(all));
}

template <class E>
E FromName(const JsonValue& value, Names<E> names) {
  std::vector<std::string_view> words;
  for (const auto& [known, name] : names) words.push_back(name);
  return names[IndexOf(value, words)].first;
}

/// The member `key`, turned by `read`, if the object has it.
template <class T, class Read>
void ReadIfThere(const JsonValue& object, std::string_view key, T& into, Read read) {
  if (const std::optional<JsonValue> value = object.Find(key)) into = read(*value);
}

inline int Integer(const JsonValue& value, int least, int greatest) {
  return static_cast<int>(value.RequireInteger(least, greatest));
}

inline bool Boolean(const JsonValue& value) {
  if (value.kind() != JsonKind::kBoolean) {
    throw value.Error("is neither true nor false", "write true or false");
  }
  return value.text() == "true";
}

}  // namespace rasterproof::io

#endif  // RASTERPROOF_IO_JSON_MEMBERS_H_
