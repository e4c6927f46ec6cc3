// Comparisons as text, as JSON and as pages: one matrix, and a page a family.
#ifndef RASTERPROOF_REPORT_COMPARISON_H_
#define RASTERPROOF_REPORT_COMPARISON_H_

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/comparison.h"

namespace rasterproof::report {

/// What the worst case of a family looks like.
struct FamilyPicture {
  std::string caption;
  std::string subject;
  std::string svg;
};

/// The catalogue of stiff and extreme cases, by own model and real geometry, as pages show it.
struct Catalogue {
  ComparisonTable table;
  std::vector<std::string> folders;  ///< of each subject's page, as a path from the report
  std::vector<std::optional<FamilyPicture>> pictures;  ///< by row
};

/// "fails 3 of 100, 1 to 8.5 %, 0.0017 px", "proved, 100 tested", "exhausted, 6561", "excused".
std::string CellText(const Cell& cell);

/// The table of one subject: a line a row, by theme, and in a last line how many stand and fail.
std::string ComparisonText(const ComparisonTable& table, const ComparedSubject& subject);

/// Version 1: rows and subjects, each cell in full. Facts are members.
std::string ComparisonToJson(const ComparisonTable& table);
/// The key of a yardstick or a fact: "own_model".
std::string JsonKey(std::string name);

/// A row a line, a column a subject; in a cell the yardsticks from above.
std::string ComparisonMatrix(const ComparisonTable& table);

/// The same of a catalogue, whose names lead to pages.
std::string CatalogueSection(const Catalogue& catalogue);

/// The page of family k: each subject's cells, with the command that saves its worst cases.
std::string FamilyPageToHtml(const Catalogue& catalogue, std::size_t k);
/// Where it lies, as a path from the report page, without its ending, which its picture shares.
std::string FamilyPagePath(const ComparedRow& family);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_COMPARISON_H_
