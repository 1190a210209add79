#include "tests/storm/plane/laws.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <random>

#include "geometry/plane/exchange/closed_forms.h"
#include "geometry/plane/exchange/exchange.h"
#include "tests/comparison/plane/engine_comparison.h"
#include "tests/solver/plane/exact_radiosity.h"
#include "tests/storm/plane/division_laws.h"
#include "tests/storm/plane/long_map.h"
#include "tests/storm/plane/repair_laws.h"
#include "tests/storm/plane/solid_laws.h"

namespace hottel::storm {

namespace {

using oracle::InputSegment;

std::string closure_is_broken(const Subject& subject) {
  return subject.report().closure_is_exact ? "" : "rows do not close as integers\n";
}

std::string range_is_broken(const Subject& subject) {
  const ExchangeMatrix& matrix = subject.matrix();
  std::string wrong;
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    double sum = 0;
    for (const auto& [to, factor, visibility] : matrix.row(i)) {
      sum += factor.value;
      if (!(factor.value > 0 && factor.enclosure().lower >= 0 && factor.enclosure().upper <= 1))
        wrong += fmt::format("F({}, {}) = {}\n", i, to, factor.value);
      if (!(visibility > 0 && visibility <= 1)) wrong += fmt::format("Vis({}, {}) = {}\n", i, to, visibility);
    }
    if (matrix.has_row(i) && std::abs(sum - 1) > 0x1p-53 * static_cast<double>(2 * matrix.row(i).size()))
      wrong += fmt::format("row {} sums to {:.17g}\n", i, sum);
  }
  return wrong;
}

void turn_round(InputSegment& edge) {
  std::swap(edge.ax, edge.bx);
  std::swap(edge.ay, edge.by);
}

std::string translation_is_broken(const Subject& subject) {
  const mpq_class east = (mpq_class(1) << 53) + 1, north = -(mpq_class(1) << 60) + 7;
  return difference(subject.numbers(), numbers_of(moved(subject.edges(), [&](mpq_class& x, mpq_class& y) {
                      x += east;
                      y += north;
                    })));
}

std::string scaling_is_broken(const Subject& subject) {
  return difference(subject.numbers(), numbers_of(moved(subject.edges(), [](mpq_class& x, mpq_class& y) {
                      x <<= 20;
                      y <<= 20;
                    })));
}

std::string rotation_is_broken(const Subject& subject) {
  return difference(subject.numbers(), numbers_of(moved(subject.edges(), [](mpq_class& x, mpq_class& y) {
                      std::swap(x, y);
                      x = -x;
                    })));
}

// Do the edges have a piece in common?
bool overlap(const InputSegment& e, const InputSegment& f) {
  const auto turn = [&](const mpq_class& x, const mpq_class& y) {
    return mpq_class((e.bx - e.ax) * (y - e.ay) - (e.by - e.ay) * (x - e.ax));
  };
  if (turn(f.ax, f.ay) != 0 || turn(f.bx, f.by) != 0) return false;
  const auto reach = [](const InputSegment& s) { return std::minmax({std::pair(s.ax, s.ay), std::pair(s.bx, s.by)}); };
  return std::max(reach(e).first, reach(f).first) < std::min(reach(e).second, reach(f).second);
}

// Of each edge whether it overlaps no other: where edges overlap, the first listed of equal claims owns the piece. The
// sky, as the last, is alone.
std::vector<char> alone(const Edges& edges) {
  std::vector<char> is_alone(edges.size() + 1, 1);
  for (std::size_t k = 0; k < edges.size(); ++k)
    for (std::size_t other = 0; other < edges.size(); ++other)
      if (other != k && overlap(edges[k], edges[other])) is_alone[k] = 0;
  return is_alone;
}

// Takes away what is printed of faces on edges that are not marked.
Numbers only_of(Numbers numbers, const std::vector<char>& is_marked) {
  std::erase_if(numbers, [&](const auto& entry) {
    return !is_marked[entry.first.first / 2] || !is_marked[entry.first.second / 2];
  });
  return numbers;
}

// A polyline turned round is listed from its last edge to its first, which then is the first to own what both claim.
std::string reflection_is_broken(const Subject& subject) {
  oracle::Groups order = oracle::groups_of(subject.edges());
  std::vector<char> is_compared(subject.edges().size() + 1, 1);
  for (std::vector<std::size_t>& group : order) {
    for (const std::size_t k : group)
      for (const std::size_t other : group)
        if (k != other && overlap(subject.edges()[k], subject.edges()[other])) is_compared[k] = 0;
    std::reverse(group.begin(), group.end());
  }
  Reordered mirrored = reordered(moved(subject.edges(), [](mpq_class& x, mpq_class&) { x = -x; }), order);
  for (InputSegment& edge : mirrored.edges) turn_round(edge);
  const Numbers numbers = numbers_of(mirrored.edges, [&](std::uint32_t label) { return mirrored.label(label); });
  return difference(only_of(subject.numbers(), is_compared), only_of(numbers, is_compared));
}

std::string reversal_is_broken(const Subject& subject) {
  const Edges& edges = subject.edges();
  const auto is_turned = [&](std::size_t k) { return edges[k].back_material >= 0 && edges[k].group == oracle::kAlone; };
  Edges reversed = edges;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    if (!is_turned(k)) continue;
    turn_round(reversed[k]);
    std::swap(reversed[k].front_material, reversed[k].back_material);
  }
  return difference(subject.numbers(), numbers_of(reversed, [&](std::uint32_t label) {
                      return is_turned(label / 2) ? label ^ 1U : label;
                    }));
}

