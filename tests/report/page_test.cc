#include "report/page.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "fmt/format.h"
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
  page.certificates[0].folder = "f32-direct";
  page.pictures = {
      {"a gap", "rasterproof explain case.json", "f32-direct", true, "f32-direct/bunny.svg",
       "<svg><rect/></svg>"},
      {"a bunny", "rasterproof coverage bunny.obj", "", true, "scenes/bunny.png", "\x89PNG"}};
  return page;
}

// The page of all subjects, and that of the first.
std::vector<std::string> PagesOf(const Page& page) {
  return {PageToHtml(page), SubjectPageToHtml(page, page.certificates[0])};
}

std::string SubjectPage(const Certificate& certificate) {
  return SubjectPageToHtml(Page{"a report", false, {certificate}, {}}, certificate);
}

std::string VerdictsOf(const Certificate& certificate) {
  return VerdictGroups(Page{"a report", false, {certificate}, {}});
}

TEST(PageTest, RunsOneScriptByItsHashAndLoadsNothingFromElsewhere) {
  const std::string script = fmt::format("<script>{}</script>", kPageScript);
  for (std::string html : PagesOf(SamplePage())) {
    EXPECT_EQ(Count(html, "<script"), 1U);
    EXPECT_TRUE(Has(html, fmt::format("script-src 'sha256-{}'", kPageScriptHash)));
    ASSERT_TRUE(Has(html, script));
    html.erase(html.find(script), script.size());  // which names the namespace of SVG
    EXPECT_TRUE(Has(html, "default-src 'none'"));
    for (const char* loads : {"http:", "https:", "<link", "@import", "url(", "=\"//"}) {
      EXPECT_FALSE(Has(html, loads)) << loads;
    }
  }
}

TEST(PageTest, LeadsToThePagesAndPicturesBesideIt) {
  const std::vector<std::string> pages = PagesOf(SamplePage());
  EXPECT_TRUE(Has(pages[0], "href=\"f32-direct/report.html\""));
  EXPECT_TRUE(Has(pages[0], "src=\"f32-direct/bunny.svg\""));
  EXPECT_TRUE(Has(pages[0], "src=\"scenes/bunny.png\""));
  EXPECT_TRUE(Has(pages[1], "href=\"../report.html\""));
  EXPECT_TRUE(Has(pages[1], "src=\"../f32-direct/bunny.svg\""));
  EXPECT_FALSE(Has(pages[1], "scenes/bunny.png"));
}

// A subject that shows values: affine ones, with a cause; derivatives that were not asked.
Certificate OfValues() {
  Certificate certificate = SampleCertificate();
  certificate.subject.name = "swims";
  certificate.subject.fragments.shows_values = true;
  PropertyResult values = SampleProperty("ValuesStayWithinTheirError", Outcome::kViolated);
  ComparedNumbers numbers;
  numbers.list = {{0, 0, 0, 0.25, 0.5, 1e-6, -2.5e5}};
  values.counterexample->verdict.numbers = std::make_shared<const ComparedNumbers>(numbers);
  certificate.tested = {values, SampleProperty("EqualValuesStayEqual", Outcome::kHolds),
                        SampleProperty("DerivativesStayWithinTheirError", Outcome::kNotApplicable)};
  certificate.causes = {{"ValuesStayWithinTheirError", "it interpolates on the <screen>"}};
  certificate.not_asked = {{"derivatives", "no property judges them"}};
  return certificate;
}

TEST(PageTest, AnswersThreeQuestionsOfValues) {
  const ValueMethodRow method{
      "differences", "a_0 + l_1 (a_1 - a_0)", {9, 9}, 0, 0, {0.348, 0.19}, "equal", "a proof"};
  const std::string html = ValuesSection({OfValues(), SampleCertificate()}, {method});
  for (const char* question : {"Which interpolation may I trust, at what cost?",
                               "My texture swims: weights or division?", "Is my du/dx right?"}) {
    EXPECT_EQ(Count(html, question), 1U) << question;
  }
  EXPECT_EQ(Count(html, "it interpolates on the &lt;screen&gt;"), 2U) << "of two questions";
  EXPECT_TRUE(Has(html, "2.5e+05")) << "the error of the counterexample over what is allowed";
  EXPECT_TRUE(Has(html, "not asked: it shows no edge values"));
  EXPECT_TRUE(Has(html, "derivatives <span class=\"why\">no property judges them"));
  EXPECT_TRUE(Has(html, "0.348"));
  EXPECT_FALSE(Has(html, "ns a pixel")) << "nobody measured it";
  EXPECT_TRUE(Has(html, "1 subject shows no values"));
}

TEST(PageTest, OfSubjectsWithoutValuesALineIsSaid) {
  const std::string html = ValuesSection({SampleCertificate()}, {});
  EXPECT_TRUE(Has(html, "1 subject shows no values: nothing was asked of them."));
  EXPECT_FALSE(Has(html, "<h3>"));
}

