#include "report/page.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "report/page_parts.h"
#include "tests/report/sample_results.h"

namespace rasterproof::report {
namespace {

bool Has(std::string_view text, std::string_view what) {
  return text.find(what) != std::string_view::npos;
}

std::size_t Count(std::string_view text, std::string_view what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string_view::npos;
       at = text.find(what, at + 1)) {
    ++count;
  }
  return count;
}

Page SamplePage() {
  Page page;
  page.title = "a report";
  page.certificates = {SampleCertificate()};
  page.pictures = {{"a gap", "rasterproof explain case.json", "<svg><rect/></svg>", ""},
                   {"a bunny", "rasterproof render bunny.obj", "", "\x89PNG"}};
  return page;
}

TEST(PageTest, RunsNothingAndLoadsNothing) {
  const std::string html = PageToHtml(SamplePage());
  EXPECT_FALSE(Has(html, "<script"));
  EXPECT_FALSE(Has(html, "http:"));
  EXPECT_FALSE(Has(html, "https:"));
  EXPECT_FALSE(Has(html, "<link"));
  EXPECT_FALSE(Has(html, "@import"));
  EXPECT_FALSE(Has(html, "url("));
  EXPECT_TRUE(Has(html, "default-src 'none'"));
  EXPECT_EQ(Count(html, "href=\""), Count(html, "href=\"#"));
}

TEST(PageTest, EverythingThatOthersNamedIsEscaped) {
  Page page = SamplePage();
  const std::string evil = "\"><script>alert('1')</script><img src=x onerror=1>&\x1b";
  page.title = evil;
  page.pictures[0].caption = evil;
  page.pictures[0].command = evil;
  page.pictures[1].caption = evil;
  Certificate& certificate = page.certificates[0];
  certificate.subject.name = evil;
  certificate.subject.summary = evil;
  certificate.subject.profile.name = evil;
  certificate.command = evil;
  certificate.environment = {{evil, evil}};
  certificate.proved = {{evil, evil}};
  certificate.exhausted = {{evil, evil}};
  certificate.oracle_tiers = {{evil, 1}};
  certificate.measured[0].scene = evil;
  certificate.measured[0].profile = evil;
  certificate.measured[0].message = evil;
  PropertyResult& result = certificate.tested[1];
  result.property = result.clause = result.message = result.tolerance = evil;
  result.verdict->witness->observed = result.verdict->witness->expected = evil;
  const std::string html = PageToHtml(page);
  EXPECT_FALSE(Has(html, "<script"));
  EXPECT_FALSE(Has(html, "<img src=x"));
  EXPECT_FALSE(Has(html, "\x1b"));
}

TEST(PageTest, SaysEachVerdictOfTheSummaryFirst) {
  const std::string html = PageToHtml(SamplePage());
  const std::size_t verdicts = html.find("id=\"verdicts\"");
  EXPECT_LT(verdicts, html.find("id=\"scenes\""));
  EXPECT_LT(html.find("id=\"scenes\""), html.find("id=\"properties\""));
  EXPECT_TRUE(Has(html, "<span class=\"chip violated\">violated</span>"));
}

TEST(PageTest, OnlyWhatHoldsIsGreen) {
  const std::string matrix = PropertyMatrix({SampleCertificate()});
  EXPECT_EQ(Count(matrix, "mark holds"), 1U);
  EXPECT_EQ(Count(matrix, "mark violated"), 1U);
  EXPECT_EQ(Count(matrix, "mark idle"), 1U);
  EXPECT_EQ(Count(matrix, "mark none"), 1U);
}

TEST(PageTest, WhatCouldNotBeJudgedIsCountedAndNotGreen) {
  Certificate certificate = SampleCertificate();
  certificate.tested = {SampleProperty("a", Outcome::kInconclusive)};
  certificate.measured.clear();
  EXPECT_EQ(Count(PropertyMatrix({certificate}), "mark holds"), 0U);
  EXPECT_EQ(Count(PropertyMatrix({certificate}), "mark idle\">?<"), 1U);
  EXPECT_TRUE(Has(VerdictTable({certificate}), "<span class=\"chip idle\">inconclusive</span>"));
  EXPECT_EQ(Count(VerdictTable({certificate}), "<td class=\"number \">1</td>"), 1U);
}

TEST(PageTest, WhatALegalSubjectDrawsIsNotCalledWrong) {
  Certificate certificate = SampleCertificate();
  certificate.subject.profile.name = "free";
  certificate.subject.profile.freedom.snap_tolerance = 0.6;
  certificate.measured[0].profile = "free";
  EXPECT_EQ(Count(VerdictTable({certificate}), ">5 of"), 0U);
  EXPECT_TRUE(Has(SubjectDetails(certificate), "samples differ; its profile leaves more than one"));
}

TEST(PageTest, APropertyThatASubjectWasNotAskedIsNotGreenEither) {
  Certificate asked = SampleCertificate();
  Certificate other;
  other.subject.name = "other";
  const std::string matrix = PropertyMatrix({asked, other});
  EXPECT_EQ(Count(matrix, "mark holds"), 1U);
  EXPECT_EQ(Count(matrix, "mark none"), 5U);
}

TEST(PageTest, CountsWrongMissingAndUnexpectedSamplesPerScene) {
  const std::string tables = SceneTables({SampleCertificate()});
  EXPECT_TRUE(Has(tables, "bunny &lt;front&gt;"));
  EXPECT_EQ(Count(tables, "<td class=\"number split wrong\">5</td>"), 2U);
  EXPECT_TRUE(Has(tables, ">50<"));  // per million of 100000 covered
}

TEST(PageTest, CountsASceneOnceThoughTheOwnProfileIsTheRealOne) {
  Certificate certificate = SampleCertificate();
  certificate.measured.push_back(certificate.measured[0]);
  EXPECT_EQ(Count(VerdictTable({certificate}), ">5 of 262\u202f144<"), 2U);
}

TEST(PageTest, LeavesScenesBeyondTheLimitsOutOfTheTotals) {
  Certificate certificate = SampleCertificate();
  certificate.measured[0].message = "coordinates beyond what the profile states";
  EXPECT_EQ(Count(VerdictTable({certificate}), ">5 of"), 0U);
}

TEST(PageTest, SaysWhyASceneWasNotMeasured) {
  Certificate certificate = SampleCertificate();
  certificate.measured[0].applicable = false;
  certificate.measured[0].message = "the scene is in clip space";
  EXPECT_TRUE(Has(SceneTables({certificate}), "the scene is in clip space"));
}

TEST(PageTest, ShowsHowOftenEachPropertyWasPutToTheTest) {
  const std::string details = SubjectDetails(SampleCertificate());
  EXPECT_TRUE(Has(details, "998 of 1\u202f000"));
  EXPECT_TRUE(Has(details, "12\u202f345"));
  EXPECT_TRUE(Has(details, "rasterproof replay SharedEdgeSamplesAreCoveredOnce.json"));
  EXPECT_TRUE(Has(details, "N = 729"));
}

TEST(PageTest, TheNearEdgeClassesAreDisjoint) {
  // Four properties with 1000 samples each: 100 on the edge, 200 within 1, 300 within 16.
  const std::string table = NearEdgeTable({SampleCertificate()});
  for (const char* cell :
       {"4\u202f000</td>", ">400<svg", ">800<svg", ">400<svg", "2\u202f000<svg"}) {
    EXPECT_TRUE(Has(table, cell)) << cell << table;
  }
}

TEST(PageTest, AnEmptyReportIsStillAPage) {
  const std::string html = PageToHtml(Page{"nothing", {}, {}});
  EXPECT_TRUE(Has(html, "0 subjects"));
  EXPECT_TRUE(html.ends_with("</html>\n"));
}

TEST(PlainSvgTest, KeepsWhatDraws) {
  const std::string svg =
      "<svg xmlns=\"http://www.w3.org/2000/svg\"><g clip-path=\"url(#c)\">"
      "<text x=\"1\">a &lt; b</text></g></svg>";
  EXPECT_EQ(PlainSvg(svg), svg);
}

TEST(PlainSvgTest, DropsWhatRunsOrLoads) {
  const std::string plain = PlainSvg(
      "<?xml version=\"1.0\"?><!DOCTYPE svg><svg onload=\"a()\"><script>b()</script>"
      "<a href=\"http://c\"><rect/></a><image href=\"d.png\"/><use xlink:href=\"e.svg#f\"/>"
      "<text href=\"http://l\" xlink:href=\"m.svg\"/>"
      "<style>@import 'g'</style><foreignObject><p>h</p></foreignObject>"
      "<rect fill=\"url(http://i)\" onclick=\"j\" width=\"2\"/>"
      "<rect style=\"fill:u\\72l(k)\" width=\"3\"/></svg>");
  EXPECT_EQ(plain, "<svg><text/><rect width=\"2\"/><rect width=\"3\"/></svg>");
}

TEST(PlainSvgTest, GivesNothingForWhatIsNoSvg) {
  EXPECT_EQ(PlainSvg(""), "");
  EXPECT_EQ(PlainSvg("<svg><g></svg>"), "");
  EXPECT_EQ(PlainSvg("<html><svg/></html>"), "");
}

}  // namespace
}  // namespace rasterproof::report
