#include "reference/method.h"

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reference/box.h"
#include "reference/homogeneous.h"
#include "reference/method_rows.h"

namespace rasterproof::reference {
namespace {

std::vector<Method> AllMethods() {
  std::vector<Method> methods;
  for (const auto rows : {Float32Methods, IntegerMethods, Float64Methods, ExactMethods}) {
    for (Method& method : rows()) methods.push_back(std::move(method));
  }
  for (const Method& method : HomogeneousMethods()) methods.push_back(method);
  return methods;
}

}  // namespace

Method WindowMethod(std::string_view name, std::string_view summary, Precision input, Snap snap,
                    double coordinate_limit) {
  Method method;
  method.name = name;
  method.summary = summary;
  method.info.name = name;
  method.info.summary = summary;
  method.info.input = input;
  method.info.profile.snap = snap;
  method.stages.place = &PlaceAsGiven;
  method.stages.box = &BoxOfCorners;
  if (snap.IsNone()) {
    // Real geometry is stated for every finite coordinate of the input format.
    method.info.profile.coordinate_limit = input == Precision::kFloat32
                                               ? double{std::numeric_limits<float>::max()}
                                               : std::numeric_limits<double>::max();
  } else {
    method.info.profile.name = name;
    method.info.profile.coordinate_limit = coordinate_limit;
  }
  return method;
}

std::span<const Method> Methods() {
  static const std::vector<Method> methods = AllMethods();
  return methods;
}

const Method* FindMethod(std::string_view name) {
  for (const Method& method : Methods()) {
    if (method.name == name) return &method;
  }
  return nullptr;
}

}  // namespace rasterproof::reference
