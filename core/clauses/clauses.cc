#include "core/clauses/clauses.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "core/profile.h"

namespace rasterproof {
namespace {

constexpr std::string_view kCanonical = "-canonical";

}  // namespace

std::span<const Specification> Specifications() {
  static const std::array<Specification, 9> kAll{{
      {"gl", "OpenGL", "OpenGL 4.6 core profile of 5 May 2022, and GL_NV_conservative_raster",
       OpenGlClauses()},
      {"vulkan", "Vulkan",
       "Vulkan 1.4.360 of 14 August 2026 with all extensions; sections by their titles",
       VulkanClauses()},
      {"d3d11", "Direct3D 11", "Direct3D 11.3 functional specification, text and figures",
       Direct3D11Clauses()},
      {"d3d12", "Direct3D 12",
       "DirectX specifications: Conservative Rasterization, version 3.2 of 30 June 2015, and "
       "Programmable Sample Positions. What they do not change is that of Direct3D 11.3",
       Direct3D12Clauses(), "d3d11"},
      {"webgpu", "WebGPU", "WebGPU, editor's draft of 19 August 2026", WebGpuClauses()},
      {"pdf", "PDF and PostScript",
       "PDF Reference, 6.5.3, as read in a hosted copy. The PostScript Language Reference, 7.5, "
       "which says the same by all accounts, was not read",
       PdfClauses()},
      {"gdal", "GDAL",
       "gdal_rasterize's manual, and the issues and pull requests of the project, as stored in "
       "2026",
       GdalClauses()},
      {"x11", "X11",
       "X Window System Protocol, version 11: CreateGC, as read in two copies that agree",
       X11Clauses()},
      {"java-awt", "java.awt",
       "Java SE: java.awt.Shape, java.awt.Graphics2D and java.awt.RenderingHints, the API's "
       "documentation",
       JavaClauses()},
  }};
  return kAll;
}

const Specification* FindSpecification(std::string_view api) {
  const auto all = Specifications();
  const auto found = std::ranges::find(all, api, &Specification::api);
  return found != all.end() ? &*found : nullptr;
}

const Specification* SpecificationOf(std::string_view profile_name) {
  if (const Specification* named = FindSpecification(profile_name)) return named;
  const bool is_model = profile_name.ends_with(kCanonical);
  if (is_model || !PresetProfile(profile_name)) return nullptr;
  const Specification* longest = nullptr;
  for (const Specification& one : Specifications()) {
    if (!profile_name.starts_with(one.api)) continue;
    if (profile_name[one.api.size()] != '-') continue;
    if (longest == nullptr || one.api.size() > longest->api.size()) longest = &one;
  }
  return longest;
}

const Specification* SpecificationOf(const Profile& profile) {
  const std::string& set = profile.specification;
  return SpecificationOf(std::string_view(set.empty() ? profile.name : set));
}

std::string_view ApiOf(const Clause& clause) { return clause.id.substr(0, clause.id.find('.')); }

const Clause* FindClause(std::string_view id) {
  const Specification* specification = FindSpecification(id.substr(0, id.find('.')));
  if (specification == nullptr) return nullptr;
  const auto found = std::ranges::find(specification->clauses, id, &Clause::id);
  return found != specification->clauses.end() ? &*found : nullptr;
}

std::string_view ForceName(Force force) {
  if (force == Force::kRequired) return "required";
  return force == Force::kAllowed ? "allowed" : "silent";
}

std::vector<ClauseKey> KeysOf(const Clause& clause) {
  constexpr std::string_view kBetween = "; ";
  std::vector<ClauseKey> keys;
  std::string_view rest = clause.keys;
  while (!rest.empty()) {
    const std::string_view one = rest.substr(0, rest.find(kBetween));
    rest.remove_prefix(one.size());
    if (!rest.empty()) rest.remove_prefix(kBetween.size());
    const std::size_t equals = one.find('=');
    const bool is_any = equals == std::string_view::npos;
    keys.push_back({one.substr(0, equals), is_any ? std::string_view() : one.substr(equals + 1)});
  }
  return keys;
}

std::vector<const Clause*> AssumptionsOf(std::string_view api) {
  const Specification* specification = FindSpecification(api);
  if (specification == nullptr) return {};
  std::vector<const Clause*> assumptions = AssumptionsOf(specification->base);
  for (const Clause& clause : specification->clauses) {
    if (clause.is_assumed) assumptions.push_back(&clause);
  }
  return assumptions;
}

}  // namespace rasterproof
