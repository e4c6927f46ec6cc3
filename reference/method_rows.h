// The rows of the table of methods, one function per kind of arithmetic. method.cc joins them.
#ifndef RASTERPROOF_REFERENCE_METHOD_ROWS_H_
#define RASTERPROOF_REFERENCE_METHOD_ROWS_H_

#include <string_view>
#include <vector>

#include "core/scene.h"
#include "core/snap.h"
#include "reference/method.h"

namespace rasterproof::reference {

/// A row for window space: name, summary, input format and its own profile (real geometry, or
/// snapped with the coordinates limited to what is proved). Vertices are placed as given; facing
/// and fill are the caller's to set.
Method WindowMethod(std::string_view name, std::string_view summary, Precision input,
                    Snap snap = {}, double coordinate_limit = 0);

std::vector<Method> Float32Methods();
/// The row f32-direct, which projected clip space is drawn by too.
Method DirectMethod();
std::vector<Method> Float64Methods();
std::vector<Method> IntegerMethods();
std::vector<Method> ExactMethods();

}  // namespace rasterproof::reference

#endif  // RASTERPROOF_REFERENCE_METHOD_ROWS_H_
