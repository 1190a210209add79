#include "io/scene/ply_header.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "geometry/name.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

using enum PlyType;

constexpr std::array<std::pair<const char*, PlyType>, 16> kTypes{{{"char", kInt8},
                                                                  {"uchar", kUint8},
                                                                  {"short", kInt16},
                                                                  {"ushort", kUint16},
                                                                  {"int", kInt32},
                                                                  {"uint", kUint32},
                                                                  {"float", kFloat32},
                                                                  {"double", kFloat64},
                                                                  {"int8", kInt8},
                                                                  {"uint8", kUint8},
                                                                  {"int16", kInt16},
                                                                  {"uint16", kUint16},
                                                                  {"int32", kInt32},
                                                                  {"uint32", kUint32},
                                                                  {"float32", kFloat32},
                                                                  {"float64", kFloat64}}};

constexpr std::array<std::pair<const char*, PlyFormat>, 3> kFormats{{{"ascii", PlyFormat::kText},
                                                                     {"binary_little_endian", PlyFormat::kLittleEndian},
                                                                     {"binary_big_endian", PlyFormat::kBigEndian}}};

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  constexpr std::string_view kBetweenWords = " \t\v\f\r";
  for (std::size_t k = line.find_first_not_of(kBetweenWords); k < line.size();
       k = line.find_first_not_of(kBetweenWords, k)) {
    const std::size_t end = std::min(line.find_first_of(kBetweenWords, k), line.size());
    words.push_back(line.substr(k, end - k));
    k = end;
  }
  return words;
}

class HeaderReader {
 public:
  HeaderReader(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file) {}

  PlyHeader read() {
    const std::size_t end = bytes_.find_first_of("\r\n");
    line_ = 1;
    if (bytes_.substr(0, end) != "ply") refuse("the file does not begin with the line 'ply': it is no PLY file");
    if (end == std::string_view::npos) refuse("the file ends within its header");
    line_end_ = bytes_.substr(end).starts_with("\r\n") ? "\r\n" : bytes_.substr(end, 1);
    at_ = end + line_end_.size();
    while (read_line()) {
    }
    line_ = 2;
    if (!format_) refuse("the header does not say the format: ascii, binary_little_endian or binary_big_endian");
    header_.format = *format_;
    return std::move(header_);
  }

 private:
  // False for the last line.
  bool read_line() {
    ++line_;
    const std::size_t end = bytes_.find(line_end_, at_);
    if (end == std::string_view::npos) refuse("the file ends within its header: there is no end_header");
    const std::vector<std::string_view> words = words_of(bytes_.substr(at_, end - at_));
    at_ = end + line_end_.size();
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info") return true;
    if (words[0] == "end_header") {
      header_.body = at_;
      header_.body_line = line_ + 1;
      return false;
    }
    if (words[0] == "format")
      read_format(words);
    else if (words[0] == "element")
      read_element(words);
    else if (words[0] == "property")
      read_property(words);
    else
      refuse("the keyword " + quoted_name(words[0]) + " of the header is not known");
    return true;
  }

  void read_format(const std::vector<std::string_view>& words) {
    if (format_) refuse("the header says the format twice");
    if (words.size() != 3) refuse("a format is written like 'format ascii 1.0'");
    if (words[2] != "1.0") refuse("the version is " + quoted_name(words[2]) + "; version 1.0 is read");
    for (const auto& [name, format] : kFormats)
      if (words[1] == name) format_ = format;
    if (!format_)
      refuse("the format " + quoted_name(words[1]) +
             " is not known: it is ascii, binary_little_endian or binary_big_endian");
  }

  void read_element(const std::vector<std::string_view>& words) {
    if (words.size() != 3) refuse("an element is written like 'element vertex 8'");
    PlyElement element;
    element.name = words[1];
    element.line = line_;
    const auto [end, error] = std::from_chars(words[2].data(), words[2].data() + words[2].size(), element.count);
    if (error != std::errc() || end != words[2].data() + words[2].size())
      refuse("the number of element " + quoted_name(words[1]) + " is no integer from 0 on: " + quoted_name(words[2]));
    for (const PlyElement& other : header_.elements)
      if (other.name == element.name) refuse("the element " + quoted_name(element.name) + " is there twice");
    header_.elements.push_back(std::move(element));
  }

  void read_property(const std::vector<std::string_view>& words) {
    if (header_.elements.empty()) refuse("a property stands before any element");
    const bool is_list = words.size() > 1 && words[1] == "list";
    if (words.size() != (is_list ? 5 : 3))
      refuse("a property is written like 'property float x' or 'property list uchar int vertex_indices'");
    PlyProperty property;
    property.name = words.back();
    property.type = type_of(words[is_list ? 3 : 1]);
    if (is_list) {
      property.count = type_of(words[2]);
      if (!is_integer(*property.count))
        refuse("the length of the list " + quoted_name(property.name) + " is of type " + quoted_name(words[2]) +
               ", which is no integer");
    }
    PlyElement& element = header_.elements.back();
    if (element.find(property.name))
      refuse("the property " + quoted_name(property.name) + " of element " + quoted_name(element.name) +
             " is there twice");
    element.properties.push_back(std::move(property));
  }

  PlyType type_of(std::string_view word) const {
    for (const auto& [name, type] : kTypes)
      if (word == name) return type;
    refuse("the type " + quoted_name(word) + " is not known");
  }

  [[noreturn]] void refuse(const std::string& text) const { throw InputError({file_, line_}, text); }

  std::string_view bytes_;
  const std::string& file_;
  std::string_view line_end_;
  std::size_t at_ = 0;
  int line_ = 0;
  std::optional<PlyFormat> format_;
  PlyHeader header_;
};

}  // namespace

std::size_t ply_size(PlyType type) {
  constexpr std::array<std::size_t, 8> kSizes{1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

bool is_integer(PlyType type) { return type != kFloat32 && type != kFloat64; }

std::optional<std::size_t> PlyElement::find(std::string_view property) const {
  for (std::size_t k = 0; k < properties.size(); ++k)
    if (properties[k].name == property) return k;
  return std::nullopt;
}

PlyHeader parse_ply_header(std::string_view bytes, const std::string& file) { return HeaderReader(bytes, file).read(); }

}  // namespace hottel
