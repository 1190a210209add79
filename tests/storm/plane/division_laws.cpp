#include "tests/storm/plane/division_laws.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "geometry/plane/exchange/closed_forms.h"
#include "geometry/plane/exchange/exchange.h"
#include "geometry/scene_names.h"
#include "tests/comparison/plane/engine_comparison.h"
#include "tests/storm/plane/long_map.h"

namespace hottel::storm {

namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;

void divide(Scene2& scene, std::mt19937_64& random) {
  for (Surface& surface : scene.surfaces) surface.elements = 1 + static_cast<std::uint32_t>(random() % 4);
}

// The face of an element, or the sky, in the scene that is not divided.
std::uint32_t face_of(const ExchangeMatrix& parts, std::uint32_t element, std::uint32_t sky) {
  if (element == parts.sky()) return sky;
  const Element& e = parts.elements()[element];
  return Face{e.surface, e.is_back}.number();
}

// What is printed: the doubles of the elements add up to the double of the face, as far as each is rounded.
std::string printed_sums_differ(const ExchangeMatrix& whole, const ExchangeMatrix& parts) {
  struct Sum {
    double value = 0;
    int count = 0;
  };
  std::map<Pair, Sum> sums;
  for (std::uint32_t i = 0; i < parts.size(); ++i)
    for (std::size_t k = 0; k < parts.row(i).size(); ++k) {
      Sum& sum = sums[{face_of(parts, i, whole.sky()), face_of(parts, parts.row(i)[k].to, whole.sky())}];
      sum.value += parts.measures(i)[k];
      ++sum.count;
    }
  std::string wrong;
  std::size_t entries = 0;
  for (std::uint32_t i = 0; i < whole.size(); ++i)
    for (std::size_t k = 0; k < whole.row(i).size(); ++k) {
      ++entries;
      const Sum& sum = sums[{i, whole.row(i)[k].to}];
      const double measure = whole.measures(i)[k];
      if (!(std::abs(sum.value - measure) <= 0x1p-53 * (2 * sum.count + 1) * measure))
        wrong += fmt::format("S({}, {}) = {:.17g}, of its {} pairs of elements {:.17g}\n", i, whole.row(i)[k].to,
                             measure, sum.count, sum.value);
    }
  if (sums.size() != entries) wrong += "elements of faces that see nothing of each other do\n";
  return wrong;
}

// What is behind it, as exact sums.
std::string exact_sums_differ(const Subject& subject, const PreparedScene2& divided, const ExchangeMatrix& parts) {
  const auto pairs_of = [](const ExchangeMatrix& matrix) {
    std::vector<ElementPair> pairs;
    for (std::uint32_t i = 0; i < matrix.size(); ++i)
      for (std::uint32_t j = i; j <= matrix.sky(); ++j)
        if (matrix.has_row(i) || (j < matrix.sky() && matrix.has_row(j))) pairs.emplace_back(i, j);
    return pairs;
  };
  std::map<Pair, RootSum> sums;
  const std::vector<ElementPair> pairs = pairs_of(parts), faces = pairs_of(subject.matrix());
  const std::vector<RootSum> measures = exact_exchange_measures(divided, Granularity::kElement, pairs);
  const std::uint32_t sky = subject.matrix().sky();
  for (std::size_t k = 0; k < pairs.size(); ++k)
    sums[std::minmax({face_of(parts, pairs[k].first, sky), face_of(parts, pairs[k].second, sky)})] += measures[k];
  const std::vector<RootSum> expected =
      exact_exchange_measures(prepare(oracle::to_scene(subject.edges())), Granularity::kFace, faces);
  std::string wrong;
  for (std::size_t k = 0; k < faces.size(); ++k)
    if (!(sums[faces[k]] - expected[k]).is_zero())
      wrong += fmt::format("S({}, {}) = {}, its elements {}\n", faces[k].first, faces[k].second,
                           expected[k].to_string(), sums[faces[k]].to_string());
  return wrong;
}

struct Corner {
  mpq_class x, y;
  bool operator<(const Corner& other) const { return x != other.x ? x < other.x : y < other.y; }
};

mpq_class turn(const Corner& a, const Corner& b, const Corner& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// The convex hull of all ends, clockwise, with every end on it; nothing when all are on one line.
std::vector<Corner> hull(const Edges& edges) {
  std::set<Corner> ends;
  for (const oracle::InputSegment& edge : edges) ends.insert({{edge.ax, edge.ay}, {edge.bx, edge.by}});
  std::vector<Corner> result;
  bool is_flat = true;
  const auto chain = [&](auto from, auto to) {
    const std::size_t begin = result.size();
    for (auto corner = from; corner != to; ++corner) {
      while (result.size() >= begin + 2 && turn(*std::prev(result.end(), 2), result.back(), *corner) > 0)
        result.pop_back();
      is_flat = is_flat && (result.size() < begin + 2 || turn(result[begin], result[begin + 1], *corner) == 0);
      result.push_back(*corner);
    }
    result.pop_back();  // begins the next
  };
  chain(ends.begin(), ends.end());
  chain(ends.rbegin(), ends.rend());
  return is_flat ? std::vector<Corner>() : result;
}

// The room with those corners, some of its walls in two pieces on one line.
Edges room_with(const std::vector<Corner>& corners, std::mt19937_64& random) {
  Edges room;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Corner &a = corners[k], &b = corners[(k + 1) % corners.size()];
    oracle::InputSegment wall{a.x, a.y, b.x, b.y, static_cast<int>(random() % 3), -1};
    if (random() % 4 == 0) {
      mpq_class t(1 + random() % 6, 7);
      oracle::InputSegment first = wall;
      first.bx = wall.ax = a.x + t * (b.x - a.x);
      first.by = wall.ay = a.y + t * (b.y - a.y);
      room.push_back(first);
    }
    room.push_back(wall);
  }
  return room;
}

}  // namespace

std::string elements_are_broken(const Subject& subject) {
  std::mt19937_64 random(subject.chance());
  Scene2 scene = oracle::to_scene(subject.edges());
  divide(scene, random);
  const PreparedScene2 divided = prepare(std::move(scene), Divided2::kYes);
  ExchangeRequest options;
  options.granularity = Granularity::kElement;
  options.wants_measures = true;
  const ExchangeMatrix parts = exact_exchange(divided, options);
  return printed_sums_differ(subject.matrix(), parts) + exact_sums_differ(subject, divided, parts);
}

std::string convex_room_is_broken(const Subject& subject) {
  const std::vector<Corner> corners = hull(subject.edges());
  if (corners.empty()) return "";
  std::mt19937_64 random(subject.chance());
  Edges room = room_with(corners, random);
  if (random() % 2 == 0) room = moved(std::move(room), long_similarity(random, random() % 2 == 0));
  Scene2 scene = oracle::to_scene(room);
  divide(scene, random);
  if (!is_convex_room(scene)) return "a convex room is not taken for one\n";
  std::string wrong;
  for (const Granularity granularity : {Granularity::kFace, Granularity::kElement}) {
    const PreparedScene2 prepared =
        prepare(scene, granularity == Granularity::kElement ? Divided2::kYes : Divided2::kNo);
    ExchangeRequest request{.granularity = granularity, .always_sweeps = true};
    const Numbers swept = numbers_of(exact_exchange(prepared, request));
    request.always_sweeps = false;
    wrong += difference(swept, numbers_of(exact_exchange(prepared, request)));
  }
  return wrong;
}

}  // namespace hottel::storm
