// Drawings of other programs, made safe to stand in the page.
#include <algorithm>
#include <array>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "pugixml.hpp"
#include "report/page_parts.h"

namespace rasterproof::report {
namespace {

// What draws and nothing else. `use` and `image` could load files, `style` too, `a` leads out.
constexpr std::array<std::string_view, 19> kDrawing{
    "svg",      "g",    "path",  "rect", "circle",   "ellipse",        "line",           "polygon",
    "polyline", "text", "tspan", "defs", "clipPath", "linearGradient", "radialGradient", "stop",
    "title",    "desc", "marker"};

bool IsPlain(const pugi::xml_attribute& attribute) {
  const std::string_view name = attribute.name();
  const std::string_view value = attribute.value();
  if (name.starts_with("on") || name.ends_with("href")) return false;
  // The name of a namespace is no reference, and nobody fetches it.
  if (name == "xmlns" || name.starts_with("xmlns:")) return true;
  // url(#name) points into the drawing; any other url, or an escape that could hide one, does not.
  for (std::size_t at = value.find("url("); at != std::string_view::npos;
       at = value.find("url(", at + 1)) {
    if (!value.substr(at + 4).starts_with('#')) return false;
  }
  return value.find('\\') == std::string_view::npos &&
         value.find("@import") == std::string_view::npos &&
         value.find("javascript:") == std::string_view::npos;
}

void Purge(pugi::xml_node node) {
  std::vector<pugi::xml_attribute> attributes;
  for (const pugi::xml_attribute& attribute : node.attributes()) {
    if (!IsPlain(attribute)) attributes.push_back(attribute);
  }
  for (const pugi::xml_attribute& attribute : attributes) node.remove_attribute(attribute);
  std::vector<pugi::xml_node> strangers;
  for (const pugi::xml_node& child : node.children()) {
    const bool is_text = child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata;
    const bool draws =
        child.type() == pugi::node_element &&
        std::ranges::find(kDrawing, std::string_view(child.name())) != kDrawing.end();
    if (draws) {
      Purge(child);
    } else if (!is_text) {
      strangers.push_back(child);
    }
  }
  for (const pugi::xml_node& stranger : strangers) node.remove_child(stranger);
}

}  // namespace

std::string PlainSvg(std::string_view svg) {
  pugi::xml_document document;
  const unsigned options = pugi::parse_default | pugi::parse_ws_pcdata_single;
  if (!document.load_buffer(svg.data(), svg.size(), options)) return {};
  pugi::xml_node root = document.document_element();
  if (std::string_view(root.name()) != "svg") return {};
  Purge(root);
  std::ostringstream plain;
  root.print(plain, "", pugi::format_raw);
  return plain.str();
}

}  // namespace rasterproof::report
