#include "core/profile_keys.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace rasterproof {
namespace {

template <class E>
std::string_view WordOf(std::string_view key, E value) {
  return WordsOf(KeyNamed(key)).at(static_cast<std::size_t>(value));
}

}  // namespace

std::string_view KeyKindName(KeyKind kind) {
  constexpr std::array<std::string_view, 5> kNames{"name", "model", "contract", "freedom", "limit"};
  return kNames.at(static_cast<std::size_t>(kind));
}

std::vector<std::string_view> WordsOf(const ProfileKey& key) {
  constexpr std::string_view kBetween = ", ";
  std::vector<std::string_view> words;
  std::string_view rest = key.values;
  for (std::size_t end = rest.find(kBetween); end != rest.npos; end = rest.find(kBetween)) {
    words.push_back(rest.substr(0, end));
    rest.remove_prefix(end + kBetween.size());
  }
  words.push_back(rest);
  return words;
}

const ProfileKey& KeyNamed(std::string_view name) {
  return *std::ranges::find(kProfileKeys, name, &ProfileKey::name);
}

std::string_view ContractName(Contract contract) { return WordOf("contract", contract); }
std::string_view SnapRuleName(SnapRule rule) { return WordOf("snap_rule", rule); }
std::string_view SnapFormName(SnapForm form) { return WordOf("snap_form", form); }

}  // namespace rasterproof
