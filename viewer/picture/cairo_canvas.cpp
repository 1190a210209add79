#include "viewer/picture/cairo_canvas.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <map>
#include <new>
#include <numbers>
#include <utility>
#include <vector>

#include "kernel/support/failure.h"
#include "viewer/picture/png_file.h"

namespace hottel {

// A text of an SVG. Cairo draws letters as shapes there; so a line is drawn in the place of each text, marked by a
// miter limit that nothing else has, and the text is put in its place when all is written.
struct SvgText {
  double x, y, width;  // of the left end of its base line
  std::string text;
  TextStyle style;
};

namespace {

constexpr const char* kTypeface = "DejaVu Sans Condensed";  // another sans serif stands in where it is missing
constexpr double kPointsAPixel = 0.75;
constexpr double kLeastImage = 1e-3;  // pixels; matrices of smaller ones may have no inverse

cairo_status_t append(void* target, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(target)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

void check(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS) throw RequestError(std::string("picture: ") + cairo_status_to_string(status));
}

// The number of bytes of the UTF-8 character at the front of text, 0 when there is none.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(0);
  if (first < 0x80) return first >= 0x20 && first != 0x7f ? 1 : 0;
  const std::size_t length = first >= 0xc2 && first < 0xe0   ? 2
                             : first >= 0xe0 && first < 0xf0 ? 3
                             : first >= 0xf0 && first < 0xf5 ? 4
                                                             : 0;
  if (length == 0 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xc0) != 0x80) return 0;
  const unsigned second = byte(1);
  const bool overlong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
  const bool beyond = (first == 0xed && second >= 0xa0) || (first == 0xf4 && second >= 0x90);
  return overlong || beyond ? 0 : length;
}

std::string printable(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    if (length == 0) {
      result += '?';
      text.remove_prefix(1);
    } else {
      result += text.substr(0, length);
      text.remove_prefix(length);
    }
  }
  return result;
}

// Cairo numbers the surfaces of a process; here those of a file, from 1 on.
std::string with_own_numbers(std::string_view svg, std::string_view word) {
  std::string result;
  std::map<std::string, std::size_t, std::less<>> known;
  for (std::size_t at = svg.find(word); at != std::string_view::npos; at = svg.find(word)) {
    const std::size_t begin = at + word.size();
    const std::size_t end = std::min(svg.find_first_not_of("0123456789", begin), svg.size());
    result += svg.substr(0, begin);
    const bool is_name = at > 0 && (svg[at - 1] == '"' || svg[at - 1] == '#') && end > begin;
    const std::string_view number = svg.substr(begin, end - begin);
    if (is_name)
      result += std::to_string(known.try_emplace(std::string(number), known.size() + 1).first->second);
    else
      result += number;
    svg.remove_prefix(end);
  }
  return result += svg;
}

constexpr std::size_t kFirstMark = 1'000'000;
constexpr std::string_view kMarkedStyle = "stroke-miterlimit:";

std::string xml_text(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else
      result += c;
  }
  return result;
}

// Of the same width in whatever font there is.
std::string svg_element(const SvgText& text) {
  const auto level = [](double part) { return std::lround(255 * std::clamp(part, 0.0, 1.0)); };
  const Colour& c = text.style.colour;
  return fmt::format(
      "<text x=\"{:.6g}\" y=\"{:.6g}\" font-family=\"'{}', 'DejaVu Sans', sans-serif\" font-size=\"{:.6g}\"{} "
      "fill=\"rgb({},{},{})\"{} textLength=\"{:.6g}\" lengthAdjust=\"spacingAndGlyphs\" "
      "xml:space=\"preserve\">{}</text>",
      text.x, text.y, kTypeface, text.style.size, text.style.weight == TextWeight::kBold ? " font-weight=\"bold\"" : "",
      level(c.r), level(c.g), level(c.b), c.a < 1 ? fmt::format(" fill-opacity=\"{:.4g}\"", c.a) : "", text.width,
      xml_text(text.text));
}

