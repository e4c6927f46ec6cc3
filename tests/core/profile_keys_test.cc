#include "core/profile_keys.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/every_key.h"

namespace rasterproof {
namespace {

// Each row changes what the rows before it left as it was, and after the last nothing is left.
TEST(ProfileKeys, EveryMemberBelongsToExactlyOne) {
  Profile profile = EveryKeySet();
  for (const ProfileKey& key : kProfileKeys) {
    const Profile before = profile;
    key.copy(Profile{}, profile);
    EXPECT_NE(profile, before) << key.name << " copies what another key copies, or nothing";
  }
  EXPECT_EQ(profile, Profile{}) << "a member belongs to no key";
}

TEST(ProfileKeys, OneModelIsSaidByTheKeysOfTheModel) {
  for (const ProfileKey& key : kProfileKeys) {
    Profile profile;
    key.copy(EveryKeySet(), profile);
    EXPECT_EQ(SameModel(profile, Profile{}), key.kind != KeyKind::kModel) << key.name;
  }
}

TEST(ProfileKeys, WordsAreSeparate) {
  EXPECT_EQ(WordsOf(KeyNamed("nan_z")),
            (std::vector<std::string_view>{"ignored", "nothing", "unspecified"}));
  EXPECT_EQ(SnapRuleName(SnapRule::kTruncate), "truncate");
  EXPECT_EQ(SnapFormName(SnapForm::kExactDifference), "exact-difference");
  EXPECT_EQ(ContractName(Contract::kNone), "none");
}

TEST(ProfileKeys, AreTheTableOfTheDocument) {
  std::string table = "| key | values | default | what it says |\n| --- | --- | --- | --- |\n";
  for (const ProfileKey& key : kProfileKeys) {
    table += "| `" + std::string(key.name) + "` | " + std::string(key.values) + " | " +
             std::string(key.usual) + (key.usual.empty() ? "| " : " | ") + std::string(key.says) +
             " |\n";
  }
  std::ifstream file("docs/subjects.md");
  const std::string document{std::istreambuf_iterator<char>(file), {}};
  EXPECT_NE(document.find(table + '\n'), std::string::npos)
      << "make this the table of docs/subjects.md, \"What a profile can say\":\n"
      << table;
}

}  // namespace
}  // namespace rasterproof
