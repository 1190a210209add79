#include "io/scene/space/vs3_deck.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "geometry/name.h"
#include "geometry/number.h"
#include "geometry/planarity.h"
#include "geometry/space/scene/near_plane.h"
#include "io/scene/space/vs3_statements.h"
#include "kernel/decimal.h"
#include "kernel/exact_double.h"
#include "kernel/plain_functions.h"
#include "kernel/support/failure.h"
#include "kernel/support/trimmed.h"

namespace hottel {
namespace {

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

// A control of the deck, and what its value may be.
struct Control {
  std::string_view name;
  bool is_whole;
};
constexpr std::array<Control, 13> kControls{{{"eps", false},
                                             {"maxu", true},
                                             {"maxo", true},
                                             {"mino", true},
                                             {"maxv", true},
                                             {"prjd", true},
                                             {"maxd", false},
                                             {"row", true},
                                             {"col", true},
                                             {"out", true},
                                             {"list", true},
                                             {"encl", true},
                                             {"emit", true}}};

struct CosineAndSine {
  Rational cosine, sine;
};

// Those of an angle in degrees. A turn by less than an eighth has the half tangent N / 2^52 and so a rational cosine
// (1 - t^2) / (1 + t^2) and sine 2 t / (1 + t^2); whole quarters are added exactly.
CosineAndSine turn(const Rational& degrees, bool& is_exact) {
  Integer quarters;
  const Rational halves = degrees / 90 + Rational(1, 2);
  mpz_fdiv_q(quarters.get_mpz_t(), halves.get_num_mpz_t(), halves.get_den_mpz_t());
  const Rational rest = degrees - 90 * Rational(quarters);
  CosineAndSine result{1, 0};
  if (rest != 0) {
    is_exact = false;
    const double half = same_bits::tan(to_double(rest) * (std::numbers::pi / 360));
    const Rational t = scaled_by_power_of_two(exact_value(std::nearbyint(std::ldexp(half, 52))), -52);
    const Rational squared = t * t;
    result = {(1 - squared) / (1 + squared), 2 * t / (1 + squared)};
  }
  for (unsigned long k = mpz_fdiv_ui(quarters.get_mpz_t(), 4); k > 0; --k)
    result = {-result.sine, std::move(result.cosine)};
  return result;
}

class DeckReader3 {
 public:
  DeckReader3(std::string_view text, const std::string& file) : at_(text, file) { deck_.file = file; }

  Vs3Deck3 read() {
    while (at_.next()) read_statement();
    if (deck_.records.empty()) at_.refuse("the deck has no surfaces");
    if (deck_.output.column != 0 && deck_.output.row == 0)
      throw InputError({deck_.file, deck_.output.line}, "col=" + std::to_string(deck_.output.column) +
                                                            " is set without row=: a column belongs to a row");
    deck_.unit = finest_.unit();
    return std::move(deck_);
  }

 private:
  void read_statement() {
    switch (const char letter = at_.letter()) {
      case 'T':
        return read_title();
      case 'C':
        return read_controls();
      case 'F':
        return read_form();
      case 'V':
        return read_vertex();
      case 'S':
      case 'M':
      case 'N':
      case 'O':
        return read_record(static_cast<Vs3Kind3>(letter));
      case 'X':
        at_.refuse("X, a transformation of coordinates, is not read", {"View3D passes over it: leave it out"});
      default:
        at_.refuse("the letter " + quoted_name({&letter, 1}) + " is not known",
                   {"records begin with T, C, F, V, S, M, N, O or E; comments with ! or /"});
    }
  }

  void read_title() {
    const std::string_view title = trimmed(at_.rest(), " \t");
    if (has_control_character(title)) at_.refuse("the title has a control character or is not UTF-8");
    deck_.title = title;
  }

