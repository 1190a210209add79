// JSON as it was typed: the texts of numbers are kept, every value knows its line, duplicate keys are refused.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hottel {

// Lists and objects may be nested this deep. Reading and walking a document never recurses.
inline constexpr int kMaxJsonDepth = 64;

// What a value is. kKey is the key of a member; no item of a list, and not the root, is one.
enum class JsonKind : std::uint8_t { kNull, kBoolean, kNumber, kString, kArray, kObject, kKey };

class JsonDocument;
class JsonItems;
class JsonMembers;

// A value of a document, or the absence of one (default constructed). A view: valid while its document lives.
//
//   (1) 16 bytes, to be passed by value; nothing is copied or converted when it is looked at
// All but the conversion to bool REQUIRE a value.
class JsonValue {
 public:
  JsonValue() = default;

  // Whether there is a value.
  explicit operator bool() const { return document_ != nullptr; }
  JsonKind kind() const;
  int line() const;                 // of its first character, 1-based
  const std::string& file() const;  // the document's name for messages

  // A number as it was typed, the contents of a string, "true" or "false"; otherwise empty.
  std::string_view text() const;

  // The number of items of a list or of members of an object; otherwise 0. COST: none, it is stored.
  std::size_t size() const;

  // For loops in the order of the text; COST: the n-th item is reached by passing those before it.
  JsonItems items() const;      // REQUIRES: kind() is kArray
  JsonMembers members() const;  // REQUIRES: kind() is kObject

 private:
  friend class JsonBuilder;
  friend class JsonDocument;
  friend class JsonItems;
  friend class JsonMembers;
  JsonValue(const JsonDocument* document, std::uint32_t index) : document_(document), index_(index) {}
  std::uint32_t next() const;  // the index after this value and all that is in it

  const JsonDocument* document_ = nullptr;
  std::uint32_t index_ = 0;
};

// A member of an object: `"key": value`.
struct JsonMember {
  JsonValue key;  // its text is the key
  JsonValue value;
};

// A JSON text, parsed. Flat: 16 bytes a value and the texts.
//
//   (1) a number's text denotes exactly the number typed ("0.1", "1e400"), also beyond the range of double
//   (2) no object has a key twice
//   (3) every string is well-formed UTF-8
// Not copied or moved, so that values may point to it. Read only: many threads may look at it at once.
class JsonDocument {
 public:
  // Throws InputError{name, line} when the text is not JSON (a byte order mark, comments, NaN and NUL bytes are not),
  // is empty, has a duplicate key, or is nested deeper than kMaxJsonDepth.     COST: linear.
  JsonDocument(std::string_view text, std::string name);
  JsonDocument(const JsonDocument&) = delete;
  JsonDocument& operator=(const JsonDocument&) = delete;

  JsonValue root() const { return {this, 0}; }
  const std::string& name() const { return name_; }

 private:
  friend class JsonValue;
  friend class JsonBuilder;
  struct Node {
    std::uint32_t line;
    std::uint32_t size;  // characters of the text, items, or members
    std::uint32_t at;    // where the text begins in texts_, or the index after a list or object
    JsonKind kind;
  };

  std::string name_;
  std::vector<Node> nodes_;
  std::string texts_;
};

inline JsonKind JsonValue::kind() const { return document_->nodes_[index_].kind; }
inline int JsonValue::line() const { return static_cast<int>(document_->nodes_[index_].line); }
inline const std::string& JsonValue::file() const { return document_->name_; }
inline std::uint32_t JsonValue::next() const {
  const bool has_parts = kind() == JsonKind::kArray || kind() == JsonKind::kObject;
  return has_parts ? document_->nodes_[index_].at : index_ + 1;
}
inline std::size_t JsonValue::size() const {
  const bool has_parts = kind() == JsonKind::kArray || kind() == JsonKind::kObject;
  return has_parts ? document_->nodes_[index_].size : 0;
}
inline std::string_view JsonValue::text() const {
  const auto& node = document_->nodes_[index_];
  if (kind() == JsonKind::kArray || kind() == JsonKind::kObject) return {};
  return std::string_view(document_->texts_).substr(node.at, node.size);
}

// The items of a list, in order.
class JsonItems {
 public:
  class Iterator {
   public:
    explicit Iterator(JsonValue at) : at_(at) {}
    JsonValue operator*() const { return at_; }
    Iterator& operator++() { return at_.index_ = at_.next(), *this; }
    bool operator==(const Iterator& other) const { return at_.index_ == other.at_.index_; }

   private:
    JsonValue at_;
  };
  explicit JsonItems(JsonValue list) : list_(list) {}
  Iterator begin() const { return Iterator({list_.document_, list_.index_ + 1}); }
  Iterator end() const { return Iterator({list_.document_, list_.next()}); }

 private:
  JsonValue list_;
};

// The members of an object, in the order in which they were typed.
class JsonMembers {
 public:
  class Iterator {
   public:
    explicit Iterator(JsonValue key) : key_(key) {}
    JsonMember operator*() const { return {key_, {key_.document_, key_.index_ + 1}}; }
    Iterator& operator++() { return key_.index_ = JsonValue(key_.document_, key_.index_ + 1).next(), *this; }
    bool operator==(const Iterator& other) const { return key_.index_ == other.key_.index_; }

   private:
    JsonValue key_;
  };
  explicit JsonMembers(JsonValue object) : object_(object) {}
  Iterator begin() const { return Iterator({object_.document_, object_.index_ + 1}); }
  Iterator end() const { return Iterator({object_.document_, object_.next()}); }

 private:
  JsonValue object_;
};

inline JsonItems JsonValue::items() const { return JsonItems(*this); }
inline JsonMembers JsonValue::members() const { return JsonMembers(*this); }

}  // namespace hottel
