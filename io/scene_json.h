// A scene as a part of a JSON document, shared by scene files and case files.
#ifndef RASTERPROOF_IO_SCENE_JSON_H_
#define RASTERPROOF_IO_SCENE_JSON_H_

#include "core/scene.h"
#include "io/json_document.h"
#include "io/json_writer.h"

namespace rasterproof::io {

/// The scene of an object with the keys of a scene file; InputError names the value at fault.
Scene SceneFromJson(const JsonValue& object);

void WriteScene(JsonWriter& json, const Scene& scene);

/// A coordinate: a JSON number, rounded once, or a string that is exact.
double CoordinateFromJson(const JsonValue& value, Precision precision);

}  // namespace rasterproof::io

#endif  // RASTERPROOF_IO_SCENE_JSON_H_