// S and Vis of each pair of edges that overlap no other, from the one to the other: keys (i, j) with i < j, or those
// with i > j the other way round.
using Exchanges = std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<double, double>>;
Exchanges exchanges(const ExchangeMatrix& matrix, const std::vector<char>& is_alone, bool backwards,
                    const Relabelling& label) {
  Exchanges result;
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    for (std::size_t k = 0; k < matrix.row(i).size(); ++k) {
      const FactorEntry& entry = matrix.row(i)[k];
      if (entry.to == matrix.sky() || !matrix.has_row(entry.to)) continue;
      std::pair<std::uint32_t, std::uint32_t> pair{label(i), label(entry.to)};
      if (backwards) std::swap(pair.first, pair.second);
      if (pair.first < pair.second && is_alone[pair.first / 2] && is_alone[pair.second / 2])
        result[pair] = {matrix.measures(i)[k], entry.visibility};
    }
  return result;
}

std::string symmetry_is_broken(const Subject& subject) {
  const Edges& edges = subject.edges();
  const std::vector<char> is_alone = alone(edges);
  oracle::Groups order = oracle::groups_of(edges);
  std::reverse(order.begin(), order.end());
  const Reordered last_first = reordered(edges, order);
  const Subject reversed(last_first.edges, subject.chance());
  const Exchanges forth = exchanges(subject.matrix(), is_alone, false, [](std::uint32_t i) { return i; });
  const Exchanges back =
      exchanges(reversed.matrix(), is_alone, true, [&](std::uint32_t i) { return last_first.label(i); });
  std::string wrong;
  for (const auto& [pair, exchange] : forth) {
    const auto place = back.find(pair);
    if (place == back.end() || place->second != exchange)
      wrong += fmt::format("S({}, {}) = {:.17g}, Vis = {:.17g}, but not from there\n", pair.first, pair.second,
                           exchange.first, exchange.second);
  }
  if (back.size() != forth.size()) wrong += "other pairs see each other the other way round\n";
  return wrong;
}

std::string permutation_is_broken(const Subject& subject) {
  oracle::Groups order = oracle::groups_of(subject.edges());
  std::mt19937_64 random(subject.chance());
  for (std::size_t k = order.size(); k > 1; --k) std::swap(order[k - 1], order[random() % k]);
  for (std::vector<std::size_t>& group : order)  // an outline may begin anywhere
    if (oracle::is_closed(subject.edges(), group))
      std::rotate(group.begin(), group.begin() + static_cast<std::ptrdiff_t>(random() % group.size()), group.end());
  const Reordered permuted = reordered(subject.edges(), order);
  const std::vector<char> is_alone = alone(subject.edges());
  const Numbers numbers = numbers_of(permuted.edges, [&](std::uint32_t label) { return permuted.label(label); });
  return difference(only_of(subject.numbers(), is_alone), only_of(numbers, is_alone));
}

// S between every face (and the sky) and both faces of one edge: of edge `first`, or of it and the next together.
std::vector<RootSum> measures_of_edge(const Edges& edges, std::uint32_t first, std::uint32_t parts) {
  const PreparedScene2 prepared = prepare(oracle::to_scene(edges));
  const std::uint32_t sky = static_cast<std::uint32_t>(2 * edges.size());
  const auto others = sky - 2 * parts + 1;
  std::vector<ElementPair> pairs;
  for (std::uint32_t part = 0; part < parts; ++part)
    for (const std::uint32_t side : {0U, 1U})
      for (std::uint32_t i = 0; i <= sky; ++i)
        if (i / 2 < first || i / 2 >= first + parts) pairs.push_back(std::minmax({2 * (first + part) + side, i}));
  const std::vector<RootSum> measures = exact_exchange_measures(prepared, Granularity::kFace, pairs);
  std::vector<RootSum> result(2 * others);
  for (std::size_t k = 0; k < measures.size(); ++k) result[k % result.size()] += measures[k];
  return result;
}

