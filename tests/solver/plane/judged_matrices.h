// Scenes of the plane with their exact factors, and matrices that are these, changed on purpose.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "geometry/plane/exchange/exchange.h"
#include "geometry/plane/exchange/pair_alone.h"
#include "geometry/plane/generate/generators.h"
#include "io/scene/scene_json.h"
#include "solver/plane/compare/verdict.h"

namespace hottel {

// A room with no two walls alike, a scene that people live in, and clutter.
inline Scene2 convex_room() {
  return parse_scene_2(R"({"hottel": 1, "dimension": 2, "materials": {"white": {"reflectivity": 0.5}},
    "polylines": [{"name": "room", "points": [[0, 0], [0, 3], [2, 4], [5, 3], [4, 0]], "closed": true,
                   "material": "white"}]})",
                       "room.json");
}
inline Scene2 apartment() { return read_scene_2(std::string(HOTTEL_SOURCE_DIR) + "/scenes/showcase/apartment.json"); }
inline Scene2 clutter() { return generate_2({.kind = "clutter", .n = 60, .seed = 11}); }
inline Scene2 box_under_a_lamp() { return read_scene_2(std::string(HOTTEL_SOURCE_DIR) + "/tests/contract/box.json"); }

struct Judged {
  explicit Judged(Scene2 scene) : prepared(prepare(std::move(scene))), exact(exact_exchange(prepared)) {}

  // The matrix of value(from, to, exact factor), over all pairs of rows and columns.
  using Value = std::function<double(std::uint32_t, std::uint32_t, double)>;
  ExchangeMatrix changed(const Value& value) const {
    std::vector<std::size_t> begin(1, 0);
    std::vector<FactorEntry> entries;
    for (std::uint32_t i = 0; i < exact.size(); ++i) {
      for (std::uint32_t j = 0; j <= exact.sky() && exact.has_row(i); ++j)
        if (const double v = value(i, j, exact.factor(i, j).value); v != 0) entries.push_back({j, {v, 0}, 1});
      begin.push_back(entries.size());
    }
    return matrix(std::move(begin), std::move(entries));
  }

  // Of these entries, those of row i from begin[i].
  ExchangeMatrix matrix(std::vector<std::size_t> begin, std::vector<FactorEntry> entries) const {
    ExchangeMatrix result(exact.elements(), Guarantee::kEstimated);
    result.assign(std::move(begin), std::move(entries));
    return result;
  }

  // As it is, and as View3D prints it.
  Verdict judge_it(const Value& value, bool is_printed) const {
    VerdictOptions options;
    if (is_printed) options.written.digits = {6, 6, 0};
    return judge(prepared, exact, changed([&](std::uint32_t i, std::uint32_t j, double e) {
                   const double v = value(i, j, e);
                   return is_printed && v != 0 ? std::stod(fmt::format("{:.6f}", v)) : v;
                 }),
                 options);
  }
  std::string sentences(const Verdict& verdict) const {
    std::string text;
    for (const std::string& sentence : verdict_sentences(verdict, exact)) text += sentence + "\n";
    return text;
  }

  std::optional<FactorEntry> entry(std::uint32_t i, std::uint32_t j) const { return exact.row(i).find(j); }
  double vis(std::uint32_t i, std::uint32_t j) const { return entry(i, j) ? entry(i, j)->visibility : 0; }
  // Factor without obstacles.
  double free(std::uint32_t i, std::uint32_t j) const {
    if (const auto known = entry(i, j)) return known->factor.value / known->visibility;
    const RootSum sum = PairsAlone2(prepared, table, Granularity::kFace).exact(i, j);
    return sum.is_zero() ? 0 : round_quotient(sum, RootSum(Rational(1))).number.value / exact.elements()[i].area.value;
  }
  // A pair of faces with rows, of unequal areas and with a visibility that satisfies the condition.
  ElementPair pair_with(const std::function<bool(double)>& visibility) const {
    for (std::uint32_t i = 0; i < exact.size(); ++i)
      for (std::uint32_t j = 0; j < exact.size(); ++j)
        if (exact.has_row(i) && exact.has_row(j) && exact.factor(i, j).value > 0.01 && visibility(vis(i, j)) &&
            std::abs(exact.factor(i, j).value - exact.factor(j, i).value) > 0.01)
          return {i, j};
    throw std::runtime_error("no such pair");
  }

  PreparedScene2 prepared;
  ExchangeMatrix exact;
  ElementTable2 table{prepared.scene, prepared.arrangement, prepared.division, Granularity::kFace};
};

inline std::vector<Fault> faults(const Verdict& verdict) {
  std::vector<Fault> result;
  for (const FoundFault& finding : verdict.findings) result.push_back(finding.fault);
  return result;
}

}  // namespace hottel
