#include "io/scene/plane/svg_reader.h"

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>
#include <optional>
#include <pugixml.hpp>
#include <unordered_map>
#include <unordered_set>

#include "geometry/name.h"
#include "geometry/patch_bases.h"
#include "geometry/planarity.h"
#include "geometry/plane/scene/patch_seats.h"
#include "io/files/text_file.h"
#include "io/scene/exact_decimal.h"
#include "io/scene/plane/svg_geometry.h"
#include "io/scene/svg_style.h"
#include "io/scene/xml_references.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

constexpr std::string_view kSvgNamespace = "http://www.w3.org/2000/svg";
constexpr std::string_view kHtmlNamespace = "http://www.w3.org/1999/xhtml";
constexpr int kMaxSvgDepth = 256;

template <std::size_t N>
bool is_one_of(std::string_view word, const std::array<std::string_view, N>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

// Elements that SVG never draws by themselves.
constexpr std::array<std::string_view, 13> kUndrawn{"title",          "desc",           "metadata", "defs",   "symbol",
                                                    "clipPath",       "mask",           "marker",   "filter", "pattern",
                                                    "linearGradient", "radialGradient", "view"};
// The attributes data-... that mean something here.
constexpr std::array<std::string_view, 4> kDataKeys{"data-material", "data-back", "data-front", "data-on"};

std::string_view local_name(std::string_view name) {
  const auto colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

// What a group hands down.
struct Inherited {
  SvgTransform2 transform;
  std::string material = kSvgMaterial;
  std::string back, on;
  bool is_reversed = false;
};

class SvgReader {
 public:
  SvgReader(std::string_view text, const std::string& file, PassedOver& passed_over)
      : text_(text), passed_over_(passed_over) {
    scene_.file = file;
  }

  ValidScene2 read() {
    if (const auto nul = text_.find('\0'); nul != std::string_view::npos) refuse(line_at(nul), "has a NUL byte");
    const auto result =
        document_.load_buffer(text_.data(), text_.size(), pugi::parse_default | pugi::parse_pi, pugi::encoding_utf8);
    if (!result) {
      const auto at = static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0));
      refuse(line_at(at), std::string("is not well-formed XML: ") + result.description());
    }
    if (const auto problem = unresolved_reference(text_)) refuse(line_at(problem->offset), problem->text);
    const pugi::xml_node root = document_.document_element();
    if (!is_svg(root) || local_name(root.name()) != "svg") refuse(line_of(root), "the outermost element is not <svg>");
    for (pugi::xml_node other = root.next_sibling(); other; other = other.next_sibling())
      if (other.type() == pugi::node_element) refuse(line_of(other), "there is a second outermost element");
    check_style_sheets();
    walk(root, group(root, {}), 0);
    if (scene_.surfaces.empty() && no_length_) throw InputError(*no_length_);
    if (scene_.surfaces.empty()) refuse(0, "has no lines");
    // Edges stand before polylines, as in a scene file.
    std::vector<std::uint32_t> order(scene_.surfaces.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_partition(order.begin(), order.end(), [&](std::uint32_t s) {
      return scene_.surfaces[s].name == scene_.groups[scene_.surfaces[s].group].name;
    });
    scene_.keep(order);
    if (!scene_.bases.empty()) seat_patches(scene_, finest_unit());
    return std::move(scene_);
  }

 private:
  [[noreturn]] void refuse(int line, const std::string& text, std::vector<std::string> hints = {}) const {
    throw InputError({scene_.file, line}, text, std::move(hints));
  }
  [[noreturn]] void refuse(pugi::xml_node node, const std::string& text) const {
    refuse(line_of(node), subject(node) + " " + text);
  }

  int line_at(std::size_t offset) const {
    if (line_starts_.empty()) {
      line_starts_.push_back(0);
      for (std::size_t i = 0; i < text_.size(); ++i)
        if (text_[i] == '\n') line_starts_.push_back(i + 1);
    }
    return static_cast<int>(std::upper_bound(line_starts_.begin(), line_starts_.end(), offset) - line_starts_.begin());
  }
  int line_of(pugi::xml_node node) const {
    const std::ptrdiff_t offset = node.offset_debug();
    return offset < 0 ? 0 : line_at(static_cast<std::size_t>(offset));
  }

  // "<line id='a'>"
  static std::string tag(pugi::xml_node node) {
    const std::string_view id = node.attribute("id").value();
    return "<" + std::string(node.name()) + (id.empty() ? "" : " id=" + quoted_name(id)) + ">";
  }

  // "<text> in <g id='labels'>": the element, and the nearest element around it that has an id, or else its parent,
  // unless that is the whole drawing.
  static std::string subject(pugi::xml_node node) {
    const auto is_inside = [](pugi::xml_node outer) { return outer.parent().type() == pugi::node_element; };
    pugi::xml_node container = node.parent();
    while (is_inside(container) && !container.attribute("id")) container = container.parent();
    if (!is_inside(container)) container = node.parent();
    return tag(node) + (is_inside(container) ? " in " + tag(container) : "");
  }

  std::string_view namespace_of(pugi::xml_node node) const {
    const std::string_view name = node.name();
    const auto colon = name.find(':');
    const std::string key = colon == std::string_view::npos ? "xmlns" : "xmlns:" + std::string(name.substr(0, colon));
    for (pugi::xml_node at = node; at; at = at.parent())
      if (const auto declared = at.attribute(key.c_str())) return declared.value();
    if (colon != std::string_view::npos) refuse(node, "has a prefix that is not declared");
    return kSvgNamespace;
  }
  bool is_svg(pugi::xml_node node) const { return namespace_of(node) == kSvgNamespace; }

  // Calls parse(text) for an attribute, and puts its errors in place.
  template <class Parse>
  auto attribute(pugi::xml_node node, const char* name, Parse parse) const {
    try {
      return parse(std::string_view(node.attribute(name).value()));
    } catch (const SvgAttributeError& error) {
      refuse(node, std::string(name) + " " + error.what());
    }
  }
  Rational length(pugi::xml_node node, const char* name) const {
    if (!node.attribute(name)) return 0;
    return attribute(node, name, parse_svg_length_2);
  }

  void check_attributes(pugi::xml_node node) const {
    std::unordered_set<std::string_view> seen;
    for (const pugi::xml_attribute a : node.attributes()) {
      const std::string_view name = a.name();
      if (!seen.insert(name).second) refuse(node, "has the attribute '" + std::string(name) + "' twice");
      if (const auto problem = property_problem(name, trimmed(a.value()), StylePlace::kAttribute))
        refuse(node, *problem);
      if (name.starts_with("data-") && !is_one_of(name, kDataKeys))
        refuse(node, "has " + quoted_name(name) +
                         ": of such keys only data-material, data-back, data-front and data-on are known");
    }
    const bool is_outermost = node == document_.document_element();
    if (const auto problem =
            style_problem(node.attribute("style").value(), is_outermost ? StylePlace::kViewport : StylePlace::kStyle))
      refuse(node, problem->text);
  }

  // A style sheet holds for the whole drawing wherever it stands, and is passed over when it only paints.
  void check_style_sheet(pugi::xml_node node) const {
    std::string sheet;
    std::vector<std::pair<std::size_t, pugi::xml_node>> parts;  // where each begins in the sheet
    for (const pugi::xml_node part : node.children()) {
      if (part.type() != pugi::node_pcdata && part.type() != pugi::node_cdata) continue;
      parts.emplace_back(sheet.size(), part);
      sheet += part.value();
    }
    const auto problem = style_sheet_problem(sheet);
    if (!problem) return;
    auto part = parts.end() - 1;
    while (part->first > problem->offset) --part;
    const auto begin = sheet.begin() + static_cast<std::ptrdiff_t>(part->first);
    const auto lines = std::count(begin, sheet.begin() + static_cast<std::ptrdiff_t>(problem->offset), '\n');
    refuse(line_of(part->second) + static_cast<int>(lines), subject(node) + " " + problem->text);
  }

  // Refuses what changes the drawing from outside of its elements.
  void check_style_sheets() const {
    for (const pugi::xml_node node : document_.children())
      if (node.type() == pugi::node_pi && std::string_view(node.name()) == "xml-stylesheet")
        refuse(line_of(node), "refers to another style sheet (<?xml-stylesheet?>)");
    document_.find_node([&](pugi::xml_node node) {
      const std::string_view kind = local_name(node.name());
      if (node.type() != pugi::node_element || (kind != "style" && kind != "script" && kind != "link")) return false;
      const std::string_view space = namespace_of(node);
      if (space != kSvgNamespace && space != kHtmlNamespace) return false;
      if (kind != "style") refuse(node, "may change the drawing in ways that are not read");
      check_style_sheet(node);
      return false;
    });
  }

  Inherited group(pugi::xml_node node, const Inherited& outer) const {
    check_attributes(node);
    Inherited inner = outer;
    inner.transform = outer.transform.after(attribute(node, "transform", parse_svg_transform_2));
    if (const auto a = node.attribute("data-material"))
      inner.material = a.value();
    else if (const std::string_view classes = trimmed(node.attribute("class").value()); !classes.empty())
      inner.material = classes;
    if (const auto a = node.attribute("data-back")) inner.back = a.value();
    if (const auto a = node.attribute("data-on")) inner.on = a.value();
    if (const auto a = node.attribute("data-front")) {
      const std::string_view side = a.value();
      if (side != "left" && side != "right") refuse(node, "data-front is neither 'left' nor 'right'");
      inner.is_reversed = side == "left";
    }
    return inner;
  }

  void walk(pugi::xml_node parent, const Inherited& outer, int depth) {
    if (depth > kMaxSvgDepth) refuse(parent, "is nested too deeply");
    for (const pugi::xml_node node : parent.children()) {
      if (node.type() != pugi::node_element || !is_svg(node)) continue;
      const std::string_view kind = local_name(node.name());
      if (is_one_of(kind, kUndrawn)) continue;
      if (kind == "style") continue;  // see check_style_sheets
      if (kind == "g") {
        walk(node, group(node, outer), depth + 1);
      } else {
        add_shape(node, kind, group(node, outer));
      }
    }
  }

  void add_shape(pugi::xml_node node, std::string_view kind, const Inherited& style) {
    for (const pugi::xml_node child : node.children())
      if (child.type() == pugi::node_element && is_svg(child) && !is_one_of(local_name(child.name()), kUndrawn))
        refuse(child, "cannot be read here");
    if (kind == "line") {
      add_run(node, true, id_or_number(node, "edge", edges_), line(node), style);
      ++edges_;
      return;
    }
    std::vector<SvgRun> runs;
    if (kind == "polyline" || kind == "polygon")
      runs = {points(node, kind == "polygon")};
    else if (kind == "rect")
      runs = {rectangle(node, style.transform)};
    else if (kind == "path")
      runs = attribute(node, "d", parse_svg_path_2);
    else
      refuse(line_of(node), subject(node) + " is not made of straight lines that can be read exactly",
             {"lines, polylines, polygons, rects, and paths of M L H V Z are read; groups may hold them"});
    if (runs.empty()) refuse(node, "has no lines");
    const std::string name = id_or_number(node, "polyline", polylines_);
    ++polylines_;
    for (std::size_t k = 0; k < runs.size(); ++k)
      add_run(node, false, runs.size() == 1 ? name : name + "." + std::to_string(k + 1), runs[k], style);
  }

  SvgRun line(pugi::xml_node node) const {
    return {{{length(node, "x1"), length(node, "y1")}, {length(node, "x2"), length(node, "y2")}}, false};
  }

  SvgRun points(pugi::xml_node node, bool closed) const {
    SvgRun run{attribute(node, "points", parse_svg_points_2), closed};
    if (closed && run.points.size() > 1 && run.points.front() == run.points.back()) run.points.pop_back();
    return run;
  }

  // As a room seen from inside, also where the drawing is mirrored.
  SvgRun rectangle(pugi::xml_node node, const SvgTransform2& transform) const {
    for (const char* radius : {"rx", "ry"})
      if (std::string_view(node.attribute(radius).value()) != "auto" && length(node, radius) != 0)
        refuse(node, "has rounded corners");
    const Rational x = length(node, "x"), y = length(node, "y");
    const Rational right = x + length(node, "width"), bottom = y + length(node, "height");
    if (right <= x || bottom <= y) refuse(node, "has no positive width and height");
    SvgRun run{{{x, y}, {right, y}, {right, bottom}, {x, bottom}}, true};
    if (transform.is_mirrored()) std::reverse(run.points.begin() + 1, run.points.end());
    return run;
  }

  // What the last digit of the points stands for, once they are in place.
  Rational finest_unit() const {
    FinestDigit finest;
    for (const auto& [from, to] : scene_.edges)
      for (const Rational* coordinate : {&from.x, &from.y, &to.x, &to.y})
        if (const auto text = exact_decimal_text(*coordinate)) finest.take(*text);
    return finest.unit();
  }

  static std::string id_or_number(pugi::xml_node node, const char* kind, std::size_t number) {
    const std::string id = node.attribute("id").value();
    return id.empty() ? std::string(kind) + "[" + std::to_string(number) + "]" : id;
  }

  void add_run(pugi::xml_node node, bool is_edge, const std::string& name, SvgRun run, const Inherited& style) {
    if (const auto problem = name_problem(name); !problem.empty())
      refuse(line_of(node), subject(node) + ": the id " + std::string(problem));
    std::vector<Point2>& p = run.points;
    if (p.size() < 2) refuse(node, "has fewer than two points");
    const std::size_t repeated = drop_repeated(p, run.closed, std::equal_to<>());
    if (p.size() < 2) return pass_over_point(node);
    passed_over_.add(PassedKind::kRepeatedPoint, {scene_.file, line_of(node)}, "of " + tag(node), repeated);
    for (Point2& point : p) {
      point = style.transform.apply(point);
      point.y = -point.y;
    }
    if (run.closed) p.push_back(p.front());
    if (style.is_reversed) std::reverse(p.begin(), p.end());

    Surface surface;
    surface.material = material(node, style.material);
    if (!style.back.empty()) surface.back = material(node, style.back);
    if (!style.on.empty()) surface.on = base(style.on);
    surface.group = static_cast<std::uint32_t>(scene_.groups.size());
    surface.line = line_of(node);
    scene_.groups.push_back(name);
    for (std::size_t i = 0; i + 1 < p.size(); ++i) {
      surface.name = is_edge ? name : piece_name(name, i);
      scene_.add(surface, {p[i], p[i + 1]});
    }
  }

  void pass_over_point(pugi::xml_node node) {
    const FileLine where{scene_.file, line_of(node)};
    passed_over_.add(PassedKind::kLineWithoutLength, where, tag(node));
    if (!no_length_) no_length_ = InputError(where, subject(node) + " has no length: all its points are the same");
  }

  std::uint32_t material(pugi::xml_node node, const std::string& name) {
    if (name.empty() || has_control_character(name)) refuse(node, "has a material without a proper name");
    const auto [entry, is_new] = materials_.emplace(name, static_cast<std::uint32_t>(scene_.materials.size()));
    if (is_new) scene_.materials.push_back({name, Spectrum::scalar(kSvgReflectivity), {}});
    return entry->second;
  }

  std::uint32_t base(const std::string& name) {
    const PatchBase wanted = side_named(name);
    const auto found = std::ranges::find(scene_.bases, wanted);
    const auto index = static_cast<std::uint32_t>(found - scene_.bases.begin());
    if (found == scene_.bases.end()) scene_.bases.push_back(wanted);
    return index;
  }

  std::string_view text_;
  PassedOver& passed_over_;
  std::optional<InputError> no_length_;  // of the first that has none
  pugi::xml_document document_;
  Scene2 scene_;
  std::unordered_map<std::string, std::uint32_t> materials_;
  std::size_t edges_ = 0, polylines_ = 0;
  mutable std::vector<std::size_t> line_starts_;
};

}  // namespace

bool is_svg_2(const std::filesystem::path& file) { return file.extension() == ".svg"; }

ValidScene2 parse_svg_2(std::string_view text, const std::string& name_for_messages, PassedOver* passed_over) {
  PassedOver untold;
  return SvgReader(text, name_for_messages, passed_over != nullptr ? *passed_over : untold).read();
}

ValidScene2 read_svg_2(const std::filesystem::path& file, PassedOver* passed_over) {
  return parse_svg_2(read_text_file(file), file.string(), passed_over);
}

}  // namespace hottel
