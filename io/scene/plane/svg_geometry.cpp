#include "io/scene/plane/svg_geometry.h"

#include <algorithm>
#include <cctype>
#include <optional>

namespace hottel {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

std::string quoted(std::string_view text) {
  constexpr std::size_t kMost = 40;
  return "'" + std::string(text.substr(0, kMost)) + (text.size() > kMost ? "...'" : "'");
}

// Reads numbers, letters and separators of an attribute from left to right.
class SvgScanner {
 public:
  explicit SvgScanner(std::string_view text) : text_(text) {}

  void skip_blanks() {
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
  }
  bool is_at_end() {
    skip_blanks();
    return at_ == text_.size();
  }
  bool accept(char c) {
    skip_blanks();
    if (at_ == text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  bool is_at_number() {
    skip_blanks();
    return at_ < text_.size() && (is_digit(text_[at_]) || text_[at_] == '.' || text_[at_] == '-' || text_[at_] == '+');
  }
  std::string_view word() {
    skip_blanks();
    const std::size_t begin = at_;
    while (at_ < text_.size() && is_letter(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }
  std::optional<char> letter() {
    skip_blanks();
    if (at_ == text_.size() || !is_letter(text_[at_])) return std::nullopt;
    return text_[at_++];
  }
  std::string rest() const { return quoted(text_.substr(at_)); }

  // A number of the SVG grammar: "1.5.5" are two, and so are "1-2".
  Rational number() {
    skip_blanks();
    const std::size_t begin = at_;
    std::string sign;
    if (at_ < text_.size() && (text_[at_] == '-' || text_[at_] == '+')) sign = text_[at_++] == '-' ? "-" : "";
    std::string whole = digits(), exponent;
    std::string fraction;
    const bool has_point = at_ < text_.size() && text_[at_] == '.';
    if (has_point) {
      ++at_;
      fraction = digits();
    }
    if (whole.empty() && fraction.empty()) {
      at_ = begin;
      throw SvgAttributeError("has no number where one is due, at " + rest());
    }
    if (at_ < text_.size() && (text_[at_] == 'e' || text_[at_] == 'E')) {
      const std::size_t mark = at_++;
      std::string exponent_sign;
      if (at_ < text_.size() && (text_[at_] == '-' || text_[at_] == '+')) exponent_sign = text_[at_++];
      exponent = digits();
      if (exponent.empty())
        at_ = mark;  // the e of "em"
      else
        exponent = "e" + exponent_sign + exponent;
    }
    whole.erase(0, std::min(whole.find_first_not_of('0'), whole.size()));
    std::string plain = sign + (whole.empty() ? "0" : whole);
    if (!fraction.empty()) plain += "." + fraction;
    if (const auto value = parse_rational(plain + exponent)) return *value;
    throw SvgAttributeError("has a number that is too long to be read, " + quoted(text_.substr(begin, at_ - begin)));
  }

  void skip_comma() { accept(','); }

 private:
  std::string digits() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && is_digit(text_[at_])) ++at_;
    return std::string(text_.substr(begin, at_ - begin));
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

// Follows the commands of a path.
class SvgPathReader {
 public:
  explicit SvgPathReader(std::string_view text) : in_(text) {}

  std::vector<SvgRun> read() {
    while (!in_.is_at_end()) {
      const auto command = in_.letter();
      if (!command) throw SvgAttributeError("has no command where one is due, at " + in_.rest());
      obey(*command);
    }
    end_run();
    return std::move(runs_);
  }

 private:
  void obey(char command) {
    const bool relative = std::islower(static_cast<unsigned char>(command)) != 0;
    const char kind = static_cast<char>(std::toupper(static_cast<unsigned char>(command)));
    if (kind == 'Z') return close();
    if (kind != 'M' && kind != 'L' && kind != 'H' && kind != 'V')
      throw SvgAttributeError(std::string("has the command '") + command +
                              "': only straight pieces (M L H V Z) are read");
    if (!has_begun_ && kind != 'M') throw SvgAttributeError("does not begin with M");
    bool is_move = kind == 'M';
    do {
      Point2 to = here_;
      if (kind != 'V') {
        to.x = in_.number() + (relative ? here_.x : Rational(0));
      }
      if (kind == 'M' || kind == 'L') in_.skip_comma();
      if (kind != 'H') {
        to.y = in_.number() + (relative ? here_.y : Rational(0));
      }
      is_move ? move(to) : draw(to);
      is_move = false;
      has_comma_ = in_.accept(',');
    } while (has_comma_ || in_.is_at_number());
  }

  void move(const Point2& to) {
    end_run();
    here_ = start_ = to;
    has_begun_ = true;
  }

  void draw(const Point2& to) {
    if (run_.points.empty()) run_.points.push_back(here_);
    run_.points.push_back(to);
    here_ = to;
  }

  void close() {
    if (!has_begun_) throw SvgAttributeError("does not begin with M");
    if (!run_.points.empty()) {
      // "L 0 0 Z" back at the start: there is nothing left to draw.
      if (run_.points.back() == run_.points.front()) run_.points.pop_back();
      run_.closed = true;
    }
    end_run();
    here_ = start_;
  }

  void end_run() {
    if (!run_.points.empty()) runs_.push_back(std::move(run_));
    run_ = {};
  }

  SvgScanner in_;
  std::vector<SvgRun> runs_;
  SvgRun run_;
  Point2 here_{0, 0}, start_{0, 0};
  bool has_begun_ = false, has_comma_ = false;
};

SvgTransform2 rotation(const Rational& degrees) {
  const Rational quarters = degrees / 90;
  if (quarters.get_den() != 1)
    throw SvgAttributeError("has a rotation by " + to_string(degrees) + " degrees: only multiples of 90 are exact");
  const Integer turn = ((quarters.get_num() % 4) + 4) % 4;
  const int cosine[] = {1, 0, -1, 0}, sine[] = {0, 1, 0, -1};
  const auto q = turn.get_ui();
  return {cosine[q], sine[q], -sine[q], cosine[q], 0, 0};
}

SvgTransform2 one_transform(std::string_view name, const std::vector<Rational>& v) {
  const auto counts = [&](std::initializer_list<std::size_t> allowed) {
    if (std::find(allowed.begin(), allowed.end(), v.size()) == allowed.end())
      throw SvgAttributeError("has a wrong number of arguments for " + std::string(name));
  };
  if (name == "translate") {
    counts({1, 2});
    return {1, 0, 0, 1, v[0], v.size() > 1 ? v[1] : Rational(0)};
  }
  if (name == "scale") {
    counts({1, 2});
    return {v[0], 0, 0, v.back(), 0, 0};
  }
  if (name == "matrix") {
    counts({6});
    return {v[0], v[1], v[2], v[3], v[4], v[5]};
  }
  if (name == "rotate") {
    counts({1, 3});
    if (v.size() == 1) return rotation(v[0]);
    const SvgTransform2 there{1, 0, 0, 1, v[1], v[2]}, back{1, 0, 0, 1, -v[1], -v[2]};
    return there.after(rotation(v[0]).after(back));
  }
  throw SvgAttributeError("has " + quoted(name) + ": only translate, scale, matrix and rotate are exact");
}

}  // namespace

Point2 SvgTransform2::apply(const Point2& p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }

SvgTransform2 SvgTransform2::after(const SvgTransform2& inner) const {
  const Point2 shift = apply({inner.e, inner.f});
  return {a * inner.a + c * inner.b,
          b * inner.a + d * inner.b,
          a * inner.c + c * inner.d,
          b * inner.c + d * inner.d,
          shift.x,
          shift.y};
}

Rational parse_svg_length_2(std::string_view text) {
  SvgScanner in(text);
  Rational value = in.number();
  const std::string unit = in.rest();
  if (const std::string_view word = in.word(); !(word.empty() || word == "px") || !in.is_at_end())
    throw SvgAttributeError("has the unit " + unit + ": only user units (none, or px) are exact");
  return value;
}

std::vector<Point2> parse_svg_points_2(std::string_view text) {
  SvgScanner in(text);
  std::vector<Point2> points;
  while (!in.is_at_end()) {
    if (!points.empty()) in.skip_comma();
    Point2 p;
    p.x = in.number();
    in.skip_comma();
    p.y = in.number();
    points.push_back(std::move(p));
  }
  return points;
}

std::vector<SvgRun> parse_svg_path_2(std::string_view text) { return SvgPathReader(text).read(); }

SvgTransform2 parse_svg_transform_2(std::string_view text) {
  SvgScanner in(text);
  SvgTransform2 result;
  while (!in.is_at_end()) {
    const std::string_view name = in.word();
    if (name.empty() || !in.accept('(')) throw SvgAttributeError("is no list of transforms, at " + in.rest());
    std::vector<Rational> arguments;
    while (!in.accept(')')) {
      if (!arguments.empty()) in.skip_comma();
      arguments.push_back(in.number());
    }
    result = result.after(one_transform(name, arguments));
    in.skip_comma();
  }
  if (result.a * result.d == result.b * result.c) throw SvgAttributeError("flattens everything onto a line");
  return result;
}

}  // namespace hottel