TEST(PageTest, EverythingThatOthersNamedIsEscaped) {
  Page page = SamplePage();
  const std::string evil = "\"><script>alert('1')</script><img src=x onerror=1>&\x1b";
  page.title = evil;
  for (Picture& picture : page.pictures) picture.caption = picture.command = picture.file = evil;
  Certificate& certificate = page.certificates[0];
  page.pictures[0].subject = evil;
  certificate.subject.name = evil;
  certificate.subject.summary = evil;
  certificate.subject.profile.name = evil;
  certificate.command = certificate.folder = evil;
  certificate.environment = {{evil, evil}};
  certificate.proved = {{evil, evil}};
  certificate.tested.back().world = evil;
  certificate.measured[0].scene = evil;
  certificate.measured[0].profile = evil;
  PropertyResult& result = certificate.tested[1];
  result.property = result.clause = result.message = result.tolerance = evil;
  Witness& witness = *result.counterexample->verdict.witness;
  witness.observed = witness.expected = {evil};
  certificate.replay[evil] = evil;
  for (const std::string& html : PagesOf(page)) {
    EXPECT_EQ(Count(html, "<script"), 1U);
    EXPECT_TRUE(Has(html, "&lt;script&gt;"));
    EXPECT_FALSE(Has(html, "<img src=x"));
    EXPECT_FALSE(Has(html, "\x1b"));
  }
}

TEST(PageTest, SaysTheVerdictThenItsSubjectsThenPictures) {
  const std::string html = PageToHtml(SamplePage());
  const std::size_t sentence =
      html.find("f32-direct is violated: properties violated: 1; scenes with wrong samples: 1.");
  ASSERT_NE(sentence, std::string::npos);
  EXPECT_LT(sentence, html.find("id=\"verdicts\""));
  EXPECT_LT(html.find("id=\"verdicts\""), html.find("id=\"pictures\""));
  EXPECT_LT(html.find("id=\"pictures\""), html.find("id=\"scenes\""));
  EXPECT_LT(html.find("id=\"scenes\""), html.find("id=\"properties\""));
  EXPECT_TRUE(Has(html, "<span class=\"chip violated\">violated</span>"));
}

// A survey of n methods that claim nothing, one that claims to be exact and a homogeneous one.
Page Survey(std::size_t n) {
  Page page{"a survey", true, {}, {}};
  page.certificates.assign(n + 2, SampleCertificate());
  for (std::size_t k = 0; k < page.certificates.size(); ++k) {
    Certificate& certificate = page.certificates[k];
    certificate.subject.name = certificate.folder = fmt::format("method-{}", k);
  }
  Certificate& exact = page.certificates[n];
  exact.subject.states_exact = true;
  exact.tested.resize(1);
  exact.measured.clear();
  page.certificates[n + 1].subject.takes_clip = true;
  page.certificates[n + 1].subject.takes_window = false;
  return page;
}

TEST(PageTest, ASurveyHasThreeGroupsByWhatSubjectsState) {
  const std::string html = VerdictGroups(Survey(3));
  EXPECT_TRUE(Has(html, "<strong>States exact coverage</strong>"));
  EXPECT_TRUE(Has(html, "1 subject: 1 holds"));
  EXPECT_TRUE(Has(html, "<strong>Naive, there to fail</strong>"));
  EXPECT_TRUE(Has(html, "3 subjects: 3 violated"));
  EXPECT_TRUE(Has(html, "<strong>Homogeneous</strong>"));
  EXPECT_EQ(Count(html, "<tr><th scope=\"row\">"), 5U) << "each subject in one group";
  EXPECT_EQ(
      VerdictSentence(Survey(3)),
      "The subject that states exact coverage holds. All 4 naive methods, there to fail, were "
      "found wrong.");
}

TEST(PageTest, TheWideColumnOfVerdictsIsTheOneWithNames) {
  const std::string html = VerdictGroups(Survey(1));
  const std::string head = html.substr(0, html.find("most on"));
  const std::string rule = fmt::format(".verdicts th:nth-child({}) {{ width: 18%; }}",
                                       Count(head.substr(head.rfind("<thead>")), "<th") - 1);
  EXPECT_TRUE(Has(PageToHtml(Survey(1)), rule)) << rule;
}

TEST(PageTest, AGroupWithoutSubjectsIsNotShown) {
  const std::string html = VerdictsOf(SampleCertificate());
  EXPECT_EQ(Count(html, "<details"), 1U);
  EXPECT_TRUE(Has(html, "States a profile"));
  EXPECT_FALSE(Has(html, "there to fail")) << "who asks for a subject holds it to its profile";
}

TEST(PageTest, ALongGroupIsFoldedAndAShortOneIsNot) {
  EXPECT_EQ(Count(VerdictGroups(Survey(12)), "<details open>"), 3U);
  EXPECT_EQ(Count(VerdictGroups(Survey(13)), "<details open>"), 2U);
}

TEST(PageTest, ASubjectCostsThePageARowHereAndThere) {
  const std::size_t few = PageToHtml(Survey(10)).size();
  const std::size_t many = PageToHtml(Survey(110)).size();
  constexpr std::size_t kMostPerSubject = 2500;  // bytes, of one scene and four properties
  EXPECT_LT(many - few, 100 * kMostPerSubject);
}

