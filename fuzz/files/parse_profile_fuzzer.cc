// The parser of profile files.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/profile.h"
#include "fuzz/files/parser.h"
#include "io/case_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using rasterproof::Profile;
  return rasterproof::fuzz::ReadsBack(
      rasterproof::fuzz::TextOf(data, size),
      [](std::string_view text) {
        return rasterproof::io::ParseProfile(std::string(text), "fuzz");
      },
      [](const Profile& profile) { return rasterproof::io::ProfileToJson(profile); });
}