std::string with_texts(std::string_view svg, const std::vector<SvgText>& texts) {
  std::string result;
  for (std::size_t at = svg.find(kMarkedStyle); at != std::string_view::npos; at = svg.find(kMarkedStyle)) {
    std::size_t mark = 0;
    const char* const number = svg.data() + at + kMarkedStyle.size();
    std::from_chars(number, svg.data() + svg.size(), mark);
    const std::size_t end = std::min(svg.find("/>", at), svg.size() - 2) + 2;
    if (mark < kFirstMark || mark - kFirstMark >= texts.size()) {
      result += svg.substr(0, end);
    } else {
      result += svg.substr(0, svg.rfind('<', at));
      result += svg_element(texts[mark - kFirstMark]);
    }
    svg.remove_prefix(end);
  }
  return result += svg;
}

void check_sides(std::uint32_t width, std::uint32_t height) {
  if (width < 1 || height < 1 || width > kMaxPictureSide || height > kMaxPictureSide)
    throw UsageError("picture: a side must be between 1 and " + std::to_string(kMaxPictureSide) + " pixels");
}

}  // namespace

std::optional<PictureFormat> picture_format(std::string_view file_name) {
  if (file_name.ends_with(".png")) return PictureFormat::kPng;
  if (file_name.ends_with(".svg")) return PictureFormat::kSvg;
  if (file_name.ends_with(".pdf")) return PictureFormat::kPdf;
  return std::nullopt;
}

struct CairoCanvas::State {
  std::optional<PictureFormat> format{};  // none: a raster of the caller
  double width, height;
  Raster own{};  // of a PNG
  std::string bytes{};
  cairo_surface_t* surface = nullptr;
  cairo_t* context = nullptr;
  std::vector<SvgText> texts{};  // of an SVG

  State(double w, double h) : width(w), height(h) {}
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() {
    if (context) cairo_destroy(context);
    if (surface) cairo_surface_destroy(surface);
  }

