// The catalogue of stiff and extreme cases as JSON and as pages: one matrix, and a page a family.
#ifndef RASTERPROOF_REPORT_CATALOGUE_H_
#define RASTERPROOF_REPORT_CATALOGUE_H_

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rasterproof::report {

/// How one subject fares on one family by one yardstick.
struct CatalogueCell {
  std::uint64_t cases = 0;  ///< compared
  std::uint64_t wrong = 0;  ///< of these, with a wrong sample
  std::uint64_t samples = 0;
  std::uint64_t wrong_samples = 0;
  double worst_pixels = 0;  ///< of the first 64 wrong samples of a case; infinite: it broke down
  std::string worst_case;   ///< the name of its case
  std::uint64_t excused = 0;
  std::string why;  ///< of the first excused case, or how the subject broke down
  bool is_exhausted = false;
  /// The subject states 0 wrong samples by this yardstick and has proofs of its decisions.
  bool is_proved = false;
};

struct CatalogueColumn {
  std::string subject;
  std::string folder;  ///< of its page, as a path from the report; empty: it has none
  std::vector<std::array<CatalogueCell, 2>> cells;  ///< by family; own model, real geometry
};

/// What the worst case of a family looks like.
struct FamilyPicture {
  std::string caption;
  std::string subject;
  std::string svg;
};

struct CatalogueFamily {
  std::string name;
  std::string summary;
  std::string theme;
  std::string right;  ///< what a right rasterizer does
  std::optional<FamilyPicture> picture = std::nullopt;
};

struct Catalogue {
  std::uint64_t seed = 0;
  std::uint64_t cases = 0;  ///< of each family that is no world
  std::vector<CatalogueFamily> families;
  std::vector<CatalogueColumn> columns;
};

/// "fails 3 of 100, 1 to 8.5 %, 0.0017 px", "proved, 100 tested", "exhausted, 6561", "excused".
std::string FamilyText(const CatalogueCell& cell);

/// Version 1: families and subjects, each cell in full.
std::string CatalogueToJson(const Catalogue& catalogue);

/// The matrix: a row a family, a column a subject and, above the slash, its own model.
std::string CatalogueSection(const Catalogue& catalogue);

/// The page of family k: each subject's cells, with the command that saves its worst cases.
std::string FamilyPageToHtml(const Catalogue& catalogue, std::size_t k);
/// Where it lies, as a path from the report page, without its ending, which its picture shares.
std::string FamilyPagePath(const CatalogueFamily& family);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_CATALOGUE_H_
