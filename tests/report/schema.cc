#include "tests/report/schema.h"

#include <regex.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace rasterproof::report {
namespace {

using nlohmann::json;

bool HasType(const json& value, const std::string& type) {
  if (type == "object") return value.is_object();
  if (type == "array") return value.is_array();
  if (type == "string") return value.is_string();
  if (type == "integer") return value.is_number_integer();
  if (type == "number") return value.is_number();
  return type == "boolean" && value.is_boolean();
}

// POSIX's expressions: std::regex takes ten seconds to compile.
bool Matches(const std::string& text, const std::string& pattern) {
  regex_t compiled;
  if (regcomp(&compiled, pattern.c_str(), REG_EXTENDED | REG_NOSUB) != 0) return false;
  const bool matches = regexec(&compiled, text.c_str(), 0, nullptr, 0) == 0;
  regfree(&compiled);
  return matches;
}

class Checker {
 public:
  explicit Checker(const json& root) : root_(root) {}

  void Check(const json& schema, const json& value, const std::string& place) {
    static const std::set<std::string> known{"$schema",
                                             "$defs",
                                             "$ref",
                                             "title",
                                             "description",
                                             "type",
                                             "const",
                                             "enum",
                                             "pattern",
                                             "minimum",
                                             "required",
                                             "properties",
                                             "additionalProperties",
                                             "items"};
    for (const auto& [keyword, unused] : schema.items()) {
      if (!known.contains(keyword)) Complain(place, "unknown keyword " + keyword);
    }
    if (schema.contains("$ref")) {
      const auto target = json::json_pointer(schema["$ref"].get<std::string>().substr(1));
      Check(root_.at(target), value, place);
    }
    if (schema.contains("const") && value != schema["const"]) Complain(place, "not the constant");
    if (schema.contains("enum")) {
      const json& list = schema["enum"];
      if (std::ranges::find(list, value) == list.end()) Complain(place, "not in the list");
    }
    if (schema.contains("type")) CheckType(schema["type"], value, place);
    if (schema.contains("minimum") && value.is_number() && value < schema["minimum"]) {
      Complain(place, "too small");
    }
    if (schema.contains("pattern") && value.is_string() &&
        !Matches(value.get<std::string>(), schema["pattern"].get<std::string>())) {
      Complain(place, "does not match: " + value.get<std::string>());
    }
    if (value.is_object()) CheckObject(schema, value, place);
    if (value.is_array() && schema.contains("items")) {
      for (std::size_t k = 0; k < value.size(); ++k) {
        Check(schema["items"], value[k], place + "/" + std::to_string(k));
      }
    }
  }

  std::vector<std::string> errors;

 private:
  void Complain(const std::string& place, const std::string& what) {
    errors.push_back(place + ": " + what);
  }

  void CheckType(const json& types, const json& value, const std::string& place) {
    const json list = types.is_array() ? types : json::array({types});
    const bool fits =
        std::ranges::any_of(list, [&](const json& type) { return HasType(value, type); });
    if (!fits) Complain(place, "is not of type " + types.dump());
  }

  void CheckObject(const json& schema, const json& value, const std::string& place) {
    for (const json& key : schema.value("required", json::array())) {
      if (!value.contains(key)) Complain(place, "lacks " + key.get<std::string>());
    }
    const json properties = schema.value("properties", json::object());
    for (const auto& [key, member] : value.items()) {
      const std::string at = place + "/" + key;
      if (properties.contains(key)) {
        Check(properties[key], member, at);
      } else if (schema.contains("additionalProperties")) {
        const json& others = schema["additionalProperties"];
        if (others.is_object()) Check(others, member, at);
        if (others == false) Complain(at, "is not allowed");
      }
    }
  }

  const json& root_;
};

}  // namespace

std::vector<std::string> SchemaErrors(const json& schema, const json& value) {
  Checker checker(schema);
  checker.Check(schema, value, "");
  return checker.errors;
}

}  // namespace rasterproof::report
