#include "core/profile_keys.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "io/case_file.h"

namespace rasterproof::io {
namespace {

struct Anything {
  template <class T>
  operator T() const {
    return T();
  }
};

template <class T, class... Members>
consteval std::size_t MemberCount() {
  if constexpr (requires { T{Members{}..., Anything{}}; })
    return MemberCount<T, Members..., Anything>();
  return sizeof...(Members);
}

static_assert(kProfileKeys.size() ==
                  MemberCount<Profile>() - 2 + MemberCount<Snap>() + MemberCount<Freedom>(),
              "each member of Profile, of its Snap and of its Freedom needs a row in "
              "core/profile_keys.h");

// '"nan_z": "nothing"', with a value other than the default.
std::string Example(const ProfileKey& key) {
  std::string value(key.member.example);
  if (key.name == "contract") value = "\"squares\"";  // the one that `coverage` is for
  if (value.empty()) value = '"' + std::string(WordsOf(key).at(1)) + '"';
  return '"' + std::string(key.name) + "\": " + value;
}

// Returns a profile in which every key has its example.
Profile EveryKeySet() {
  std::string json;
  for (const ProfileKey& key : kProfileKeys)
    if (key.name != "specification" && key.name != "culls")
      json += (json.empty() ? "{" : ", ") + Example(key);
  Profile profile = ParseProfile(json + "}", "examples");
  profile.specification = "d3d11";  // which would be refused beside the other keys
  profile.culls = Cull::kBack;      // and that beside an unstated front
  return profile;
}

// Each row changes what the rows before it left as it was, and after the last nothing is left.
TEST(ProfileKeys, EveryMemberBelongsToExactlyOne) {
  Profile profile = EveryKeySet();
  for (const ProfileKey& key : kProfileKeys) {
    const Profile before = profile;
    key.member.copy(Profile{}, profile);
    EXPECT_NE(profile, before) << key.name << " copies what another key copies, or nothing";
  }
  EXPECT_EQ(profile, Profile{}) << "a member belongs to no key";
}

TEST(ProfileKeys, OneModelIsSaidByTheKeysOfTheModel) {
  for (const ProfileKey& key : kProfileKeys) {
    Profile profile;
    key.member.copy(EveryKeySet(), profile);
    EXPECT_EQ(SameModel(profile, Profile{}), key.kind != KeyKind::kModel) << key.name;
  }
}

TEST(ProfileKeys, AreAllWrittenInTheOrderOfTheTableAndReadBack) {
  Profile profile = EveryKeySet();
  const std::string with_all = ProfileToJson(profile);
  std::size_t place = 0;
  for (const ProfileKey& key : kProfileKeys) {
    place = with_all.find("\n    \"" + std::string(key.name) + "\": ", place);
    ASSERT_NE(place, std::string::npos) << key.name << " is not written in its turn:\n" << with_all;
  }
  profile.specification.clear();
  profile.culls = Cull::kNone;
  const std::string text = ProfileToJson(profile);
  EXPECT_EQ(ParseProfile(text, "written"), profile) << text;
}

TEST(ProfileKeys, AreWrittenWithExactNumbers) {
  const std::string text = ProfileToJson(EveryKeySet());
  for (const std::string_view line :
       {R"("snap_origin": "0x1p-2")", R"("sample_locations": [["0x1p-3", "0x1.cp-1"])",
        R"("transform_error": "0x1.8p+0")", R"("max_primitive_extent": ["0x1.ff8p+9")",
        R"({"bits": 7, "rule": "floor", "origin": "0x1p-1"})"})
    EXPECT_NE(text.find(line), std::string::npos) << line << " is not in\n" << text;
}

TEST(ProfileKeys, EveryWordIsReadAndWritten) {
  for (const ProfileKey& key : kProfileKeys) {
    if (key.member.word == nullptr) continue;
    for (const std::string_view word : WordsOf(key)) {
      const std::string said = '"' + std::string(key.name) + "\": \"" + std::string(word) + '"';
      const Profile profile = ParseProfile(
          R"({"name": "p", "least_subpixel_bits": 4, "snap_origin": 0.5, )" + said +
              (word == "squares" ? R"(, "coverage": {"may": {"relation": "intersects"}})" : "") +
              "}",
          "p.json");
      const bool is_usual = word == key.usual.substr(0, word.size());
      EXPECT_TRUE(is_usual || ProfileToJson(profile).find(said) != std::string::npos) << said;
    }
  }
}

TEST(ProfileKeys, WordsAreSeparate) {
  EXPECT_EQ(WordsOf(KeyNamed("nan_z")),
            (std::vector<std::string_view>{"ignored", "nothing", "unspecified"}));
  EXPECT_EQ(SnapRuleName(SnapRule::kTruncate), "truncate");
  EXPECT_EQ(SnapFormName(SnapForm::kExactDifference), "exact-difference");
  EXPECT_EQ(ContractName(Contract::kNone), "none");
}

}  // namespace
}  // namespace rasterproof::io
