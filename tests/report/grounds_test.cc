// Every output tells a violated clause, the stated model and a lack of quality apart.
#include "report/grounds.h"

#include <gtest/gtest.h>

#include <string>

#include "pugixml.hpp"
#include "report/certificate.h"
#include "report/page.h"
#include "tests/report/json.h"
#include "tests/report/sample_results.h"

namespace rasterproof::report {
namespace {

// A subject under the legal set of Vulkan, of which one property is short.
Certificate ShortOf(Authority authority) {
  Certificate certificate = SampleCertificate();
  certificate.subject.profile.name = "vulkan";
  certificate.measured.clear();
  certificate.tested = {SampleProperty("A", Outcome::kHolds),
                        SampleProperty("B", Outcome::kViolated)};
  certificate.tested[1].authority = authority;
  if (authority == Authority::kClause) certificate.tested[1].required_by = {"vulkan.common-edge"};
  return certificate;
}

bool Says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string SubjectPageOf(const Certificate& certificate) {
  Page page;
  page.certificates = {certificate};
  return SubjectPageToHtml(page, certificate);
}

TEST(Grounds, AreTheSameWordsEverywhere) {
  EXPECT_EQ(AuthorityText(ShortOf(Authority::kClause).tested[1]), "required by vulkan.common-edge");
  EXPECT_EQ(AuthorityText(ShortOf(Authority::kStatedModel).tested[1]), "by the stated model");
  EXPECT_EQ(AuthorityText(ShortOf(Authority::kQuality).tested[1]),
            "quality: no clause requires it");
}

TEST(Grounds, OnlyAClauseOrTheStatedModelViolates) {
  EXPECT_EQ(OverallVerdict(ShortOf(Authority::kClause)), "violated");
  EXPECT_EQ(OverallVerdict(ShortOf(Authority::kStatedModel)), "violated");
  Certificate lacking = ShortOf(Authority::kQuality);
  EXPECT_EQ(OverallVerdict(lacking), "holds");
  EXPECT_EQ(OverallOf(lacking).reason, "properties short of quality: 1");
  lacking.fail_on = FailOn::kQuality;
  EXPECT_EQ(OverallVerdict(lacking), "violated");
}

TEST(Grounds, TheCertificateNamesAuthorityAndClauses) {
  const auto json = ParseJson(CertificateToJson(ShortOf(Authority::kClause)));
  EXPECT_EQ(json["tested"][0]["authority"], "stated model");
  EXPECT_EQ(json["tested"][1]["authority"], "clause");
  EXPECT_EQ(json["tested"][1]["required_by"][0], "vulkan.common-edge");
  EXPECT_EQ(json["quality_fails"], false);
  ASSERT_EQ(json["assumed"].size(), 3U);
  EXPECT_EQ(json["assumed"][0]["statement"], "vulkan.one-position");
  EXPECT_EQ(json["assumed"][1]["statement"], "vulkan.one-grid");
  EXPECT_EQ(json["assumed"][2]["statement"], "vulkan.clip-point");
}

TEST(Grounds, WhatWasNotAskedIsDataAndOneLine) {
  const Certificate certificate = SampleCertificate();
  const auto json = ParseJson(CertificateToJson(certificate));
  ASSERT_EQ(json["not_asked"].size(), 2U);
  EXPECT_EQ(json["not_asked"][0]["statement"], "depths in clip space");
  EXPECT_EQ(json["not_asked"][0]["by"], "no property judges them");
  EXPECT_EQ(NotAskedText(certificate.not_asked),
            "depths in clip space (no property judges them); targets above 4096 samples");
}

TEST(Grounds, AModelAssumesNothing) {
  Certificate model = ShortOf(Authority::kStatedModel);
  model.subject.profile.name = "vulkan-canonical";
  EXPECT_TRUE(ParseJson(CertificateToJson(model))["assumed"].empty());
}

TEST(Grounds, InJUnitALackOfQualityFailsNoTest) {
  const auto failures = [](const Certificate& certificate) {
    pugi::xml_document document;
    EXPECT_TRUE(document.load_string(JUnitXml(certificate).c_str()));
    return document.child("testsuites").child("testsuite").attribute("failures").as_int();
  };
  EXPECT_EQ(failures(ShortOf(Authority::kClause)), 1);
  Certificate lacking = ShortOf(Authority::kQuality);
  EXPECT_EQ(failures(lacking), 0);
  const std::string text = JUnitXml(lacking);
  EXPECT_TRUE(Says(text, "quality: no clause requires it")) << text;
  EXPECT_TRUE(Says(text, "assumed: vulkan.one-position")) << text;
  lacking.fail_on = FailOn::kQuality;
  EXPECT_EQ(failures(lacking), 1);
}

TEST(Grounds, ThePageHasAPartOfItsOwnForQuality) {
  const std::string lacking = SubjectPageOf(ShortOf(Authority::kQuality));
  EXPECT_TRUE(Says(lacking, "<section id=\"quality\">"));
  EXPECT_FALSE(Says(lacking, "<section id=\"failures\">"));
  EXPECT_TRUE(Says(lacking, "vulkan.one-position"));
  const std::string violated = SubjectPageOf(ShortOf(Authority::kClause));
  EXPECT_FALSE(Says(violated, "<section id=\"quality\">"));
  EXPECT_TRUE(Says(violated, "<section id=\"failures\">"));
  EXPECT_TRUE(Says(violated, "required by vulkan.common-edge"));
}

}  // namespace
}  // namespace rasterproof::report