std::string splitting_is_broken(const Subject& subject) {
  const Edges& edges = subject.edges();
  const auto cut = static_cast<std::uint32_t>(subject.chance() % edges.size());
  Edges split = edges;
  if (split[cut].group == oracle::kAlone)  // both parts stay one group
    split[cut].group = 1 + std::max_element(edges.begin(), edges.end(), [](const auto& e, const auto& f) {
                             return e.group < f.group;
                           })->group;
  InputSegment rest = split[cut];
  split[cut].bx = rest.ax = (rest.ax + rest.bx) / 2;
  split[cut].by = rest.ay = (rest.ay + rest.by) / 2;
  split.insert(split.begin() + cut + 1, rest);
  const std::vector<RootSum> whole = measures_of_edge(edges, cut, 1), parts = measures_of_edge(split, cut, 2);
  std::string wrong;
  for (std::size_t k = 0; k < whole.size(); ++k)
    if (!(whole[k] - parts[k]).is_zero())
      wrong += fmt::format("edge {} cut: S number {} = {}, its parts {}\n", cut, k, whole[k].to_string(),
                           parts[k].to_string());
  return wrong;
}

// Who sees whom, and whether wholly.
std::map<std::pair<std::uint32_t, std::uint32_t>, bool> sights(const Numbers& numbers, std::size_t edges) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, bool> result;
  for (const auto& [pair, number] : numbers)
    result[pair] = pair.second < 2 * edges && std::get<2>(number) == 1;  // Vis of the sky is its factor
  return result;
}

std::string digits_are_broken(const Subject& subject) {
  std::mt19937_64 random(subject.chance());
  const Edges& edges = subject.edges();
  const std::string wrong =
      difference(subject.numbers(), numbers_of(moved(edges, long_similarity(random, random() % 2 == 0))));
  const Numbers mapped = numbers_of(moved(edges, long_affine_map(random)));
  return sights(mapped, edges.size()) == sights(subject.numbers(), edges.size())
             ? wrong
             : wrong + "others see each other under an affine map\n";
}

std::string radiosity_is_broken(const Subject& subject) {
  const testing_radiosity::ExactScene scene(oracle::to_scene(subject.edges()));
  testing_radiosity::BoundsCheck check;
  check.add(scene, scene.solve(), scene.scene().materials);
  return check.misses == 0 ? "" : check.first_miss + "\n";
}

std::string brute_force_differs(const Subject& subject) {
  oracle::ComparisonCounts counts;
  return oracle::disagreement(oracle::to_scene(subject.edges()), counts);
}

std::string brute_force_differs_in_elements(const Subject& subject) {
  std::mt19937_64 random(subject.chance());
  Scene2 scene = oracle::to_scene(subject.edges());
  for (Surface& surface : scene.surfaces) surface.elements = random() % 3 == 0 ? 2 : 1;
  oracle::ComparisonCounts counts;
  return oracle::disagreement(scene, counts, Granularity::kElement);
}

std::string brute_force_differs_in_groups(const Subject& subject) {
  oracle::ComparisonCounts counts;
  return oracle::disagreement(oracle::to_scene(subject.edges()), counts, Granularity::kGroup, oracle::Hidden::kYes);
}

}  // namespace

Subject::Subject(const Edges& edges, std::uint64_t chance) : edges_(edges), chance_(chance) {
  ExchangeRequest options;
  options.wants_measures = true;
  matrix_ = exact_exchange(prepare(oracle::to_scene(edges)), options, &report_);
  numbers_ = numbers_of(matrix_);
}

const std::vector<Law>& laws() {
  static const std::vector<Law> list{
      {"closure", closure_is_broken, 1},
      {"range", range_is_broken, 1},
      {"symmetry", symmetry_is_broken, 7},
      {"translation", translation_is_broken, 7},
      {"scaling", scaling_is_broken, 7},
      {"rotation", rotation_is_broken, 7},
      {"reflection", reflection_is_broken, 7},
      {"reversal", reversal_is_broken, 7},
      {"permutation", permutation_is_broken, 7},
      {"splitting", splitting_is_broken, 7},
      {"many digits", digits_are_broken, 11},
      {"elements", elements_are_broken, 31},
      {"convex room", convex_room_is_broken, 17},
      {"radiosity", radiosity_is_broken, 11},
      {"owners", owners_differ, 4},
      {"groups", groups_are_broken, 11},
      {"cut by hand", cut_by_hand_differs, 17},
      {"brute force", brute_force_differs, 17},
      {"brute force, elements", brute_force_differs_in_elements, 41},
      {"brute force, groups", brute_force_differs_in_groups, 31},
      {"repair", repair_is_broken, 19},
  };
  return list;
}

}  // namespace hottel::storm
