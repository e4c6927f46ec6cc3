// A JSON text whose numbers keep their text, and whose values know their place.
#ifndef RASTERPROOF_IO_JSON_DOCUMENT_H_
#define RASTERPROOF_IO_JSON_DOCUMENT_H_

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace rasterproof::io {

enum class JsonKind : std::uint8_t { kObject, kArray, kKey, kString, kNumber, kBoolean, kNull };

class JsonValue;

/// A parsed text. A library's tree would hold numbers as doubles; this one keeps their text.
///
/// Error:      the constructor throws InputError for anything that is not one JSON value in UTF-8,
///             for an object that says a key twice, and for nesting deeper than kMaxDepth.
/// Cost:       16 bytes a value in addition to its text.
class JsonDocument {
 public:
  static constexpr std::size_t kMaxDepth = 16;
  /// Objects of the formats have a dozen keys at most.
  static constexpr std::size_t kMaxKeys = 64;

  JsonDocument(std::string_view text, std::string place);
  JsonDocument(const JsonDocument&) = delete;
  JsonDocument& operator=(const JsonDocument&) = delete;

  /// Values refer to the document: it must outlive them.
  JsonValue root() const;

 private:
  friend class JsonBuilder;
  friend class JsonValue;

  // Nodes lie in the order of the text: a container, then its contents. An object's members
  // are a key node and a value each.
  struct Node {
    std::uint32_t text_begin = 0;
    std::uint32_t text_size = 0;
    std::uint32_t next = 0;  // first node after this value and its contents; 0 while it is open
    JsonKind kind = JsonKind::kNull;
  };

  std::string_view Text(std::uint32_t node) const {
    return std::string_view(text_).substr(nodes_[node].text_begin, nodes_[node].text_size);
  }
  std::string Place(std::uint32_t node) const;

  std::string place_;
  std::string text_;
  std::vector<Node> nodes_;
};

/// A value in a document.
class JsonValue {
 public:
  JsonValue(const JsonDocument* document, std::uint32_t node) : document_(document), node_(node) {}

  JsonKind kind() const { return document_->nodes_[node_].kind; }
  /// A string's content or a number's text.
  std::string_view text() const { return document_->Text(node_); }
  /// Its place: "scene.json: vertices[3][1]".
  std::string Place() const { return document_->Place(node_); }
  InputError Error(const std::string& reason, const std::string& remedy) const {
    return InputError(Place(), reason, remedy);
  }

  /// Members of an object, if all its keys are among `allowed`; InputError otherwise.
  void RequireObject(std::span<const std::string_view> allowed) const;
  std::optional<JsonValue> Find(std::string_view key) const;
  /// The member; InputError if there is none.
  JsonValue Get(std::string_view key) const;

  /// Iterates over the items of an array.
  class Iterator {
   public:
    Iterator(const JsonDocument* document, std::uint32_t node) : document_(document), node_(node) {}
    JsonValue operator*() const { return {document_, node_}; }
    Iterator& operator++() {
      node_ = document_->nodes_[node_].next;
      return *this;
    }
    bool operator==(const Iterator&) const = default;

   private:
    const JsonDocument* document_;
    std::uint32_t node_;
  };
  struct Items {
    Iterator first;
    Iterator last;
    Iterator begin() const { return first; }
    Iterator end() const { return last; }
    std::size_t size() const;
  };
  /// The items of an array; InputError if it is not an array.
  Items RequireArray() const;

  /// Whether another document holds the same there: members in the same order, numbers with the
  /// same text.
  bool IsSameAs(const JsonValue& other) const;

  /// The content of a string; InputError if it is not a string.
  std::string_view RequireString() const;
  /// The same of a text that is shown: its ShownName().
  std::string RequireName() const;
  /// An integer written without fraction and exponent, within [least, greatest]; else InputError.
  std::int64_t RequireInteger(std::int64_t least, std::int64_t greatest) const;

 private:
  const JsonDocument* document_;
  std::uint32_t node_;
};

}  // namespace rasterproof::io

#endif  // RASTERPROOF_IO_JSON_DOCUMENT_H_
