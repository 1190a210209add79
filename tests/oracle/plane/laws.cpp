#include "tests/oracle/plane/laws.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/oracle/plane/line_sweep.h"

namespace hottel::oracle {

namespace {

std::string name(const ElementPair& pair) {
  return "M(" + std::to_string(pair.first) + "," + std::to_string(pair.second) + ")";
}

}  // namespace

ExactSum measure(const ExactMeasures& measures, int f, int g) {
  const auto found = measures.find(std::minmax({f, g}));
  return found == measures.end() ? ExactSum() : found->second;
}

ExactMeasures measures_of(const std::vector<InputSegment>& edges) { return exact_measures(split(edges).pieces); }

std::vector<InputSegment> room(const mpq_class& size) {
  return {{0, 0, 0, size}, {0, size, size, size}, {size, size, size, 0}, {size, 0, 0, 0}};
}

std::string broken_integer_closure(const std::vector<Segment>& pieces) {
  std::string broken;
  for_each_gap(pieces, [&](const Gap& gap) {
    std::map<int, int> rows;
    for (const auto& [f, g, sign] : gap.terms) {
      rows[f] += sign;
      rows[g] += sign;
    }
    if (gap.is_covered) {
      rows[gap.left] -= 2;
      rows[gap.right] -= 2;
    }
    for (const auto& [label, sum] : rows)
      if (sum != 0) broken += "row " + std::to_string(label) + " of a gap is off by " + std::to_string(sum) + "\n";
  });
  return broken;
}

std::string broken_closure(const std::vector<Segment>& pieces) {
  std::map<int, ExactSum> defects;
  for (const Segment& s : pieces) {
    const mpq_class x = s.bx - s.ax, y = s.by - s.ay;
    for (const int label : {s.left, s.right}) defects[label].add(-2, x * x + y * y);
  }
  for (const auto& [pair, sum] : exact_measures(pieces)) {
    if (pair.first != kInfinity) defects[pair.first] += sum;
    if (pair.second != kInfinity && pair.second != pair.first) defects[pair.second] += sum;
  }
  std::string broken;
  for (const auto& [label, defect] : defects)
    if (!(defect == ExactSum())) broken += "row " + std::to_string(label) + " is off by " + defect.to_string() + "\n";
  return broken;
}

std::string broken_positivity(const std::vector<Segment>& pieces) {
  std::string broken;
  for (const auto& [pair, sum] : exact_measures(pieces))
    if (sum.value(1024) <= 0) broken += name(pair) + " = " + sum.to_string() + "\n";
  return broken;
}

std::string broken_sweep(const std::vector<Segment>& pieces, double tolerance) {
  const ExactMeasures exact = exact_measures(pieces);
  std::map<ElementPair, double> swept = line_sweep(pieces);
  for (const auto& entry : exact) swept.try_emplace(entry.first, 0.0);
  std::string broken;
  for (const auto& [pair, value] : swept) {
    const ExactSum sum = measure(exact, pair.first, pair.second);
    if (std::abs(sum.to_double() - value) > tolerance)
      broken += name(pair) + " = " + sum.to_string() + ", swept " + std::to_string(value) + "\n";
  }
  return broken;
}

}  // namespace hottel::oracle
