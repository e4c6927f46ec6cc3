#include "tool/file_names.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <string_view>

#include "subjects/builtin/builtin.h"

namespace rasterproof::tool {
namespace {

TEST(FileNameOf, KeepsTheNamesOfBuiltInSubjectsReadable) {
  EXPECT_EQ(FileNameOf("f32-direct"), "f32-direct");
  EXPECT_EQ(FileNameOf("f32-direct:canonical"), "f32-direct+canonical");
  EXPECT_EQ(FileNameOf("mine.subject"), "mine.subject");
}

TEST(FileNameOf, IsOnePlainEntryWhateverTheSubjectIsCalled) {
  std::set<std::string> names;
  const std::string nul("a\0b", 3);
  for (const std::string& subject :
       {std::string("exec:python3 ./p.py"), std::string("plugin:../../p.so"), std::string(".."),
        std::string("."), std::string(""), std::string("/etc/passwd"), std::string(300, 'x'),
        std::string(301, 'x'), std::string("-rf"), std::string(".hidden"), std::string("a b"),
        std::string("a_b"), std::string("a__b"), std::string("a:b"), std::string("a+b"), nul,
        std::string("\xff\n'\"$(x)*?|<>\\"), std::string("___"), FileNameOf("a b")}) {
    const std::string name = FileNameOf(subject);
    EXPECT_TRUE(names.insert(name).second) << subject << " shares " << name;
    EXPECT_LE(name.size(), 100U) << subject;
    ASSERT_FALSE(name.empty()) << subject;
    EXPECT_TRUE(std::ranges::all_of(name, [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
             std::string_view("-_.+").find(c) != std::string_view::npos;
    })) << name;
    EXPECT_EQ(std::string_view("-_.+").find(name.front()), std::string_view::npos) << name;
  }
}

TEST(FileNameOf, TellsEveryBuiltInSubjectFromEveryOther) {
  std::set<std::string> names;
  for (const std::string& subject : subjects::BuiltinNames()) {
    EXPECT_TRUE(names.insert(FileNameOf(subject)).second) << subject;
  }
}

}  // namespace
}  // namespace rasterproof::tool