  void read_controls() {
    std::vector<std::string_view> words;
    constexpr std::string_view kBetween = " \t,=";
    for (std::string_view rest = at_.rest();;) {
      rest.remove_prefix(std::min(rest.find_first_not_of(kBetween), rest.size()));
      if (rest.empty() || rest.front() == '!') break;
      words.push_back(rest.substr(0, rest.find_first_of(kBetween)));
      rest.remove_prefix(words.back().size());
    }
    for (std::size_t k = 0; k < words.size(); k += 2) {
      if (k + 1 == words.size()) at_.refuse("the control " + quoted_name(words[k]) + " has no value");
      read_control(words[k], words[k + 1]);
    }
  }

  void read_control(std::string_view name, std::string_view value) {
    const std::string key = lower(name);
    const auto control =
        std::find_if(kControls.begin(), kControls.end(), [&](const Control& c) { return c.name == key; });
    if (control == kControls.end())
      at_.refuse("the control " + quoted_name(name) + " is not known",
                 {"there are eps, maxU, maxO, minO, row, col, encl, emit, out, list, prjD, maxV and maxD"});
    const std::string subject = "control " + std::string(name);
    const std::uint32_t count = control->is_whole ? at_.count(value, subject) : 0;
    if (!control->is_whole) at_.number(value, subject);
    if (key == "encl" || key == "emit") {
      (key == "encl" ? deck_.is_enclosure : deck_.output.wants_script_f) |= count != 0;
      return;
    }
    if (take_output_control(key, count)) return;
    const auto is_it = [&](const std::string& other) { return lower(other) == key; };
    if (std::none_of(deck_.not_obeyed.begin(), deck_.not_obeyed.end(), is_it)) deck_.not_obeyed.emplace_back(name);
  }

  // The last value of each counts.
  bool take_output_control(const std::string& key, std::uint32_t value) {
    Vs3Output3& output = deck_.output;
    if (key == "row" || key == "col") {
      (key == "row" ? output.row : output.column) = value;
      output.line = at_.line();
    } else if (key == "list") {
      output.list = value;
    } else if (key == "out") {
      if (value > 2)
        at_.refuse("control out is " + std::to_string(value) + ": there are 0, text, 1, binary, and 2, a sparse list");
      output.out = value;
    } else {
      return false;
    }
    return true;
  }

  void read_form() {
    const std::string form = lower(at_.word("F: the form"));
    if (form != "3" && form != "3a")
      at_.refuse("the form " + quoted_name(form) + " is not read: decks in space have the form 3 or 3a");
    if (!vertices_.empty() || !deck_.records.empty()) at_.refuse("F stands after vertices or surfaces");
    has_vertices_ = form == "3";
  }

  void read_vertex() {
    if (!has_vertices_) at_.refuse("V belongs to the form F 3; this deck has the form F 3a");
    const std::uint32_t number = at_.count(at_.word("V: the number"), "V: the number");
    if (number != vertices_.size() + 1)
      at_.refuse("vertex " + std::to_string(number) + " is out of sequence: " + std::to_string(vertices_.size() + 1) +
                 " comes next");
    const std::string owner = "vertex " + std::to_string(number);
    Point3 point;
    for (auto [coordinate, name] : {std::pair{&point.x, ": x"}, {&point.y, ": y"}, {&point.z, ": z"}}) {
      const std::string_view word = at_.word(owner + name);
      *coordinate = at_.number(word, owner + name);
      finest_.take(word);
    }
    vertices_.push_back(std::move(point));
  }

  void read_record(Vs3Kind3 kind) {
    const std::string next = std::to_string(deck_.records.size() + 1);
    owner_ = std::string(kind == Vs3Kind3::kObstruction ? "obstruction " : "surface ") + next;
    if (const std::string_view number = at_.word(owner_ + ": its number"); number != next)
      at_.refuse("surface " + quoted_name(number) + " is out of sequence: " + next + " comes next");
    if (kind != Vs3Kind3::kObstruction && !deck_.records.empty() && deck_.records.back().kind == Vs3Kind3::kObstruction)
      at_.refuse(owner_ + " stands after an obstruction: obstructions come last");
    Vs3Record3 record;
    record.kind = kind;
    record.line = at_.line();
    if (has_vertices_) {
      record.polygon.points = listed_vertices();
      read_table(record);
    } else {
      const char shape = read_shape();
      read_table(record);
      record.polygon.points = points_in_a_plane(shape);
    }
    deck_.records.push_back(std::move(record));
  }

