#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "core/error.h"
#include "report/page.h"

namespace rasterproof::report {
namespace {

// Of one domain it refused all cases.
constexpr std::string_view kSurvey = R"({
"rasterproof_survey": 4, "subject": "NAME", "summary": "a library", "seed": 1, "stated": "vulkan",
"model": {"profile": "real", "text": "8 bits", "wrong": 9, "samples": 307, "experiments": 12,
          "remark": "no model fits"},
"domains": [
  {"domain": "near-edge", "near_limits": false, "cases": 0, "refused": 5, "unjudged": 0,
   "meshes": 0, "triangles": 0, "samples": 0, "wrong": 0, "gaps": 0, "overlaps": 0,
   "subject_seconds": 0, "alone_seconds": 0, "seconds": 0,
   "faulty_cases": {"wrong": 0, "gap": 0, "overlap": 0, "batch": 0, "end": 0}, "findings": []},
  {"domain": "fans", "near_limits": true, "cases": 101, "refused": 102, "unjudged": 103,
   "meshes": 104, "triangles": 105, "samples": 106, "wrong": 107, "gaps": 108, "overlaps": 109,
   "subject_seconds": 0.25, "alone_seconds": 0.25, "seconds": 2,
   "faulty_cases": {"wrong": 110, "gap": 111, "overlap": 112, "batch": 113, "end": 114},
   "findings": [{"fault": "end", "name": "fans:17@1", "end": "signal 11", "case": {"scene": {
      "rasterproof_scene": 1, "width": 7, "height": 9, "precision": "float64",
      "vertices": [["0x1.8p-4", 0], [1, 0], [0, 1]], "triangles": [[0, 1, 2]]}}}]}]})";

std::string Changed(std::string_view from, std::string_view to) {
  std::string text(kSurvey);
  return text.replace(text.find(from), from.size(), to);
}

class SurveySectionTest : public testing::Test {
 protected:
  SurveySectionTest() { std::filesystem::create_directory(folder_); }
  ~SurveySectionTest() override { std::filesystem::remove_all(folder_); }

  void Put(const std::string& name, std::string_view text) const {
    std::ofstream(folder_ + "/" + name) << text;
  }
  std::string Of(std::string_view text) const {
    Put("a.json", text);
    return SurveySection(folder_);
  }

  std::string folder_ = testing::TempDir() + "surveys-" + std::to_string(getpid());
};

bool PageHas(std::string_view text, std::string_view what) {
  return text.find(what) != std::string_view::npos;
}

TEST_F(SurveySectionTest, ShowsEveryCountAndCase) {
  const std::string html = Of(kSurvey);
  for (int count = 101; count <= 114; ++count) {
    EXPECT_TRUE(PageHas(html, ">" + std::to_string(count) + "</td>")) << count;
  }
  // Of the sum: wrong in range and near limits, refused, triangles a second, ours of the time.
  for (const char* said : {">0</td><td class=\"number wrong\">107</td>", ">107</td>", ">420</td>",
                           ">75 %</td>", ">NAME<", ">a library<", ">preset vulkan<", ">8 bits<",
                           ">9 of 307<", ">no model fits<", ">near its limits<", ">in range<",
                           ">fans:17@1: end signal 11<", ">target 7 x 9\n(0x1.8p-4, 0x0p+0)"}) {
    EXPECT_TRUE(PageHas(html, said)) << said;
  }
}

TEST_F(SurveySectionTest, SaysWhereNoModelIsWrongAndWhereNoneWasFound) {
  EXPECT_TRUE(PageHas(
      Of(Changed("\"samples\": 307, \"experiments\": 12,\n          \"remark\": \"no model fits\"",
                 "\"samples\": 0, \"experiments\": 12, \"remark\": \"\"")),
      ">0, in 12 draws<"));
  EXPECT_TRUE(PageHas(Of(Changed("307", "0")), ">not found<"));
  EXPECT_TRUE(
      PageHas(Of(Changed("\"vulkan\"", R"({"name": "a", "contract": "none"})")), ">none, |x|"));
}

TEST_F(SurveySectionTest, OfASubjectThatRefusedEverythingThereAreNoTimes) {
  std::string text(kSurvey);
  const std::size_t last = text.find(",\n  {\"domain\": \"fans\"");
  const std::string html = Of(text.replace(last, std::string::npos, "]}"));
  EXPECT_TRUE(PageHas(html, "<td class=\"number\">–</td><td class=\"number\">–</td></tr>"));
}

TEST_F(SurveySectionTest, EscapesWhatOthersNamed) {
  for (const char* name :
       {"NAME", "a library", "8 bits", "no model", "near-edge", "fans:17@1", "signal 11"}) {
    const std::string html = Of(Changed(name, "<img src=x>"));
    EXPECT_FALSE(PageHas(html, "<img")) << name;
    EXPECT_TRUE(PageHas(html, "&lt;img")) << name;
  }
  Put("absent.txt", "<img src=x>\n");
  EXPECT_FALSE(PageHas(Of(kSurvey), "<img"));
}

TEST_F(SurveySectionTest, ShowsAllOfTheFolderByNameAndWhoIsAbsent) {
  Put("b.json", Changed("NAME", "second"));
  Put("absent.txt", "subject c: gone\n");
  const std::string html = Of(Changed("NAME", "first"));
  EXPECT_LT(html.find("href=\"#survey-0\">first<"), html.find("href=\"#survey-1\">second<"));
  EXPECT_TRUE(PageHas(html, "id=\"survey-1\""));
  EXPECT_TRUE(PageHas(html, "subject c: gone"));
}

TEST_F(SurveySectionTest, RefusesWhatIsNoSurvey) {
  EXPECT_THROW(SurveySection(folder_), InputError);
  EXPECT_THROW(SurveySection(folder_ + "/none"), InputError);
  for (const std::string& other :
       {std::string("{}"), std::string(kSurvey.substr(0, kSurvey.size() / 2)),
        Changed("survey\": 4", "survey\": 3"), Changed("remark", "mark"),
        Changed("\"gaps\": 108", "\"gaps\": -1"), Changed("[0, 1, 2]", "[0, 1, 3]")}) {
    EXPECT_THROW(Of(other), InputError) << other;
  }
}

}  // namespace
}  // namespace rasterproof::report