  void draw_on(cairo_surface_t* target);
  void draw_on(Raster& raster);
  void ink(const Colour& c) const { cairo_set_source_rgba(context, c.r, c.g, c.b, c.a); }
  void trace(std::span<const std::vector<Pixel>> polygons) const {
    for (const std::vector<Pixel>& polygon : polygons) {
      if (polygon.size() < 3) continue;
      cairo_new_sub_path(context);
      for (const Pixel& p : polygon) cairo_line_to(context, p.x, p.y);
      cairo_close_path(context);
    }
  }
  void font(const TextStyle& style) const {
    cairo_select_font_face(context, kTypeface, CAIRO_FONT_SLANT_NORMAL,
                           style.weight == TextWeight::kBold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(context, style.size);
  }
  double advance(const std::string& text) const {
    cairo_text_extents_t extents;
    cairo_text_extents(context, text.c_str(), &extents);
    return extents.x_advance;
  }
};

void CairoCanvas::State::draw_on(cairo_surface_t* target) {
  surface = target;
  check(cairo_surface_status(surface));
  context = cairo_create(surface);
  check(cairo_status(context));
  cairo_set_line_cap(context, CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
  // Letters keep their shape and spacing at every size, on every surface.
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_set_font_options(context, options);
  cairo_font_options_destroy(options);
}

void CairoCanvas::State::draw_on(Raster& raster) {
  draw_on(cairo_image_surface_create_for_data(reinterpret_cast<unsigned char*>(raster.pixels.data()),
                                              CAIRO_FORMAT_ARGB32, static_cast<int>(raster.width),
                                              static_cast<int>(raster.height), static_cast<int>(4 * raster.width)));
}

CairoCanvas::CairoCanvas(PictureFormat format, std::uint32_t width, std::uint32_t height) {
  check_sides(width, height);
  state_ = std::make_unique<State>(width, height);
  state_->format = format;
  if (format == PictureFormat::kSvg) {
    state_->draw_on(cairo_svg_surface_create_for_stream(append, &state_->bytes, width, height));
    cairo_svg_surface_set_document_unit(state_->surface, CAIRO_SVG_UNIT_PX);
    return;
  }
  if (format == PictureFormat::kPdf) {
    state_->draw_on(
        cairo_pdf_surface_create_for_stream(append, &state_->bytes, kPointsAPixel * width, kPointsAPixel * height));
    // The same bytes whenever they are written.
    cairo_pdf_surface_set_metadata(state_->surface, CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
    cairo_scale(state_->context, kPointsAPixel, kPointsAPixel);
    return;
  }
  try {
    state_->own = Raster(width, height);
  } catch (const std::bad_alloc&) {
    check(CAIRO_STATUS_NO_MEMORY);
  }
  state_->draw_on(state_->own);
}

CairoCanvas::CairoCanvas(Raster& raster) {
  check_sides(raster.width, raster.height);
  HOTTEL_REQUIRE(raster.pixels.size() == std::size_t{raster.width} * raster.height);
  state_ = std::make_unique<State>(raster.width, raster.height);
  state_->draw_on(raster);
}

CairoCanvas::~CairoCanvas() = default;

double CairoCanvas::width() const { return state_->width; }
double CairoCanvas::height() const { return state_->height; }

void CairoCanvas::stroke(Mark, Pixel from, Pixel to, Colour colour, double line_width) {
  state_->ink(colour);
  cairo_set_line_width(state_->context, line_width);
  cairo_move_to(state_->context, from.x, from.y);
  cairo_line_to(state_->context, to.x, to.y);
  cairo_stroke(state_->context);
}

void CairoCanvas::fill(Mark, std::span<const Pixel> polygon, Colour colour) {
  if (polygon.size() < 3) return;
  state_->ink(colour);
  for (const Pixel& p : polygon) cairo_line_to(state_->context, p.x, p.y);
  cairo_close_path(state_->context);
  cairo_fill(state_->context);
}

void CairoCanvas::fill_all(Mark, std::span<const std::vector<Pixel>> polygons, Colour colour) {
  state_->ink(colour);
  state_->trace(polygons);
  cairo_fill(state_->context);
}

void CairoCanvas::fill_along(Mark, std::span<const Pixel> polygon, Pixel from, Pixel to,
                             std::span<const ColourStop> stops) {
  if (polygon.size() < 3) return;
  cairo_pattern_t* pattern = cairo_pattern_create_linear(from.x, from.y, to.x, to.y);
  for (const auto& [share, c] : stops) cairo_pattern_add_color_stop_rgba(pattern, share, c.r, c.g, c.b, c.a);
  cairo_set_source(state_->context, pattern);
  cairo_pattern_destroy(pattern);
  for (const Pixel& p : polygon) cairo_line_to(state_->context, p.x, p.y);
  cairo_close_path(state_->context);
  cairo_fill(state_->context);
}

void CairoCanvas::disc(Mark, Pixel centre, double radius, Colour colour) {
  state_->ink(colour);
  cairo_new_sub_path(state_->context);
  cairo_arc(state_->context, centre.x, centre.y, radius, 0, 2 * std::numbers::pi);
  cairo_fill(state_->context);
}

void CairoCanvas::circle(Mark, Pixel centre, double radius, Colour colour, double line_width) {
  state_->ink(colour);
  cairo_set_line_width(state_->context, line_width);
  cairo_new_sub_path(state_->context);
  cairo_arc(state_->context, centre.x, centre.y, radius, 0, 2 * std::numbers::pi);
  cairo_stroke(state_->context);
}

void CairoCanvas::text(Mark, Pixel at, std::string_view text, const TextStyle& style) {
  const std::string shown = printable(text);
  state_->font(style);
  state_->ink(style.colour);
  const bool is_svg = state_->format == PictureFormat::kSvg;
  const double wide = style.anchor == TextAnchor::kLeft && !is_svg ? 0 : state_->advance(shown);
  const double left = at.x - (style.anchor == TextAnchor::kCentre  ? wide / 2
                              : style.anchor == TextAnchor::kRight ? wide
                                                                   : 0);
  if (is_svg) {
    if (shown.empty() || !(wide > 0)) return;
    cairo_save(state_->context);
    cairo_set_miter_limit(state_->context, static_cast<double>(kFirstMark + state_->texts.size()));
    cairo_set_line_width(state_->context, style.size);
    cairo_move_to(state_->context, left, at.y - 0.3 * style.size);
    cairo_rel_line_to(state_->context, wide, 0);
    cairo_stroke(state_->context);
    cairo_restore(state_->context);
    state_->texts.push_back({left, at.y, wide, shown, style});
    return;
  }
  cairo_move_to(state_->context, left, at.y);
  cairo_show_text(state_->context, shown.c_str());
  cairo_new_path(state_->context);
}

void CairoCanvas::image(Mark, Pixel top_left, Pixel bottom_right, const Raster& raster, bool smooth) {
  HOTTEL_REQUIRE(raster.pixels.size() == static_cast<std::size_t>(raster.width) * raster.height);
  const double across = bottom_right.x - top_left.x, down = bottom_right.y - top_left.y;
  if (raster.pixels.empty() || across < kLeastImage || down < kLeastImage) return;
  // Cairo reads these pixels, and never writes them: they are a source only.
  cairo_surface_t* source = cairo_image_surface_create_for_data(
      reinterpret_cast<unsigned char*>(const_cast<std::uint32_t*>(raster.pixels.data())), CAIRO_FORMAT_ARGB32,
      static_cast<int>(raster.width), static_cast<int>(raster.height), static_cast<int>(4 * raster.width));
  if (cairo_surface_status(source) != CAIRO_STATUS_SUCCESS) {
    const cairo_status_t status = cairo_surface_status(source);
    cairo_surface_destroy(source);
    check(status);
  }
  cairo_t* context = state_->context;
  cairo_save(context);
  cairo_rectangle(context, top_left.x, top_left.y, across, down);
  cairo_clip(context);
  cairo_translate(context, top_left.x, top_left.y);
  cairo_scale(context, across / raster.width, down / raster.height);
  cairo_set_source_surface(context, source, 0, 0);
  cairo_pattern_set_filter(cairo_get_source(context), smooth ? CAIRO_FILTER_BILINEAR : CAIRO_FILTER_NEAREST);
  cairo_pattern_set_extend(cairo_get_source(context), CAIRO_EXTEND_PAD);
  cairo_paint(context);
  cairo_restore(context);
  cairo_surface_finish(source);  // an SVG has copied them by now
  cairo_surface_destroy(source);
}

void CairoCanvas::clip(std::span<const Pixel> polygon) {
  for (const Pixel& p : polygon) cairo_line_to(state_->context, p.x, p.y);
  cairo_close_path(state_->context);
  cairo_clip(state_->context);
}

void CairoCanvas::unclip() { cairo_reset_clip(state_->context); }

void CairoCanvas::begin_layer() { cairo_push_group(state_->context); }

// Clipped as a whole: files hold the polygons once.
void CairoCanvas::end_layer(std::span<const std::vector<Pixel>> inside) {
  cairo_pop_group_to_source(state_->context);
  cairo_save(state_->context);
  state_->trace(inside);
  cairo_clip(state_->context);
  cairo_paint(state_->context);
  cairo_restore(state_->context);
}

double CairoCanvas::text_width(std::string_view text, const TextStyle& style) const {
  state_->font(style);
  return state_->advance(printable(text));
}

std::string CairoCanvas::finish() {
  check(cairo_status(state_->context));
  cairo_surface_finish(state_->surface);
  check(cairo_surface_status(state_->surface));
  if (state_->format == PictureFormat::kPng) return png_file(state_->own);
  if (state_->format == PictureFormat::kSvg)
    return with_texts(with_own_numbers(with_own_numbers(state_->bytes, "surface"), "image"), state_->texts);
  return std::move(state_->bytes);
}

}  // namespace hottel
