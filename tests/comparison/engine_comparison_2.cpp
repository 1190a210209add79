#include "tests/comparison/engine_comparison_2.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "geometry/exchange/exchange_2.h"
#include "tests/oracle/brute_force_2.h"

namespace hottel::oracle {

namespace {

constexpr unsigned kBits = 512;  // of the reference values

mpf_class value_of(const LengthSum& lengths) {
  mpf_class sum(0, kBits);
  for (const auto& [squared, coefficient] : lengths) sum += coefficient * sqrt(mpf_class(squared, kBits));
  return sum;
}

// Sign of a - b, where what is left at 400 bits is taken for equality.
int compare(const mpf_class& a, const mpf_class& b) {
  mpf_class tolerance(1, kBits);
  mpf_div_2exp(tolerance.get_mpf_t(), tolerance.get_mpf_t(), 400);
  const mpf_class difference(a - b, kBits);
  if (abs(difference) < tolerance) return 0;
  return sgn(difference);
}

mpf_class half_way(double a, double b) { return (mpf_class(a, kBits) + mpf_class(b, kBits)) / 2; }

// Is the double nearest to the real number, ties to even?
bool is_nearest(double rounded, const mpf_class& real) {
  const double below = std::nextafter(rounded, -HUGE_VAL), above = std::nextafter(rounded, HUGE_VAL);
  const bool is_even = std::fmod(std::scalbn(rounded, 52 - std::ilogb(rounded)), 2) == 0;
  const int low = compare(half_way(below, rounded), real), high = compare(half_way(rounded, above), real);
  return is_even ? low <= 0 && high >= 0 : low < 0 && high > 0;
}

std::string digits(const mpf_class& value) { return fmt::format("{:.17g}", value.get_d()); }

// One scene, both ways.
class Comparison {
 public:
  Comparison(const Scene2& scene, ComparisonCounts& counts)
      : edges_(to_edges(scene)),
        counts_(counts),
        split_(split(edges_)),
        measures_(exchange_measures(split_.pieces)),
        prepared_(prepare(scene)),
        matrix_(exact_exchange(prepared_)),
        sky_(matrix_.sky()) {
    for (const Segment& piece : split_.pieces) {
      const Rational x = piece.bx - piece.ax, y = piece.by - piece.ay;
      for (const int label : {piece.left, piece.right}) {
        ++length_[label][x * x + y * y];
        owned_[label] += abs(x) + abs(y);
      }
    }
  }

  std::string run() {
    ++counts_.scenes;
    check_ownership();
    if (!wrong_.empty()) return wrong_;
    check_sums();
    for (std::uint32_t i = 0; i < matrix_.size(); ++i) {
      demand(matrix_.has_row(i) == has_row(i), [&] { return fmt::format("row {}: there or not", i); });
      if (matrix_.has_row(i) && has_row(i)) check_row(i);
    }
    return wrong_;
  }

 private:
  template <class Message>
  void demand(bool holds, const Message& message) {
    if (!holds) wrong_ += message() + "\n";
  }

  // The oracle's label of an engine's label: fronts and backs alternate in both.
  int label(std::uint32_t i) const { return i == sky_ ? kInfinity : static_cast<int>(i); }

  bool has_row(std::uint32_t i) const {
    if (i == sky_) return false;
    const InputSegment& edge = edges_[i / 2];
    return (i % 2 == 0 ? edge.front_material : edge.back_material) >= 0 && owned_.contains(label(i));
  }

  const LengthSum& measure(std::uint32_t i, std::uint32_t j) const {
    static const LengthSum nothing;
    const auto place = measures_.find(std::minmax({label(i), label(j)}));
    return place == measures_.end() ? nothing : place->second;
  }

