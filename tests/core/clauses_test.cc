// The clause table: whole, short of quotation, and found by its names.
#include "core/clauses/clauses.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace rasterproof {
namespace {

template <typename Say>
void ForEachClause(const Say& say) {
  for (const Specification& one : Specifications()) {
    for (const Clause& clause : one.clauses) say(one, clause);
  }
}

TEST(Clauses, CoverTheGraphicsApisAndWhatSurveysJudgeBy) {
  for (const char* api :
       {"gl", "vulkan", "d3d11", "d3d12", "webgpu", "pdf", "gdal", "x11", "java-awt"}) {
    ASSERT_NE(FindSpecification(api), nullptr) << api;
    EXPECT_FALSE(FindSpecification(api)->clauses.empty()) << api;
  }
  EXPECT_EQ(FindSpecification("gle"), nullptr);
}

TEST(Clauses, AreFoundByTheirNamesEachOnce) {
  std::set<std::string_view> ids;
  ForEachClause([&](const Specification& one, const Clause& clause) {
    EXPECT_TRUE(ids.insert(clause.id).second) << clause.id;
    EXPECT_EQ(ApiOf(clause), one.api) << clause.id;
    EXPECT_EQ(FindClause(clause.id), &clause) << clause.id;
  });
  EXPECT_EQ(FindClause("vulkan.no-such-clause"), nullptr);
  EXPECT_EQ(FindClause("vulkan"), nullptr);
}

TEST(Clauses, SayWhereTheyStandAndHowTheyWereRead) {
  ForEachClause([](const Specification&, const Clause& clause) {
    EXPECT_FALSE(clause.place.empty()) << clause.id;
    EXPECT_TRUE(clause.sentence.ends_with('.') || clause.sentence.ends_with(".\""))
        << clause.id << ": " << clause.sentence;
    EXPECT_TRUE(clause.reading.ends_with('.') || clause.reading.ends_with(".\"") ||
                clause.reading.ends_with('"'))
        << clause.id << ": " << clause.reading;
  });
}

// Words in the longest quotation of a text.
std::size_t LongestQuotation(std::string_view text) {
  std::size_t longest = 0;
  bool inside = false;
  std::size_t spaces = 0;
  for (const char c : text) {
    if (c == '"') {
      if (inside) longest = std::max(longest, spaces + 1);
      inside = !inside;
      spaces = 0;
    }
    if (c == ' ') ++spaces;
  }
  EXPECT_FALSE(inside) << text;
  return longest;
}

TEST(Clauses, QuoteAShortClauseAtMost) {
  ForEachClause([](const Specification&, const Clause& clause) {
    EXPECT_LE(LongestQuotation(clause.sentence), 20U) << clause.id;
    EXPECT_LE(LongestQuotation(clause.reading), 20U) << clause.id;
  });
}

TEST(Clauses, EveryGraphicsApiAssumesOnePositionForASharedVertex) {
  for (const char* api : {"gl", "vulkan", "d3d11", "d3d12", "webgpu"}) {
    const std::vector<const Clause*> assumptions = AssumptionsOf(api);
    EXPECT_TRUE(std::ranges::any_of(assumptions, [](const Clause* clause) {
      return clause->id.ends_with(".one-position");
    })) << api;
  }
  EXPECT_TRUE(AssumptionsOf("pdf").empty());
  EXPECT_TRUE(AssumptionsOf("no such API").empty());
}

TEST(Clauses, ARowMayStandForSeveralKeys) {
  const std::vector<ClauseKey> keys =
      KeysOf({.id = "x.y", .keys = "tie_ownership=per-edge; tie_rule; snap_tolerance=0.6"});
  ASSERT_EQ(keys.size(), 3U);
  EXPECT_EQ(keys[0].key, "tie_ownership");
  EXPECT_EQ(keys[0].value, "per-edge");
  EXPECT_EQ(keys[1].key, "tie_rule");
  EXPECT_EQ(keys[1].value, "");
  EXPECT_EQ(keys[2].value, "0.6");
  EXPECT_TRUE(KeysOf({.id = "x.y"}).empty());
}

constexpr const char* kHead = "# Of one.\napi: x\ntitle: X\nedition: First\n\n";
constexpr const char* kWhole = "id: x.a\nplace: 1\nsentence: \"a: b\"\nreading: A.\n";

Specification ReadText(const std::string& text) {
  return ReadSpecification({.name = "x.txt", .text = text});
}

TEST(Clauses, AreReadFromLinesOfFields) {
  const std::string text =
      kHead + std::string("base: y\n") + kWhole + "force: silent\nassumed: yes\n";
  const Specification one = ReadText(text);
  EXPECT_EQ(one.base, "y");
  ASSERT_EQ(one.clauses.size(), 1U);
  EXPECT_EQ(one.clauses[0].id, "x.a");
  EXPECT_EQ(one.clauses[0].force, Force::kSilent);
  EXPECT_EQ(one.clauses[0].sentence, "\"a: b\"");
  EXPECT_TRUE(one.clauses[0].is_assumed);
}

TEST(Clauses, AMalformedFileIsRefusedByFileAndLine) {
  struct Malformed {
    std::string text;
    std::string fault;
  };
  const std::string whole = kHead + std::string(kWhole);
  for (const auto& [text, fault] : std::vector<Malformed>{
           {whole + "sentense: A.\n", "x.txt: line 10: \"sentense\" is no field"},
           {whole + "title: X\n", "x.txt: line 10: \"title\" is no field"},
           {whole + "place: 2\n", "x.txt: line 10: \"place\" is given twice"},
           {whole + "keys:\n", "x.txt: line 10: \"keys:\" is not a field and its text"},
           {whole + "keys\n", "x.txt: line 10: \"keys\" is not a field and its text"},
           {whole + "force: perhaps\n", "x.txt: line 10: \"force: perhaps\" is no choice"},
           {whole + "assumed: no\n", "x.txt: line 10: \"assumed: no\" is no choice"},
           {whole + "\n" + kWhole, "x.txt: line 11: \"x.a\" is the id of two clauses"},
           {whole + "id: y.a\n", "x.txt: line 10: \"y.a\" is not of this specification"},
           {whole + "\nid: x.b\nplace: 2\nreading: B.\n\nid: x.c\n",
            "x.txt: line 15: \"sentence\" is missing above"},
           {whole + "id: x.b\nplace: 2\nsentence: B.\n",
            "x.txt: line 12: \"reading\" is missing above"},
           {"api: x\ntitle: X\nid: x.a\n", "x.txt: line 3: \"edition\" is missing above"},
           {"id: x.a\n", "x.txt: line 1: \"api\" is missing above"},
           {"", "x.txt: line 0: \"api\" is missing above"}}) {
    try {
      ReadText(text);
      ADD_FAILURE() << "read, though " << fault;
    } catch (const InputError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with(fault + ";")) << error.what();
    }
  }
}

