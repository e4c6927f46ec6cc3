#include "report/certificate.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "io/case_file.h"
#include "io/output.h"
#include "report/page.h"
#include "tests/report/json.h"
#include "tests/report/sample_results.h"
#include "tests/report/schema.h"

namespace rasterproof::report {
namespace {

using nlohmann::json;

json Schema() { return ParseJson(io::ReadFile("docs/certificate.schema.json")); }

json Parsed(const Certificate& certificate) { return ParseJson(CertificateToJson(certificate)); }

TEST(CertificateTest, FollowsItsSchema) {
  const auto errors = SchemaErrors(Schema(), Parsed(SampleCertificate()));
  EXPECT_TRUE(errors.empty()) << errors.front();
}

TEST(CertificateTest, AnEmptyOneFollowsItsSchemaToo) {
  const auto errors = SchemaErrors(Schema(), Parsed(Certificate{}));
  EXPECT_TRUE(errors.empty()) << errors.front();
}

TEST(CertificateTest, TheSchemaRefusesWhatItDoesNotDescribe) {
  const json good = Parsed(SampleCertificate());
  json extra = good;
  extra["green"] = true;
  EXPECT_FALSE(SchemaErrors(Schema(), extra).empty());
  json missing = good;
  missing["tested"][0].erase("exercised");
  EXPECT_FALSE(SchemaErrors(Schema(), missing).empty());
  json inexact = good;
  inexact["tested"][0]["worst_ratio"] = "0.75";
  EXPECT_FALSE(SchemaErrors(Schema(), inexact).empty());
  json green = good;
  green["tested"][0]["outcome"] = "not applicable";
  EXPECT_FALSE(SchemaErrors(Schema(), green).empty());
}

TEST(CertificateTest, KeepsTheFourWordsApart) {
  const json certificate = Parsed(SampleCertificate());
  EXPECT_EQ(certificate["proved"].size(), 1U);
  ASSERT_EQ(certificate["exhausted"].size(), 1U);
  EXPECT_EQ(certificate["exhausted"][0]["statement"], "CoverageEqualsTheModel on triangles-3x3");
  EXPECT_EQ(certificate["exhausted"][0]["by"],
            "all 1000 of 1000 cases, 998 of which put it to the test");
  EXPECT_EQ(certificate["tested"].size(), 3U);
  EXPECT_EQ(certificate["measured"].size(), 1U);
}

// One case of the world that was not run, was refused or was left open: the word is "tested".
TEST(CertificateTest, SaysExhaustedOnlyOfWholeWorlds) {
  const auto is_exhausted = [](const auto& change) {
    Certificate sample = SampleCertificate();
    change(sample.tested.back());
    const json certificate = Parsed(sample);
    EXPECT_EQ(certificate["tested"].size() + certificate["exhausted"].size(), 4U);
    EXPECT_TRUE(SchemaErrors(Schema(), certificate).empty());
    return !certificate["exhausted"].empty();
  };
  EXPECT_TRUE(is_exhausted([](PropertyResult&) {}));
  EXPECT_FALSE(is_exhausted([](PropertyResult& result) { --result.cases; }));
  EXPECT_FALSE(is_exhausted([](PropertyResult& result) { result.cases_refused = 1; }));
  EXPECT_FALSE(is_exhausted([](PropertyResult& result) { result.not_judged = 1; }));
  EXPECT_FALSE(is_exhausted([](PropertyResult& result) { result.world.clear(); }));
  EXPECT_FALSE(
      is_exhausted([](PropertyResult& result) { result.outcome = Outcome::kInconclusive; }));
}

TEST(CertificateTest, SaysWhatDoesNotApplyOnceAndNeverAmongTheTested) {
  Certificate sample = SampleCertificate();
  json certificate = Parsed(sample);
  ASSERT_EQ(certificate["not_applicable"].size(), 1U) << "nothing but what a result says";
  EXPECT_EQ(certificate["not_applicable"][0]["statement"], "SteppingIsExact");
  EXPECT_EQ(certificate["not_applicable"][0]["by"], "it shows no edge values");
  sample.measured[0].applicable = false;
  sample.measured[0].message = "the subject refused it: too large";
  sample.measured.push_back(sample.measured[0]);
  certificate = Parsed(sample);
  ASSERT_EQ(certificate["not_applicable"].size(), 2U);
  EXPECT_EQ(certificate["not_applicable"][1]["statement"], "scene bunny <front>");
  EXPECT_EQ(certificate["not_applicable"][1]["by"], "the subject refused it: too large");
}

TEST(CertificateTest, ACounterexampleIsACaseFileWithTheSameBits) {
  const Certificate sample = SampleCertificate();
  const json counterexample = Parsed(sample)["tested"][1]["counterexample"];
  const io::CaseFile file = io::ParseCase(counterexample["case"].dump(), "case");
  EXPECT_EQ(file.value, sample.tested[1].counterexample->value);
  EXPECT_EQ(file.property, "SharedEdgeSamplesAreCoveredOnce");
  EXPECT_EQ(counterexample["witness"]["observed"], "2");
  EXPECT_EQ(counterexample["found_as_case"], "needles:12@7");
}

TEST(CertificateTest, NamesTheCommandThatReplaysACounterexample) {
  Certificate sample = SampleCertificate();
  EXPECT_EQ(Parsed(sample)["tested"][1]["counterexample"]["replay"],
            "rasterproof replay SharedEdgeSamplesAreCoveredOnce.json");
  sample.replay["SharedEdgeSamplesAreCoveredOnce"] = "rasterproof replay out/a.json";
  EXPECT_EQ(Parsed(sample)["tested"][1]["counterexample"]["replay"],
            "rasterproof replay out/a.json");
}

TEST(CertificateTest, NumbersThatMatterAreExactAndNeverNull) {
  Certificate sample = SampleCertificate();
  sample.tested[0].worst_ratio = std::numeric_limits<double>::quiet_NaN();
  sample.tested[1].worst_ratio = std::numeric_limits<double>::infinity();
  sample.tested[0].seconds = std::numeric_limits<double>::infinity();
  const std::string text = CertificateToJson(sample);
  EXPECT_EQ(text.find("null"), std::string::npos);
  const json certificate = ParseJson(text);
  EXPECT_EQ(certificate["tested"][0]["worst_ratio"], "nan");
  EXPECT_EQ(certificate["tested"][1]["worst_ratio"], "inf");
  EXPECT_EQ(certificate["tested"][0]["seed"], "18446744073709551615");
  EXPECT_TRUE(SchemaErrors(Schema(), certificate).empty());
}

TEST(CertificateTest, StaysJsonWhateverBytesItIsToldToSay) {
  Certificate sample = SampleCertificate();
  sample.command = "a \"quoted\" \\ \x01 \xff\xfe line\n";
  EXPECT_TRUE(SchemaErrors(Schema(), Parsed(sample)).empty());
}

TEST(VerdictTest, AViolatedPropertyViolates) {
  EXPECT_EQ(OverallVerdict(SampleCertificate()), "violated");
}

TEST(VerdictTest, NothingExercisedIsInconclusiveAndNeverGreen) {
  Certificate certificate;
  EXPECT_EQ(OverallVerdict(certificate), "inconclusive");
  certificate.tested = {SampleProperty("a", Outcome::kNotExercised),
                        SampleProperty("b", Outcome::kNotApplicable)};
  EXPECT_EQ(OverallVerdict(certificate), "inconclusive");
  certificate.tested.push_back(SampleProperty("c", Outcome::kHolds));
  EXPECT_EQ(OverallVerdict(certificate), "holds");
}

TEST(VerdictTest, WhatCouldNotBeJudgedIsInconclusiveWhateverElseHolds) {
  Certificate certificate;
  certificate.tested = {SampleProperty("a", Outcome::kHolds),
                        SampleProperty("b", Outcome::kInconclusive)};
  certificate.tested[1].message = "too slow to judge";
  EXPECT_EQ(OverallVerdict(certificate), "inconclusive");
  EXPECT_EQ(OverallOf(certificate).reason, "b: too slow to judge");
  const auto errors = SchemaErrors(Schema(), Parsed(certificate));
  EXPECT_TRUE(errors.empty()) << errors.front();
  certificate.tested.push_back(SampleProperty("c", Outcome::kViolated));
  EXPECT_EQ(OverallVerdict(certificate), "violated");
}

TEST(VerdictTest, AnInterruptedRunIsNoPass) {
  Certificate certificate;
  certificate.tested = {SampleProperty("a", Outcome::kHolds)};
  certificate.interrupted = true;
  EXPECT_EQ(OverallVerdict(certificate), "inconclusive");
  EXPECT_EQ(Parsed(certificate)["interrupted"], true);
  certificate.tested.push_back(SampleProperty("c", Outcome::kViolated));
  EXPECT_EQ(OverallVerdict(certificate), "violated");
}

TEST(VerdictTest, WhatHoldsBesideTheContractIsNoEvidenceForIt) {
  Certificate certificate;
  certificate.tested = {SampleProperty("a", Outcome::kHolds)};
  certificate.contract_untested = "edge_samples are may-be-shared";
  EXPECT_EQ(OverallVerdict(certificate), "inconclusive");
  EXPECT_EQ(OverallOf(certificate).reason,
            "its contract was not put to the test: edge_samples are may-be-shared");
  certificate.measured = SampleCertificate().measured;
  certificate.measured[0].difference.wrong = 0;
  EXPECT_EQ(OverallVerdict(certificate), "holds") << "a judged scene is evidence";
}

TEST(VerdictTest, TellsThinEvidenceAndHolds) {
  Certificate certificate;
  certificate.tested = {SampleProperty("a", Outcome::kHolds)};
  certificate.contract_thin = "thin: 3 samples on an edge";
  EXPECT_EQ(OverallVerdict(certificate), "holds");
  EXPECT_EQ(OverallOf(certificate).reason, "thin: 3 samples on an edge");
}

TEST(VerdictTest, SaysWhatItDoesNotSpeakFor) {
  PropertyResult result = SampleProperty("a", Outcome::kHolds);
  EXPECT_EQ(Reservations(result), "");
  result.cases = 120;
  result.cases_exercised = 2;
  result.cases_refused = 118;
  EXPECT_EQ(Reservations(result),
            "holds where it did not refuse: exercised in 2 of 120 cases, 118 refused");
  result.not_judged = 7;
  result.message = "seen";
  EXPECT_EQ(Said(result), result.message + "; " + Reservations(result));
  PropertyResult said = result;
  said.message = "holds where it did not refuse: exercised in 2 of 120 cases, 118 refused";
  said.message_counts_refused = true;
  EXPECT_TRUE(Reservations(said).starts_with("7 samples not judged")) << "and said once";
  Certificate certificate;
  certificate.tested = {result};
  const json tested = Parsed(certificate)["tested"][0];
  EXPECT_EQ(tested["cases_refused"], 118);
  EXPECT_EQ(tested["not_judged"], 7);
  EXPECT_NE(SubjectPageToHtml({}, certificate).find("118 refused; 7 samples not judged"),
            std::string::npos);
}

TEST(VerdictTest, AWrongSampleOnAJudgedSceneViolates) {
  Certificate certificate = SampleCertificate();
  certificate.tested = {SampleProperty("a", Outcome::kHolds)};
  EXPECT_EQ(OverallVerdict(certificate), "violated");
  certificate.measured[0].difference.wrong = 0;
  EXPECT_EQ(OverallVerdict(certificate), "holds");
}

TEST(VerdictTest, WhatIsObservedIsNotJudged) {
  Certificate certificate = SampleCertificate();
  certificate.tested = {SampleProperty("a", Outcome::kHolds)};
  SceneResult& result = certificate.measured[0];

  result.message = "coordinates beyond what the profile states: observed, not judged";
  EXPECT_EQ(OverallVerdict(certificate), "holds");
  result.message.clear();

  result.profile = "another";
  EXPECT_EQ(OverallVerdict(certificate), "holds");
  result.profile = "real";

  // Where a profile leaves choices, a scene that differs from the canonical model may be legal.
  certificate.subject.profile.freedom.snap_tolerance = 0.6;
  EXPECT_EQ(OverallVerdict(certificate), "holds");
  EXPECT_NE(CertificateToJson(certificate).find("leaves more than one result legal"),
            std::string::npos);
  certificate.subject.profile.freedom = {};
  EXPECT_EQ(OverallVerdict(certificate), "violated");

  certificate.subject.profile.contract = Contract::kNone;
  EXPECT_EQ(OverallVerdict(certificate), "holds");
  certificate.subject.states_exact = true;
  EXPECT_EQ(OverallVerdict(certificate), "violated");
}

}  // namespace
}  // namespace rasterproof::report
