// The report: a page of all subjects, and beside it a page of each with all that is known of it.
// They show pictures that lie beside them, load nothing else, and run one script that sorts tables
// and chooses what is shown of a bench.
#ifndef RASTERPROOF_REPORT_PAGE_H_
#define RASTERPROOF_REPORT_PAGE_H_

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/bench_result.h"
#include "report/certificate.h"
#include "report/comparison.h"

namespace rasterproof::report {

/// A picture beside the page.
struct Picture {
  std::string caption;
  std::string command;  ///< that makes it again, as a shell reads it
  std::string subject;  ///< whose failure it shows; empty: a scene as it is
  /// Whether the page of all subjects shows it, too; failures alone are asked.
  bool is_on_front = true;
  std::string file;     ///< where it lies, as a path from the page: "textbook/map.svg"
  std::string content;  ///< SVG or PNG
  /// PlayFragment() of what failed; empty: the playground can't open it.
  std::string fragment = {};
};

/// A way of interpolating, with its bound and the largest error / bound, in float32 and float64.
struct ValueMethodRow {
  std::string name;
  std::string computes;
  std::array<double, 2> conditions{};
  double a_step = 0;  ///< conditions more, for each step
  double ulps = 0;    ///< the bound where it is in ulps
  std::array<double, 2> largest{};
  std::string promises;  ///< what holds to the bit
  std::string proof;
  std::optional<double> nanoseconds = std::nullopt;  ///< a covered pixel
};

struct Page {
  std::string title;
  /// True if every built-in method was certified: those that do not claim to be exact are then
  /// here to be seen failing.
  bool is_survey = false;
  std::vector<Certificate> certificates;
  std::vector<Picture> pictures;
  std::optional<BenchResult> bench = std::nullopt;  ///< error against run time, before the verdicts
  std::optional<Catalogue> catalogue = std::nullopt;  ///< of stiff cases, after the verdicts
  std::vector<ValueMethodRow> value_methods = {};
  std::string surveys = {};    ///< a SurveySection, after the catalogue
  std::string folder = "out";  ///< where the page lies, as commands on it say
  /// The address of the browser's page, in whose playground failures open: absolute, or from here.
  /// Empty: there is none, and no link.
  std::string playground = {};
};

/// The section on the files that `rasterproof survey --json` wrote into a folder: a matrix of their
/// subjects, what each was compared with, and the lines of absent.txt, if it is there, on subjects
/// that could not be surveyed.
///
/// Error:      InputError if one is no comparison, or of other rows, or if the folder has none.
std::string SurveySection(const std::string& folder);

/// The page of all subjects: what was shown in a sentence or two; error against run time, where a
/// bench is given; the subjects in groups by what they state, pictures of failures, scenes,
/// properties, environment.
///
/// Properties: each subject costs a row here and there; what is known of it lies on its own page,
///             `<folder of the certificate>/report.html`.
std::string PageToHtml(const Page& page);

/// The page of one of the page's subjects: what failed and how to see it again, every property,
/// every scene, the evidence.
std::string SubjectPageToHtml(const Page& page, const Certificate& certificate);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_PAGE_H_
