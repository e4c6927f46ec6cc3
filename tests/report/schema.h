// Checks a JSON value against the part of JSON Schema that the certificate's schema uses.
#ifndef RASTERPROOF_TESTS_REPORT_SCHEMA_H_
#define RASTERPROOF_TESTS_REPORT_SCHEMA_H_

#include <string>
#include <vector>

#include "nlohmann/json.hpp"

namespace rasterproof::report {

/// Returns what is wrong with the value, a line each; a keyword that is not understood is wrong,
/// too.
std::vector<std::string> SchemaErrors(const nlohmann::json& schema, const nlohmann::json& value);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_TESTS_REPORT_SCHEMA_H_
