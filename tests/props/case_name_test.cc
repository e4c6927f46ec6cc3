// Names of cases: each case has one text, and stands for the same case whatever runs beside it.
#include "props/domains/case_name.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "props/domains/domain.h"
#include "props/run/campaign.h"
#include "props/run/property_domains.h"
#include "tests/props/faulty_subjects.h"

namespace rasterproof::props {
namespace {

using testing::ModelProperty;
using testing::RealInfo;

using Names = std::vector<std::string_view>;

constexpr std::uint64_t kNameSeed = 3;

std::vector<const Domain*> DomainsOf(const Names& names) {
  std::vector<const Domain*> domains;
  for (const std::string_view name : names) domains.push_back(FindDomain(name));
  return domains;
}

std::string Refusal(std::string_view name) {
  try {
    ParseCaseName(name);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// The first cases that a run over the domains draws under its seed, by name. Fails if a name comes
// twice.
std::map<std::string, Case> CasesOver(const Names& names, std::uint64_t cases) {
  const Property property = ModelProperty(names);
  std::map<std::string, Case> drawn;
  for (std::uint64_t i = 0; drawn.size() < cases; ++i) {
    Case c = DrawCase(RealInfo(), property, kNameSeed, i);
    const std::string name = c.origin;
    if (ParseCaseName(name).seed != kNameSeed) continue;  // a chosen one
    EXPECT_TRUE(drawn.emplace(name, std::move(c)).second) << name;
  }
  return drawn;
}

TEST(CaseNames, AreReadAsTheyAreWritten) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
  for (const CaseName& name : {CaseName{"near-edge", 17, 1}, {"fans", 0, 0}, {"x", kMost, kMost}}) {
    EXPECT_EQ(ParseCaseName(ToText(name)), name);
  }
  EXPECT_EQ(ToText({"near-edge", 17, 1}), "near-edge:17@1");
  for (const Domain& domain : Domains()) {
    const CaseName name{std::string(domain.name), 2, 3};
    EXPECT_EQ(ParseCaseName(ToText(name)), name);
  }
}

TEST(CaseNames, AreRefusedWithWhatIsWrong) {
  for (const char* shapeless : {"", "17", "near-edge", "near-edge:17", "near-edge@1", ":17@1",
                                "near-edge@1:17", "near-edge 17@1"}) {
    const std::string said = Refusal(shapeless);
    EXPECT_NE(said.find("not the name of a case"), std::string::npos) << shapeless << ": " << said;
    EXPECT_NE(said.find("near-edge:17@1"), std::string::npos) << said;
    EXPECT_NE(said.find("list domains"), std::string::npos) << said;
  }
  for (const std::string bad : {"", "-1", "+1", "1x", "0x1", "017", "1.5", " 1", "1 ",
                                "18446744073709551616", "1@1", "1:1"}) {
    const std::string index = Refusal("near-edge:" + bad + "@1");
    const bool ends_early = bad == "1@1";  // the seed is what is wrong then
    EXPECT_NE(index.find(ends_early ? "is no seed" : "is no index"), std::string::npos) << index;
    const std::string seed = Refusal("near-edge:1@" + bad);
    EXPECT_NE(seed.find("'" + bad + "' is no seed"), std::string::npos) << seed;
  }
}

TEST(CaseNames, OfNoDomainAndOfDomainsThatASubjectDoesNotTakeAreRefused) {
  EXPECT_THROW(DrawCase(RealInfo(), CaseName{"none-such", 0, 1}), InputError);
  EXPECT_THROW(DrawCase(RealInfo(), CaseName{"mixed-w", 0, 1}), InputError);
  EXPECT_THROW(DrawCase(RealInfo(), CaseName{"primitive-extent-ends", 0, 1}), InputError);
  EXPECT_EQ(DrawCase(RealInfo(), CaseName{"fans", 0, 1}).origin, "fans:0@1");
}

TEST(CaseNames, StandForTheSameWhateverDomainsAreBeside) {
  const Names some{"uniform-subpixel", "near-edge", "fans", "target-sizes"};
  const Names more{"needles",          "near-edge", "caps", "target-sizes",
                   "uniform-subpixel", "grids",     "fans"};
  const std::map<std::string, Case> few = CasesOver(some, 4 * 6);
  const std::map<std::string, Case> many = CasesOver(more, 7 * 6);
  for (const auto& [name, c] : few) {
    ASSERT_TRUE(many.contains(name)) << name;
    EXPECT_EQ(c, many.at(name)) << name;
    EXPECT_EQ(c, DrawCase(RealInfo(), ParseCaseName(name))) << name;
  }
  // And they are the first six of each domain.
  for (const std::string_view domain : some) {
    for (std::uint64_t i = 0; i < 6; ++i) {
      const std::uint64_t index = FirstIndex(ModelProperty(some).name) + i;
      EXPECT_TRUE(few.contains(ToText({std::string(domain), index, kNameSeed}))) << domain << i;
    }
  }
}

TEST(CaseNames, OfPropertiesThatShareADomainDiffer) {
  std::set<std::uint64_t> firsts;
  for (const Property& property : Catalog()) {
    EXPECT_TRUE(firsts.insert(FirstIndex(property.name)).second) << property.name;
  }
  const std::vector<const Domain*> domains = DomainsOf({"near-edge"});
  EXPECT_EQ(NameOfCase(domains, 4000, kNameSeed, 17), (CaseName{"near-edge", 4017, kNameSeed}));
}

TEST(CaseNames, DifferInWhatTheyStandFor) {
  const auto scene = [](const CaseName& name) { return DrawCase(RealInfo(), name).scene; };
  const Scene one = scene({"near-edge", 0, 1});
  EXPECT_NE(one, scene({"near-edge", 1, 1}));
  EXPECT_NE(one, scene({"near-edge", 0, 2}));
  // Domains that draw alike at first do not share their bits.
  EXPECT_NE(scene({"vertices-on-samples", 0, 1}).vertices,
            scene({"uniform-subpixel", 0, 1}).vertices);
}

TEST(CaseNames, OfADomainThatStandsThereOftenAreEachTakenOnce) {
  const std::vector<const Domain*> domains =
      DomainsOf({"near-edge", "folds", "folds", "fans", "folds"});
  std::map<std::string, std::set<std::uint64_t>> indices;
  for (std::uint64_t i = 0; i < 5 * 7; ++i) {
    const CaseName name = NameOfCase(domains, 0, kNameSeed, i);
    EXPECT_EQ(name.domain, domains[i % 5]->name);
    EXPECT_TRUE(indices[name.domain].insert(name.index).second) << ToText(name);
  }
  const std::map<std::string, std::size_t> times{{"near-edge", 7}, {"folds", 21}, {"fans", 7}};
  for (const auto& [domain, count] : times) {
    EXPECT_EQ(indices[domain].size(), count);
    EXPECT_EQ(*indices[domain].rbegin(), count - 1) << domain;
  }
}

TEST(DomainNumbers, AreUniqueAndFound) {
  std::set<std::uint16_t> numbers;
  for (const Domain& domain : Domains()) {
    EXPECT_NE(domain.number, 0) << domain.name << " has no number";
    EXPECT_TRUE(numbers.insert(domain.number).second) << domain.name << ": " << domain.number;
    EXPECT_EQ(DomainOfNumber(domain.number), &domain);
    EXPECT_EQ(domain.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-"),
              std::string_view::npos);
  }
  EXPECT_EQ(DomainOfNumber(0), nullptr);
  EXPECT_EQ(DomainOfNumber(65535), nullptr);
}

}  // namespace
}  // namespace rasterproof::props
