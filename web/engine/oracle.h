// What a page asks about one scene: the exact oracle, and what a built-in method draws.
#ifndef RASTERPROOF_WEB_ENGINE_ORACLE_H_
#define RASTERPROOF_WEB_ENGINE_ORACLE_H_

#include <string>
#include <string_view>

namespace rasterproof::web {

/// Of {"triangle": [[x, y], [x, y], [x, y]], "pixel": [column, row], "sample": 0, "profile": ...,
/// "width": 64, "height": 64}: "covers" is "must", "may" where legal models differ, or "must not";
/// "facing" is 1 counter-clockwise on screen, -1 or 0; then of the triangle as the profile's
/// canonical model places it at the sample's place "at" the exact edge values, each opposite its
/// vertex, and the barycentrics, nearest numbers and fractions. Only triangle and pixel must be
/// there.
///
/// Error:      InputError with the place; or that the profile decides nothing of it, and why.
std::string Covers(std::string_view json);

/// Of {"method": "f32-direct", "scene": a scene file, "at": [x, y]}: the method's counts, and of
/// each triangle its values of the edge functions and the barycentrics at that point, null where it
/// has none.
///
/// Error:      InputError with the place.
std::string Draw(std::string_view json);

/// The names of the built-in methods.
std::string Methods();

}  // namespace rasterproof::web

#endif  // RASTERPROOF_WEB_ENGINE_ORACLE_H_
