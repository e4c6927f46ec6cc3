// Test vectors as tables that compilers and simulators load.
#ifndef RASTERPROOF_REPORT_VECTORS_TABLES_H_
#define RASTERPROOF_REPORT_VECTORS_TABLES_H_

#include <string>
#include <utility>
#include <vector>

#include "core/test_vector.h"

namespace rasterproof::report {

/// A file's name and its text.
using NamedText = std::pair<std::string, std::string>;

/// A C header: static const arrays of cases, triangles, joint constraints and rows of samples.
///
/// Domain:     every vector has `on_lattice`.
std::string VectorsAsC(const VectorsHeader& header, const std::vector<TestVector>& vectors);

/// Files that $readmemh loads, a word a line, and a header of SystemVerilog with their sizes.
///
/// Domain:     as VectorsAsC.
std::vector<NamedText> VectorsAsReadmemh(const VectorsHeader& header,
                                         const std::vector<TestVector>& vectors);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_VECTORS_TABLES_H_