  void check_ownership() {
    const Arrangement2& arrangement = prepared_.arrangement;
    using End = std::pair<Rational, Rational>;
    std::map<std::pair<End, End>, std::pair<int, int>> expected;
    for (const Segment& s : split_.pieces) expected[{{s.ax, s.ay}, {s.bx, s.by}}] = {s.left, s.right};
    demand(arrangement.pieces().size() == expected.size(),
           [&] { return fmt::format("{} pieces, the oracle has {}", arrangement.pieces().size(), expected.size()); });
    const auto owner = [&](PieceSideId side) {
      const FacePart& face = arrangement.owner(side);
      return static_cast<int>(2 * face.surface + (face.is_back ? 1 : 0));
    };
    for (std::size_t k = 0; k < arrangement.pieces().size(); ++k) {
      const Vertices2& vertices = arrangement.vertices();
      const auto end = [&](VertexId v) {
        const ExactPoint2 p = vertices.to_scene(vertices.exact(v));
        return End{p.x, p.y};
      };
      End a = end(arrangement.pieces()[k].a), b = end(arrangement.pieces()[k].b);
      std::pair<int, int> sides{owner(static_cast<PieceSideId>(2 * k)), owner(static_cast<PieceSideId>(2 * k + 1))};
      if (b < a) {
        std::swap(a, b);
        std::swap(sides.first, sides.second);
      }
      const auto place = expected.find({a, b});
      demand(place != expected.end() && place->second == sides, [&] {
        return fmt::format("piece {}: not there, or owned by others than {} and {}", k, sides.first, sides.second);
      });
    }
  }

  void check_sums() {
    std::vector<hottel::LabelPair> pairs;
    for (std::uint32_t i = 0; i < sky_; ++i)
      for (std::uint32_t j = i; j <= sky_; ++j)
        if (has_row(i) || has_row(j)) pairs.emplace_back(i, j);
    const std::vector<RootSum> sums = exact_exchange_measures(prepared_, Per::kFace, pairs);
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const std::uint32_t i = pairs[k].first, j = pairs[k].second;
      ++counts_.pairs;
      counts_.sums += !sums[k].is_zero();
      is_zero_[pairs[k]] = sums[k].is_zero();
      const ExactSum mine = to_exact_sum(sums[k] * Rational(2)), other = exact_sum(measure(i, j));
      demand(mine == other, [&] {
        return fmt::format("2 S({}, {}) = {}, the oracle has {}", i, j, mine.to_string(), other.to_string());
      });
    }
  }

  void check_row(std::uint32_t from) {
    const mpf_class twice_length(2 * value_of(length_.at(label(from))), kBits);
    auto entry = matrix_.row(from).begin();
    for (std::uint32_t to = 0; to <= sky_; ++to) {
      const bool is_listed = entry != matrix_.row(from).end() && entry->to == to;
      demand(is_listed != is_zero_.at(std::minmax({from, to})),
             [&] { return fmt::format("F({}, {}): an entry iff not zero", from, to); });
      if (!is_listed) {
        ++counts_.zeros;
        continue;
      }
      check_factor(from, to, entry->factor, mpf_class(value_of(measure(from, to)) / twice_length, kBits));
      if (to == sky_)
        demand(entry->visibility == entry->factor.value, [&] { return fmt::format("Vis({}, sky) is not F", from); });
      else if (owns_all(from) && owns_all(to))
        check_visibility(entry->visibility, from, to);
      ++entry;
    }
  }

  void check_factor(std::uint32_t from, std::uint32_t to, const Rounded& factor, const mpf_class& real) {
    ++counts_.factors;
    const int side = compare(real, mpf_class(factor.value, kBits));
    counts_.doubles += side == 0;
    const Enclosure enclosure = factor.enclosure();
    const bool contains = compare(mpf_class(enclosure.lower, kBits), real) <= 0 &&
                          compare(mpf_class(enclosure.upper, kBits), real) >= 0 && enclosure.contains(factor.value);
    const bool is_narrow = enclosure.upper <= std::nextafter(enclosure.lower, 2.0);
    demand(is_nearest(factor.value, real) && factor.side == side && contains && is_narrow, [&] {
      return fmt::format("F({}, {}) = {} on side {}, the oracle has {}", from, to, factor.value, factor.side,
                         digits(real));
    });
  }