TEST(Clauses, TheTestThatShowsAFigureIsThere) {
  std::string tests;
  for (const auto& entry : std::filesystem::recursive_directory_iterator("tests")) {
    if (!entry.path().string().ends_with("_test.cc")) continue;
    std::ifstream file(entry.path());
    tests.append(std::istreambuf_iterator<char>(file), {});
  }
  ForEachClause([&](const Specification&, const Clause& clause) {
    if (clause.shown_by.empty()) return;
    std::string name(clause.shown_by);
    name.replace(name.find('.'), 1, ", ");
    EXPECT_NE(tests.find("TEST(" + name + ")"), std::string::npos) << clause.id << ": " << name;
  });
}

TEST(Clauses, AProfileIsASpecificationsByItsName) {
  const auto api_of = [](std::string_view name) {
    const Specification* specification = SpecificationOf(name);
    return specification == nullptr ? std::string() : std::string(specification->api);
  };
  EXPECT_EQ(api_of("vulkan"), "vulkan");
  EXPECT_EQ(api_of("d3d12"), "d3d12");
  EXPECT_EQ(api_of("java-awt"), "java-awt");
  EXPECT_EQ(api_of("vulkan-canonical"), "") << "a model, not a set";
  EXPECT_EQ(api_of("real"), "");
  EXPECT_EQ(api_of("glide"), "") << "not OpenGL's, though it begins so";
  EXPECT_EQ(api_of("mine"), "");
  EXPECT_EQ(api_of("vulkan-mine"), "") << "no preset: a user's own words";
}

}  // namespace
}  // namespace rasterproof
