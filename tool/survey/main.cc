// survey PLUGIN.so|PROGRAM.subject OUT.json [CASES [SECONDS]]: see survey.h. Part of
// `./run subjects`.
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "exact/environment.h"
#include "io/output.h"
#include "tool/survey/survey.h"

int main(int argc, char** argv) {
  if (argc < 3 || argc > 5) {
    std::fprintf(stderr, "usage: survey PLUGIN.so|PROGRAM.subject OUT.json [CASES [SECONDS]]\n");
    return 2;
  }
  try {
    if (const auto place = rasterproof::exact::InspectEnvironment(); !place.Honest()) {
      std::fprintf(stderr, "survey: %s\n", place.Complaint().c_str());
      return 2;
    }
    rasterproof::tool::SurveyOptions options;
    options.path = argv[1];
    if (argc > 3) options.cases = std::strtoull(argv[3], nullptr, 10);
    if (argc > 4) options.seconds = std::strtod(argv[4], nullptr);
    const rasterproof::tool::Survey survey = rasterproof::tool::RunSurvey(options);
    rasterproof::io::WriteFile(argv[2], rasterproof::tool::SurveyToJson(survey));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "survey: %s\n", error.what());
    return 2;
  }
}
