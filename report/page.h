// The report page: one HTML file, offline, no scripts, no external links; pictures inline as SVG or
// data URIs.
#ifndef RASTERPROOF_REPORT_PAGE_H_
#define RASTERPROOF_REPORT_PAGE_H_

#include <string>
#include <vector>

#include "report/certificate.h"

namespace rasterproof::report {

/// A picture of the page: `svg` inline, or `png` bytes.
struct Picture {
  std::string caption;
  std::string command;  ///< that made it
  std::string svg;
  std::string png;
};

struct Page {
  std::string title;
  std::vector<Certificate> certificates;
  std::vector<Picture> pictures;
};

/// Verdict per subject and property, wrong, missing and unexpected samples per subject and real
/// scene, exercise counts, pictures with the commands that made them, environment.
std::string PageToHtml(const Page& page);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_PAGE_H_
