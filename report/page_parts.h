// The parts of the report page, each a piece of HTML.
#ifndef RASTERPROOF_REPORT_PAGE_PARTS_H_
#define RASTERPROOF_REPORT_PAGE_PARTS_H_

#include <string>
#include <string_view>
#include <vector>

#include "report/certificate.h"
#include "report/page.h"

namespace rasterproof::report {

/// The style sheet. Light and dark as the reader's system has it; readable without it, too.
extern const std::string_view kPageStyle;

/// The class of the style sheet that shows an outcome.
std::string_view LookOf(Outcome outcome);

/// What an element refers to a subject by.
std::string AnchorOf(const Certificate& certificate);

/// One line per subject: verdict, properties, counts of outcomes, wrong samples over all scenes.
std::string VerdictTable(const std::vector<Certificate>& certificates);
/// A table per scene: wrong, missing and unexpected samples of every subject.
std::string SceneTables(const std::vector<Certificate>& certificates);
/// Properties against subjects, an outcome each.
std::string PropertyMatrix(const std::vector<Certificate>& certificates);
/// How many samples lay on an edge, and how near the others were.
std::string NearEdgeTable(const std::vector<Certificate>& certificates);
/// Everything that is known of one subject.
std::string SubjectDetails(const Certificate& certificate);
/// Compiler, flags and floating-point environment, once for all subjects that share them.
std::string Environments(const std::vector<Certificate>& certificates);
std::string Figure(const Picture& picture);

/// The drawing with everything removed that is not plain SVG: scripts, handlers, references out of
/// the file.
///
/// Returns:    empty if the text is no SVG.
std::string PlainSvg(std::string_view svg);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_PAGE_PARTS_H_
