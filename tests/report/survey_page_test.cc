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
"rasterproof_comparison": 1, "seed": 7, "cases": 101, "what": "domains", "one": "domain",
"yardsticks": ["nearest model", "gaps"],
"domains": [
  {"name": "near-edge", "summary": "", "theme": "in range", "right": "near the target"},
  {"name": "fans", "summary": "", "theme": "near its limits", "right": "far out"}],
"subjects": [{"subject": "NAME", "nearest_model": "8 bits", "fit": "no model fits", "cells": [
  {"domain": "near-edge", "nearest_model": {"state": "excused", "cases": 0, "wrong": 0, "ended": 0,
     "worst_pixels": 0, "worst_case": "", "excused": 5, "why": "it is too long"},
   "gaps": {"state": "tested", "cases": 3, "wrong": 0, "ended": 0, "worst_pixels": 0,
     "worst_case": "", "excused": 0, "why": ""}},
  {"domain": "fans", "nearest_model": {"state": "fails", "cases": 100, "wrong": 25, "ended": 0,
     "worst_pixels": 0.25, "worst_case": "fans:17@7", "excused": 0, "why": ""},
   "gaps": {"state": "fails", "cases": 4, "wrong": 4, "ended": 4, "worst_pixels": "inf",
     "worst_case": "fans:3@7", "excused": 0, "why": "signal 11"}}]}]})";

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

TEST_F(SurveySectionTest, ShowsEveryCellAndCase) {
  const std::string html = Of(kSurvey);
  for (const char* said :
       {">NAME<", "nearest model: 8 bits", "fit: no model fits", ">near-edge<", "far out", ">25 %<",
        "fails 25 of 100", "0.25 px, fans:17@7", "broke down, fans:3@7: signal 11",
        "it is too long", "nearest model, gaps", "(seed 7)"}) {
    EXPECT_TRUE(PageHas(html, said)) << said;
  }
}

TEST_F(SurveySectionTest, EscapesWhatOthersNamed) {
  for (const char* name :
       {"NAME", "8 bits", "no model", "fans:17@7", "signal 11", "it is too long", "far out"}) {
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
  EXPECT_LT(html.find(">first<"), html.find(">second<"));
  EXPECT_TRUE(PageHas(html, "subject c: gone"));
}

TEST_F(SurveySectionTest, RefusesWhatIsNoSurvey) {
  EXPECT_THROW(SurveySection(folder_), InputError);
  EXPECT_THROW(SurveySection(folder_ + "/none"), InputError);
  for (const std::string& other :
       {std::string("{}"), std::string(kSurvey.substr(0, kSurvey.size() / 2)),
        Changed("comparison\": 1", "comparison\": 2"), Changed("\"why\"", "\"because\""),
        Changed("\"wrong\": 25", "\"wrong\": -1"), Changed("\"gaps\"],", "\"holes\"],")}) {
    EXPECT_THROW(Of(other), InputError) << other;
  }
  // The page states one list of rows, one seed, one number of cases.
  for (const std::string& other :
       {Changed("\"near-edge\", \"summary\"", "\"grids\", \"summary\""),
        Changed("\"seed\": 7", "\"seed\": 8"), Changed("\"cases\": ", "\"cases\": 1")}) {
    Put("b.json", other);
    EXPECT_THROW(Of(kSurvey), InputError) << other;
  }
}

}  // namespace
}  // namespace rasterproof::report
