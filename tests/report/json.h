// JSON in tests. Parsing and printing it are compiled once: they cost seconds in every file.
#ifndef RASTERPROOF_TESTS_REPORT_JSON_H_
#define RASTERPROOF_TESTS_REPORT_JSON_H_

#include <iosfwd>
#include <string>

#include "nlohmann/json.hpp"

namespace rasterproof::report {

/// Returns the value of a text. Throws nlohmann::json::parse_error.
nlohmann::json ParseJson(const std::string& text);

}  // namespace rasterproof::report

namespace nlohmann {

/// What GoogleTest shows of a value that is not the expected one.
void PrintTo(const json& value, std::ostream* stream);

}  // namespace nlohmann

#endif  // RASTERPROOF_TESTS_REPORT_JSON_H_
