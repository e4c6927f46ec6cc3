#include "core/transform.h"

#include <algorithm>
#include <array>
#include <utility>

namespace rasterproof {
namespace {

constexpr std::array<std::pair<Division, std::string_view>, 2> kDivisions{
    {{Division::kQuotient, "quotient"}, {Division::kReciprocal, "reciprocal"}}};
constexpr std::array<std::pair<ViewportForm, std::string_view>, 4> kViewportForms{
    {{ViewportForm::kNone, "none"},
     {ViewportForm::kMultiplyAdd, "multiply-add"},
     {ViewportForm::kFused, "fused"},
     {ViewportForm::kAddMultiply, "add-multiply"}}};

}  // namespace

std::string_view DivisionName(Division division) {
  return std::ranges::find(kDivisions, division, &decltype(kDivisions)::value_type::first)->second;
}

std::optional<Division> DivisionFromName(std::string_view name) {
  for (const auto& [division, known] : kDivisions) {
    if (known == name) return division;
  }
  return std::nullopt;
}

std::string_view ViewportFormName(ViewportForm form) {
  return std::ranges::find(kViewportForms, form, &decltype(kViewportForms)::value_type::first)
      ->second;
}

std::optional<ViewportForm> ViewportFormFromName(std::string_view name) {
  for (const auto& [form, known] : kViewportForms) {
    if (known == name) return form;
  }
  return std::nullopt;
}

}  // namespace rasterproof
