// A scene as a part of a JSON document, shared by scene files and case files.
#ifndef RASTERPROOF_IO_SCENE_JSON_H_
#define RASTERPROOF_IO_SCENE_JSON_H_

#include <string>
#include <string_view>

#include "core/scene.h"
#include "io/json_document.h"

namespace rasterproof::io {

/// The scene of an object with the keys of a scene file; InputError names the value at fault.
Scene SceneFromJson(const JsonValue& object);

/// Appends the scene as an object whose lines after the first begin with `indent`.
void AppendSceneJson(const Scene& scene, std::string_view indent, std::string& json);

/// A coordinate: a JSON number, rounded once, or a string that is exact.
double CoordinateFromJson(const JsonValue& value, Precision precision);

/// The text as a JSON string, quotes included. Bytes that are not UTF-8 are replaced, and no
/// control character remains.
std::string JsonString(std::string_view text);

}  // namespace rasterproof::io

#endif  // RASTERPROOF_IO_SCENE_JSON_H_