  // v1 v2 v3 v4, the last 0 for a triangle.
  std::vector<Point3> listed_vertices() {
    std::vector<Point3> points;
    for (const char* name : {": v1", ": v2", ": v3", ": v4"}) {
      const std::uint32_t number = count(name);
      if (number == 0 && points.size() == 3) break;
      if (number < 1 || number > vertices_.size())
        at_.refuse(owner_ + name + ": the vertex " + std::to_string(number) + " is none of the " +
                   std::to_string(vertices_.size()) + " that stand before it");
      points.push_back(vertices_[number - 1]);
    }
    return points;
  }

  char read_shape() {
    const std::string_view word = at_.word(owner_ + ": its shape");
    const char shape = lower(word).front();
    if (shape != 'r' && shape != 'q' && shape != 't')
      at_.refuse(owner_ + ": the shape " + quoted_name(word) + " is not known",
                 {"it is R, a rectangle, Q, a quadrilateral, or T, a triangle"});
    return shape;
  }

  // base cmb emit name
  void read_table(Vs3Record3& record) {
    if (record.kind == Vs3Kind3::kObstruction) return;
    record.base = count(": base");
    record.combined_with = count(": cmb");
    record.emittance = at_.number(at_.word(owner_ + ": emit"), owner_ + ": emit");
    if (record.emittance < 0 || record.emittance > 1)
      at_.refuse(owner_ + ": the emittance " + short_text(record.emittance) + " is not from 0 to 1");
    record.name = at_.word(owner_ + ": its name");
    if (const auto problem = name_problem(record.name); !problem.empty())
      at_.refuse(owner_ + ": the name " + quoted_name(record.name) + " " + std::string(problem));
  }

  // x y z azimuth tilt on the next line, and then, there or on lines below, what the shape needs.
  std::vector<Point3> points_in_a_plane(char shape) {
    at_.next_line(owner_ + ": x");
    const auto number = [this](const char* name) {
      const std::string subject = owner_ + ": " + name;
      return at_.number(at_.word_of_lines(subject), subject);
    };
    const Rational x = number("x"), y = number("y"), z = number("z"), azimuth = number("azimuth"),
                   tilt = number("tilt");
    bool is_exact = true;
    const CosineAndSine a = turn(azimuth, is_exact), t = turn(tilt, is_exact);
    deck_.has_inexact_angles |= !is_exact;
    std::vector<std::array<Rational, 2>> flat;
    if (shape == 'r') {
      const Rational width = number("width"), height = number("height");
      flat = {{0, height}, {0, 0}, {width, 0}, {width, height}};
    } else {
      flat.resize(shape == 'q' ? 4 : 3);
      for (auto& [across, up] : flat) {
        across = number("a coordinate");
        up = number("a coordinate");
      }
    }
    std::vector<Point3> points;
    for (const auto& [across, up] : flat)
      points.push_back({x - across * a.cosine - up * t.cosine * a.sine, y + across * a.sine - up * t.cosine * a.cosine,
                        z + up * t.sine});
    return points;
  }

  std::uint32_t count(const char* name) { return at_.count(at_.word(owner_ + name), owner_ + name); }

  Vs3Statements3 at_;
  Vs3Deck3 deck_;
  bool has_vertices_ = true;  // F 3
  std::vector<Point3> vertices_;
  FinestDigit finest_;  // of these
  std::string owner_;   // of the record, for messages
};

}  // namespace

Vs3Deck3 parse_vs3_deck_3(std::string_view text, const std::string& file) { return DeckReader3(text, file).read(); }

}  // namespace hottel
