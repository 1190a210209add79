#include "tests/storm/plane/solid_laws.h"

#include <fmt/core.h>

#include <cmath>
#include <map>
#include <random>
#include <set>

#include "tests/comparison/plane/engine_comparison.h"

namespace hottel::storm {

namespace {

using oracle::InputSegment;

ExchangeMatrix group_matrix(const Edges& edges, ExchangeReport* report = nullptr) {
  return exact_exchange(prepare(oracle::to_scene(edges)), {.granularity = Granularity::kGroup}, report);
}

// The same edges, each group with materials and something behind it at random.
Edges with_other_claims(Edges edges, std::uint64_t chance) {
  std::mt19937_64 random(chance);
  const auto below = [&](std::uint64_t count) { return static_cast<int>(random() % count); };
  for (const std::vector<std::size_t>& group : oracle::groups_of(edges)) {
    const int front = random() % 4 == 0 ? below(3) : 0, back = random() % 4 == 0 ? below(3) : -1;
    const auto behind = random() % 3 == 0 ? static_cast<oracle::Behind>(below(3)) : oracle::Behind::kNothingSaid;
    for (const std::size_t k : group) {
      edges[k].front_material = front;
      edges[k].back_material = back;
      edges[k].behind = behind;
    }
  }
  return edges;
}

std::string rows_are_broken(const ExchangeMatrix& matrix) {
  std::string wrong;
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    double sum = 0;
    for (const auto& [to, factor, visibility] : matrix.row(i)) {
      sum += factor.value;
      if (!(factor.value > 0 && factor.value <= 1 && visibility > 0 && visibility <= 1))
        wrong += fmt::format("group F({}, {}) = {}, Vis = {}\n", i, to, factor.value, visibility);
    }
    if (matrix.has_row(i) && std::abs(sum - 1) > 0x1p-53 * static_cast<double>(2 * matrix.row(i).size()))
      wrong += fmt::format("group row {} sums to {:.17g}\n", i, sum);
  }
  return wrong;
}

}  // namespace

std::string owners_differ(const Subject& subject) {
  const oracle::Cut cut = oracle::cut(subject.edges());
  const auto differs_in = [&](const Edges& edges) {
    return oracle::verdict_differs(oracle::to_scene(edges), oracle::split(edges, cut));
  };
  const std::string wrong = differs_in(subject.edges());
  if (!wrong.empty()) return wrong;
  const Edges other = with_other_claims(subject.edges(), subject.chance());
  const std::string differs = differs_in(other);
  if (differs.empty()) return "";
  std::string claims = "with other claims:";
  for (const InputSegment& edge : other)
    claims += fmt::format(" {}/{}/{}", edge.front_material, edge.back_material, static_cast<int>(edge.behind));
  return claims + "\n" + differs;
}

std::string groups_are_broken(const Subject& subject) {
  const Edges& edges = subject.edges();
  ExchangeReport report;
  const ExchangeMatrix matrix = group_matrix(edges, &report);
  std::string wrong = report.closure_is_exact ? "" : "rows of groups do not close as integers\n";
  wrong += rows_are_broken(matrix);

  const oracle::Groups groups = oracle::groups_of(edges);
  std::vector<std::uint32_t> group_of(edges.size());
  for (std::uint32_t g = 0; g < groups.size(); ++g)
    for (const std::size_t k : groups[g]) group_of[k] = g;
  const std::uint32_t sky = subject.matrix().sky();
  const auto label = [&](std::uint32_t i) { return i == sky ? matrix.sky() : 2 * group_of[i / 2] + i % 2; };
  const auto is_single = [&](std::uint32_t i) { return i == matrix.sky() || groups[i / 2].size() == 1; };
  Numbers of_faces;
  std::set<std::pair<std::uint32_t, std::uint32_t>> seen;
  for (const auto& [pair, number] : subject.numbers()) {
    const std::pair<std::uint32_t, std::uint32_t> of_groups{label(pair.first), label(pair.second)};
    seen.insert(of_groups);
    if (is_single(of_groups.first) && is_single(of_groups.second)) of_faces[of_groups] = number;
  }
  const Numbers numbers = numbers_of(matrix);
  Numbers of_single_groups;
  for (const auto& [pair, number] : numbers) {
    if (seen.erase(pair) == 0)
      wrong += fmt::format("groups {} and {} see each other, but no faces\n", pair.first, pair.second);
    if (is_single(pair.first) && is_single(pair.second)) of_single_groups.emplace(pair, number);
  }
  for (const auto& pair : seen)
    wrong += fmt::format("faces of groups {} and {} see each other\n", pair.first, pair.second);
  wrong += difference(of_faces, of_single_groups);

  const mpq_class east = (mpq_class(1) << 53) + 1, north = -(mpq_class(1) << 60) + 7;
  const Edges far = moved(edges, [&](mpq_class& x, mpq_class& y) {
    x += east;
    y += north;
  });
  return wrong + difference(numbers, numbers_of(group_matrix(far)));
}

std::string cut_by_hand_differs(const Subject& subject) {
  const Edges& edges = subject.edges();
  std::map<int, Edges> sides;  // by face: the parts of it that it owns, front on the right
  for (const oracle::Segment& piece : oracle::split(edges).pieces)
    for (const bool left : {true, false}) {
      const int label = left ? piece.left : piece.right;
      if (label == oracle::kCovered) continue;
      const InputSegment& edge = edges[static_cast<std::size_t>(label / 2)];
      InputSegment side{piece.ax, piece.ay, piece.bx, piece.by};
      if (left) {
        std::swap(side.ax, side.bx);
        std::swap(side.ay, side.by);
      }
      // A black back is a face of its own here, so that what it takes in can be compared; only its own row is new.
      side.front_material = std::max(0, label % 2 == 0 ? edge.front_material : edge.back_material);
      side.group = label;
      sides[label].push_back(side);
    }
  Edges cut;
  std::vector<std::uint32_t> faces;  // by group of the cut scene
  for (const auto& [label, parts] : sides) {
    cut.insert(cut.end(), parts.begin(), parts.end());
    faces.push_back(static_cast<std::uint32_t>(label));
  }
  Numbers numbers;
  const ExchangeMatrix matrix = group_matrix(cut);
  for (const auto& [pair, number] : numbers_of(matrix)) {
    if (pair.first % 2 == 1 || (pair.second != matrix.sky() && pair.second % 2 == 1)) return "a back sees something\n";
    const std::uint32_t to = pair.second == matrix.sky() ? subject.matrix().sky() : faces[pair.second / 2];
    if (const std::uint32_t from = faces[pair.first / 2]; subject.matrix().has_row(from)) numbers[{from, to}] = number;
  }
  return difference(subject.numbers(), numbers);
}

}  // namespace hottel::storm
