#include "tests/report/json.h"

#include <ostream>

namespace rasterproof::report {

nlohmann::json ParseJson(const std::string& text) { return nlohmann::json::parse(text); }

}  // namespace rasterproof::report

namespace nlohmann {

void PrintTo(const json& value, std::ostream* stream) { *stream << value.dump(); }

}  // namespace nlohmann
