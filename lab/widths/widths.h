// How many bits the values of an integer edge function take: tables of them, and cases.
#ifndef RASTERPROOF_LAB_WIDTHS_WIDTHS_H_
#define RASTERPROOF_LAB_WIDTHS_WIDTHS_H_

#include <string>
#include <vector>

#include "core/scene.h"
#include "exact/edge_widths.h"
#include "io/case_file.h"

namespace rasterproof::lab {

/// The unit, and a row a value: its bits and an input that needs the last of them.
std::string WidthsTable(const exact::EdgeUnit& unit, const std::vector<exact::EdgeWidth>& widths);
/// The same as JSON, with the least and the most that each value takes.
std::string WidthsJson(const exact::EdgeUnit& unit, const std::vector<exact::EdgeWidth>& widths);

/// The input that needs the last bit of the value, as a case.
io::CaseFile WitnessCase(const exact::EdgeUnit& unit, const exact::EdgeWidth& width);
/// Whether the box of the scene's triangle has a pixel of the target in common, or part of two.
bool MeetsTheTarget(const Scene& scene);

}  // namespace rasterproof::lab

#endif  // RASTERPROOF_LAB_WIDTHS_WIDTHS_H_
