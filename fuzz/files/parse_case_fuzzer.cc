// The parser of case and scene files.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "fuzz/files/parser.h"
#include "io/case_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using rasterproof::io::CaseFile;
  return rasterproof::fuzz::ReadsBack(
      rasterproof::fuzz::TextOf(data, size),
      [](std::string_view text) { return rasterproof::io::ParseCase(text, "fuzz"); },
      [](const CaseFile& file) { return rasterproof::io::CaseToJson(file); });
}