TEST(PageTest, OnlyWhatHoldsIsGreen) {
  const std::string page = SubjectPage(SampleCertificate());
  EXPECT_EQ(Count(page, "chip holds\">holds<"), 1U);
  EXPECT_EQ(Count(page, "chip violated\">violated<"), 2U) << "the subject and a property";
  EXPECT_EQ(Count(page, "chip idle\">not exercised<"), 1U);
}

TEST(PageTest, WhatCouldNotBeJudgedIsCountedAndNotGreen) {
  Certificate certificate = SampleCertificate();
  certificate.tested = {SampleProperty("a", Outcome::kInconclusive)};
  certificate.measured.clear();
  const std::string verdicts = VerdictsOf(certificate);
  EXPECT_FALSE(Has(verdicts, "chip holds"));
  EXPECT_TRUE(Has(verdicts, "<span class=\"chip idle\">inconclusive</span>"));
  EXPECT_EQ(Count(verdicts, "<td class=\"number \">1</td>"), 1U);
  EXPECT_EQ(Count(PropertyTable({certificate}), "<td class=\"number \">1</td>"), 1U);
}

TEST(PageTest, WhatALegalSubjectDrawsIsNotCalledWrong) {
  Certificate certificate = SampleCertificate();
  certificate.subject.profile.name = "free";
  certificate.subject.profile.freedom.snap_tolerance = 0.6;
  certificate.measured[0].profile = "free";
  EXPECT_FALSE(Has(VerdictsOf(certificate), ">5</td>"));
  EXPECT_TRUE(Has(SubjectPage(certificate), "its profile leaves more than one result legal"));
}

TEST(PageTest, CountsWhoHoldsAPropertyAndNamesWhoViolatesIt) {
  Certificate other = SampleCertificate();
  other.subject.name = "other";
  const std::string table = PropertyTable({SampleCertificate(), other});
  EXPECT_TRUE(Has(table, "Shared<wbr>Edge<wbr>Samples"));
  EXPECT_EQ(Count(table, "<td class=\"number wrong\">2</td>"), 1U);
  EXPECT_EQ(Count(table, ">other<"), 1U);
}

TEST(PageTest, CountsWrongMissingAndUnexpectedSamplesPerScene) {
  const std::string page = SubjectPage(SampleCertificate());
  EXPECT_TRUE(Has(page, "bunny &lt;front&gt;"));
  EXPECT_EQ(Count(page, "<td class=\"number split wrong\">5</td>"), 1U);
  EXPECT_TRUE(Has(page, ">50<"));  // per million of 100000 covered
  EXPECT_TRUE(Has(SceneTables({SampleCertificate()}), "bunny &lt;front&gt;"));
}

TEST(PageTest, CountsASceneOnceThoughTheOwnProfileIsTheRealOne) {
  Certificate certificate = SampleCertificate();
  certificate.measured.push_back(certificate.measured[0]);
  EXPECT_EQ(Count(VerdictsOf(certificate), "title=\"of 262\u202f144\">5<"), 2U);
}

TEST(PageTest, LeavesScenesBeyondTheLimitsOutOfTheTotals) {
  Certificate certificate = SampleCertificate();
  certificate.measured[0].message = "coordinates beyond what the profile states";
  EXPECT_FALSE(Has(VerdictsOf(certificate), ">5</td>"));
}

TEST(PageTest, SaysWhyASceneWasNotMeasured) {
  Certificate certificate = SampleCertificate();
  certificate.measured[0].applicable = false;
  certificate.measured[0].message = "the scene is in clip space";
  EXPECT_TRUE(Has(SubjectPage(certificate), "the scene is in clip space"));
}

TEST(PageTest, ShowsHowOftenEachPropertyWasPutToTheTest) {
  const std::string page = SubjectPage(SampleCertificate());
  EXPECT_TRUE(Has(page, "<td class=\"number\">1\u202f000</td><td class=\"number\">998</td>"));
  EXPECT_TRUE(Has(page, "12\u202f345"));
  EXPECT_TRUE(Has(page, "all 1000 of 1000 cases"));
}

TEST(PageTest, ACommandBreaksBetweenItsWordsOnly) {
  const std::string page = SubjectPage(SampleCertificate());
  EXPECT_TRUE(Has(page,
                  "<code><span>rasterproof</span> <span>replay</span> "
                  "<span>SharedEdgeSamplesAreCoveredOnce.json</span></code>"));
  EXPECT_EQ(Command("a --b 'c <d'"),
            "<pre><code><span>a</span> <span>--b</span> "
            "<span>&#39;c</span> <span>&lt;d&#39;</span></code></pre>\n");
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
  const std::string html = PageToHtml(Page{"nothing", false, {}, {}});
  EXPECT_TRUE(Has(html, "No subject was certified."));
  EXPECT_TRUE(html.ends_with("</html>\n"));
}

}  // namespace
}  // namespace rasterproof::report
