#include <gtest/gtest.h>

#include <string>

#include "pugixml.hpp"
#include "report/certificate.h"
#include "tests/report/sample_results.h"

namespace rasterproof::report {
namespace {

class JUnitTest : public testing::Test {
 protected:
  pugi::xml_node Suite(const Certificate& certificate) {
    text_ = JUnitXml(certificate);
    EXPECT_TRUE(document_.load_string(text_.c_str())) << text_;
    return document_.child("testsuites").child("testsuite");
  }
  static pugi::xml_node Case(pugi::xml_node suite, const std::string& name) {
    return suite.find_child_by_attribute("testcase", "name", name.c_str());
  }

  std::string text_;
  pugi::xml_document document_;
};

TEST_F(JUnitTest, HasATestForEachPropertyAndEachJudgedScene) {
  const pugi::xml_node suite = Suite(SampleCertificate());
  EXPECT_EQ(suite.attribute("tests").as_int(), 6);
  EXPECT_EQ(suite.attribute("failures").as_int(), 2);
  EXPECT_EQ(suite.attribute("skipped").as_int(), 2);
  EXPECT_STREQ(suite.attribute("name").value(), "f32-direct");
}

TEST_F(JUnitTest, WhatIsExhaustedSaysSo) {
  const pugi::xml_node test =
      Case(Suite(SampleCertificate()), "CoverageEqualsTheModel on triangles-3x3");
  ASSERT_TRUE(test);
  EXPECT_STREQ(test.child_value("system-out"), "exhausted: all 1000 of 1000 cases\n");
}

TEST_F(JUnitTest, WhatHoldsSaysNothing) {
  const pugi::xml_node test = Case(Suite(SampleCertificate()), "EdgeIsAntisymmetric");
  ASSERT_TRUE(test);
  EXPECT_FALSE(test.first_child());
}

TEST_F(JUnitTest, AViolationFailsWithItsMessageWitnessAndReplay) {
  const pugi::xml_node test = Case(Suite(SampleCertificate()), "SharedEdgeSamplesAreCoveredOnce");
  const pugi::xml_node failure = test.child("failure");
  ASSERT_TRUE(failure);
  EXPECT_STREQ(failure.attribute("message").value(), "sample covered twice");
  const std::string text = failure.text().get();
  EXPECT_NE(text.find("pixel (2, 3)"), std::string::npos);
  EXPECT_NE(text.find("replay: rasterproof replay"), std::string::npos);
}

TEST_F(JUnitTest, WhatWasNotPutToTheTestIsSkippedWithTheReason) {
  const pugi::xml_node suite = Suite(SampleCertificate());
  EXPECT_STREQ(Case(suite, "SteppingIsExact").child("skipped").attribute("message").value(),
               "not applicable: it shows no edge values");
  EXPECT_STREQ(Case(suite, "HubIsCoveredOnce").child("skipped").attribute("message").value(),
               "not exercised: no sample lay on an edge");
}

TEST_F(JUnitTest, AWrongSampleOnAJudgedSceneFails) {
  const pugi::xml_node test = Case(Suite(SampleCertificate()), "SceneMatchesModel: bunny <front>");
  EXPECT_TRUE(test.child("failure"));
  Certificate sound = SampleCertificate();
  sound.measured[0].difference.wrong = 0;
  document_.reset();
  EXPECT_FALSE(Case(Suite(sound), "SceneMatchesModel: bunny <front>").child("failure"));
}

TEST_F(JUnitTest, AnInconclusiveCertificateIsNeverGreen) {
  Certificate sample = SampleCertificate();
  sample.tested = {SampleProperty("a", Outcome::kInconclusive)};
  sample.tested[0].message = "too slow to judge";
  sample.measured.clear();
  const pugi::xml_node suite = Suite(sample);
  EXPECT_STREQ(Case(suite, "a").child("skipped").attribute("message").value(),
               "inconclusive: too slow to judge");
  EXPECT_EQ(suite.attribute("errors").as_int(), 1);
  EXPECT_STREQ(Case(suite, "CertificateIsConclusive").child("error").attribute("message").value(),
               "inconclusive: a: too slow to judge");
}

TEST_F(JUnitTest, WhatHoldsWhereItWasNotRefusedSaysSo) {
  Certificate sample = SampleCertificate();
  sample.tested[0].cases_refused = 2;
  const pugi::xml_node test = Case(Suite(sample), "EdgeIsAntisymmetric");
  EXPECT_STREQ(test.child("system-out").text().get(),
               "holds where it did not refuse: exercised in 998 of 1000 cases, 2 refused\n");
}

TEST_F(JUnitTest, ASceneThatIsNotJudgedIsSkippedWithTheReason) {
  Certificate sample = SampleCertificate();
  sample.measured[0].applicable = false;
  sample.measured[0].message = "the subject refused it: too large";
  const pugi::xml_node test = Case(Suite(sample), "SceneMatchesModel: bunny <front>");
  EXPECT_STREQ(test.child("skipped").attribute("message").value(),
               "not applicable: the subject refused it: too large");
}

TEST_F(JUnitTest, HoldsNoCharacterThatXmlForbids) {
  Certificate sample = SampleCertificate();
  sample.subject.name = "a\x01<b>\x1b&\xff\"c\"";
  sample.tested[1].message = std::string("nul \0 and escape \x1b[31m", 22);
  Suite(sample);
  for (const char c : text_) {
    EXPECT_TRUE(static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\t') << text_;
  }
  EXPECT_EQ(text_.find("&#"), std::string::npos) << text_;
  EXPECT_NE(text_.find("a\\x01&lt;b>\\x1b&amp;\\xff"), std::string::npos) << text_;
}

}  // namespace
}  // namespace rasterproof::report