  bool owns_all(std::uint32_t i) const {
    const InputSegment& edge = edges_[i / 2];
    const auto place = owned_.find(label(i));
    return place != owned_.end() && place->second == abs(edge.bx - edge.ax) + abs(edge.by - edge.ay);
  }

  // S / S0, with S0 by the brute force on the two edges alone.
  void check_visibility(double visibility, std::uint32_t from, std::uint32_t to) {
    ++counts_.visibilities;
    const std::vector<InputSegment> alone{edges_[from / 2], edges_[to / 2]};
    const Measures measures = exchange_measures(split(alone).pieces);
    const LengthSum& free = measures.at(std::minmax({static_cast<int>(from % 2), static_cast<int>(2 + to % 2)}));
    const mpf_class real(value_of(measure(from, to)) / value_of(free), kBits);
    const bool is_whole = compare(real, mpf_class(1, kBits)) == 0;
    const double largest = std::nextafter(1.0, 0.0);  // of what is hidden in part
    const bool is_rounded = visibility == largest ? compare(real, half_way(std::nextafter(largest, 0.0), largest)) > 0
                                                  : is_nearest(visibility, real);
    demand(visibility > 0 && visibility <= 1 && (visibility == 1) == is_whole && is_rounded,
           [&] { return fmt::format("Vis({}, {}) = {}, the oracle has {}", from, to, visibility, digits(real)); });
  }

  std::vector<InputSegment> edges_;
  ComparisonCounts& counts_;
  Split split_;
  Measures measures_;
  PreparedScene2 prepared_;
  ExchangeMatrix matrix_;
  std::uint32_t sky_;
  std::map<int, LengthSum> length_;  // by label, as lengths of owned pieces
  std::map<int, Rational> owned_;    // by label, |x| + |y| of the owned pieces
  std::map<hottel::LabelPair, bool> is_zero_;
  std::string wrong_;
};

}  // namespace

Scene2 to_scene(const std::vector<InputSegment>& edges) {
  Scene2 scene;
  scene.file = "edges";
  for (int m = 0; m < 3; ++m) {
    Material material;
    material.name = "material " + std::to_string(m);
    Rational reflectivity(m, 4);
    reflectivity.canonicalize();
    material.reflectivity = Spectrum::scalar(reflectivity);
    material.emission = Spectrum::scalar(m == 2 ? 1 : 0);
    scene.materials.push_back(material);
  }
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const InputSegment& edge = edges[k];
    Surface2 surface;
    surface.name = "e" + std::to_string(k);
    surface.from = {edge.ax, edge.ay};
    surface.to = {edge.bx, edge.by};
    surface.material = static_cast<std::uint32_t>(edge.front_material);
    if (edge.back_material >= 0) surface.back = static_cast<std::uint32_t>(edge.back_material);
    surface.group = static_cast<std::uint32_t>(k);
    scene.surfaces.push_back(surface);
    scene.groups.push_back(surface.name);
  }
  validate(scene);
  return scene;
}

std::vector<InputSegment> to_edges(const Scene2& scene) {
  const auto& materials = scene.materials;
  const auto number = [&](std::uint32_t material) {  // materials that act alike have one number
    return static_cast<int>(std::find(materials.begin(), materials.end(), materials[material]) - materials.begin());
  };
  std::vector<InputSegment> edges;
  for (const Surface2& s : scene.surfaces)
    edges.push_back({s.from.x, s.from.y, s.to.x, s.to.y, number(s.material), s.back ? number(*s.back) : -1});
  return edges;
}

ExactSum to_exact_sum(const RootSum& sum) {
  ExactSum result;
  for (const RootSum::Term& term : sum.terms()) result.add(term.coefficient, Rational(term.radicand));
  return result;
}

std::string disagreement(const Scene2& scene, ComparisonCounts& counts) { return Comparison(scene, counts).run(); }

}  // namespace hottel::oracle
