// The cases of a run: chosen ones between the drawn ones.
#include "props/run/case_order.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <string>

#include "props/domains/case_name.h"
#include "props/domains/domain.h"
#include "props/property.h"
#include "props/run/property_domains.h"
#include "tests/props/faulty_subjects.h"

namespace rasterproof::props {
namespace {

using testing::RealInfo;

const Property& Model() { return *FindProperty("CoverageEqualsTheModel"); }

TEST(FirstCases, AreOfDomainsThatThereAreAndEachOnce) {
  std::set<std::string> names;
  for (const FirstCase& first : FirstCases()) {
    EXPECT_NE(FindDomain(first.domain), nullptr) << first.domain;
    // FirstIndex is 0 or 1000 and more: what is drawn of a property begins there.
    EXPECT_LT(first.index, 1000U);
    const CaseName name{std::string(first.domain), first.index, kFirstCasesSeed};
    EXPECT_TRUE(names.insert(ToText(name)).second) << ToText(name);
  }
  for (const Property& property : Catalog()) EXPECT_NE(FirstIndex(property.name), 0U);
}

TEST(CaseOrder, TakesAChosenCaseOfALateDomainAfterEachDrawnOneButOne) {
  const CaseOrder order(RealInfo(), Model(), 7);
  const auto domains = DomainsFor(RealInfo(), Model());
  std::uint64_t drawn = 0;
  std::uint64_t chosen = 0;
  for (std::uint64_t n = 0; n < 200; ++n) {
    const CaseName name = order.Name(n);
    EXPECT_EQ(name.domain, domains[order.PlaceOf(n)]->name);
    if (name.seed == kFirstCasesSeed) {
      EXPECT_EQ(n, 3 * chosen++ + 1);
      EXPECT_GE(order.PlaceOf(n), 13U);
    } else {
      EXPECT_EQ(name, NameOfCase(domains, FirstIndex(Model().name), 7, drawn++));
    }
    if (n == 19) {
      EXPECT_EQ(chosen, 7U);
    }
  }
  EXPECT_GT(chosen, 20U);
  EXPECT_EQ(drawn + chosen, 200U);
}

TEST(CaseOrder, DrawsAllCasesOfAPropertyWithFewDomains) {
  const Property& list = *FindProperty("LongListDrawsLikeItsEnd");
  const CaseOrder order(RealInfo(), list, 7);
  const auto domains = DomainsFor(RealInfo(), list);
  for (std::uint64_t n = 0; n < 40; ++n) {
    EXPECT_EQ(order.Name(n), NameOfCase(domains, FirstIndex(list.name), 7, n));
  }
}

TEST(CaseOrder, NamesACaseOnce) {
  for (const Property& property : Catalog()) {
    const CaseOrder order(RealInfo(), property, kFirstCasesSeed);
    if (order.IsEmpty()) continue;
    std::set<std::string> names;
    for (std::uint64_t n = 0; n < 300; ++n) {
      EXPECT_TRUE(names.insert(ToText(order.Name(n))).second) << ToText(order.Name(n));
    }
  }
}

}  // namespace
}  // namespace rasterproof::props
