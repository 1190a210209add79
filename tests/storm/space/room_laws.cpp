#include "tests/storm/space/room_laws.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "geometry/space/exchange/exchange.h"
#include "kernel/support/failure.h"
#include "solver/radiosity/radiosity.h"
#include "tests/storm/space/room_patches.h"
#include "tests/storm/space/room_repair.h"

namespace hottel::storm {

namespace {

constexpr double kClosure = 1e-11;  // of rows within 1e-12
constexpr double kWarmth = 1e-9;    // of radiosities, of reflectivities up to 1/2
constexpr double kRounding = 1e-15;

ExchangeMatrix matrix_of(const PreparedScene3& prepared, double tolerance) {
  return exact_exchange(prepared, {.wants_measures = true, .tolerance = tolerance});
}

double area_of(const ExchangeMatrix& matrix, std::uint32_t i) { return matrix.elements()[i].area.value; }

std::string pair_text(const ExchangeMatrix& matrix, std::uint32_t i, const FactorEntry& entry) {
  return fmt::format("F({}, {}) = {:.17g}", matrix.name(i), matrix.name(entry.to), entry.factor.value);
}

}  // namespace

double error_of(const ExchangeMatrix& matrix, std::uint32_t i, std::size_t k, double tolerance) {
  if (matrix.guarantee(i, k) != Guarantee::kEstimated) return matrix.bounds(i, k).width();
  const FactorEntry& entry = matrix.row(i)[k];
  double smaller = area_of(matrix, i);
  if (entry.to != matrix.sky()) smaller = std::min(smaller, area_of(matrix, entry.to));
  return tolerance * smaller / area_of(matrix, i);
}

std::string rows_are_wrong(const ExchangeMatrix& matrix, double tolerance) {
  std::string wrong;
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    long double sum = 0, lower = 0, upper = 0, errors = 0;
    const auto row = matrix.row(i);
    for (std::size_t k = 0; k < row.size(); ++k) {
      const Enclosure bounds = matrix.bounds(i, k);
      sum += static_cast<long double>(row[k].factor.value);
      lower += static_cast<long double>(bounds.lower);
      upper += static_cast<long double>(bounds.upper);
      errors += static_cast<long double>(error_of(matrix, i, k, tolerance));
    }
    const double off = static_cast<double>(sum - 1), slack = kRounding * static_cast<double>(row.size());
    if (!(std::abs(off) <= static_cast<double>(errors) + slack))
      wrong +=
          fmt::format("row {} sums to 1 {:+.3g}, errors to {:.3g}\n", matrix.name(i), off, static_cast<double>(errors));
    if (tolerance <= kRoomTolerances3[1] && !(std::abs(off) <= kClosure))
      wrong += fmt::format("row {} sums to 1 {:+.3g}\n", matrix.name(i), off);
    if (!(static_cast<double>(lower - 1) <= slack && static_cast<double>(upper - 1) >= -slack))
      wrong += fmt::format("bounds of row {} sum to 1 {:+.3g} and 1 {:+.3g}\n", matrix.name(i),
                           static_cast<double>(lower - 1), static_cast<double>(upper - 1));
  }
  return wrong;
}
std::string radiosities_are_wrong(const ExchangeMatrix& matrix, const Scene3& scene) {
  const RadiositySolution solution = solve_radiosity(matrix, scene.materials, scene.sky_emission);
  std::string wrong;
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    const ElementRadiosity& e = solution.channels[0].elements[i];
    const double room = matrix.guarantee() == Guarantee::kEstimated ? kWarmth : 0;
    if (!(e.lower - room <= 1 && 1 <= e.upper + room && std::abs(e.radiosity - 1) <= kWarmth * 10))
      wrong += fmt::format("B({}) = 1 {:+.3g} in [1 {:+.3g}, 1 {:+.3g}]\n", matrix.name(i), e.radiosity - 1,
                           e.lower - 1, e.upper - 1);
  }
  return wrong;
}

namespace {

// Calls law(matrix, tolerance) for both.
template <class Law>
std::string of_both(const RoomSubject3& subject, const Law& law) {
  std::string wrong;
  for (const auto& [matrix, tolerance] :
       {std::pair(&subject.loose(), kRoomTolerances3[0]), std::pair(&subject.tight(), kRoomTolerances3[1])})
    if (const std::string what = law(*matrix, tolerance); !what.empty())
      wrong += fmt::format("within {:.0e}:\n", tolerance) + what;
  return wrong;
}

std::string measured_is_broken(const RoomSubject3& subject) {
  std::string wrong;
  for (std::size_t t = 0; t < 2; ++t)
    if (!subject.refusal(t).empty())
      wrong += fmt::format("within {:.0e}: {}\n", kRoomTolerances3[t], subject.refusal(t));
  return wrong;
}

std::string rows_are_broken(const RoomSubject3& subject) { return of_both(subject, rows_are_wrong); }

std::string backs_are_broken(const RoomSubject3& subject) {
  return of_both(subject, [](const ExchangeMatrix& matrix, double) {
    std::string wrong;
    for (std::uint32_t i = 0; i < matrix.size(); ++i)
      for (const FactorEntry& entry : matrix.row(i))
        if (entry.to != matrix.sky() && !matrix.elements()[entry.to].material)
          wrong += pair_text(matrix, i, entry) + "\n";
    return wrong;
  });
}

std::string range_is_wrong(const ExchangeMatrix& matrix, double tolerance) {
  std::string wrong;
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    const auto row = matrix.row(i);
    for (std::size_t k = 0; k < row.size(); ++k) {
      const double f = row[k].factor.value;
      const Enclosure bounds = matrix.bounds(i, k);
      if (!(f > 0 && f <= 1 + kClosure)) wrong += pair_text(matrix, i, row[k]) + "\n";
      if (!(row[k].visibility > 0 && row[k].visibility <= 1))
        wrong += pair_text(matrix, i, row[k]) + fmt::format(", Vis {:.17g}\n", row[k].visibility);
      if (!(0 <= bounds.lower && bounds.lower <= bounds.upper))
        wrong += pair_text(matrix, i, row[k]) + fmt::format(" in [{:.17g}, {:.17g}]\n", bounds.lower, bounds.upper);
      if (matrix.guarantee(i, k) == Guarantee::kEstimated) continue;
      if (!bounds.contains(f))
        wrong += pair_text(matrix, i, row[k]) + fmt::format(" in [{:.17g}, {:.17g}]\n", bounds.lower, bounds.upper);
      double smaller = area_of(matrix, i);
      if (row[k].to != matrix.sky()) smaller = std::min(smaller, area_of(matrix, row[k].to));
      if (!(bounds.width() <= 2.001 * tolerance * smaller / area_of(matrix, i) + 4e-16 * f))
        wrong += pair_text(matrix, i, row[k]) + fmt::format(" within {:.3g}\n", bounds.width() / 2);
    }
  }
  return wrong;
}
std::string range_is_broken(const RoomSubject3& subject) { return of_both(subject, range_is_wrong); }

std::string reciprocity_is_wrong(const ExchangeMatrix& matrix, double) {
  std::string wrong;
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    const auto row = matrix.row(i);
    for (std::size_t k = 0; k < row.size(); ++k) {
      const std::uint32_t j = row[k].to;
      if (j == matrix.sky() || !matrix.has_row(j)) continue;
      const auto back = matrix.row(j);
      const auto other = std::lower_bound(back.begin(), back.end(), i,
                                          [](const FactorEntry& entry, std::uint32_t to) { return entry.to < to; });
      if (other == back.end() || other->to != i) {
        wrong += pair_text(matrix, i, row[k]) + ": none from there\n";
        continue;
      }
      const auto l = static_cast<std::size_t>(other - back.begin());
      const double a = area_of(matrix, i), b = area_of(matrix, j);
      const double here = a * row[k].factor.value, there = b * other->factor.value;
      if (!(std::abs(here - there) <= kRounding * (here + there)))
        wrong += pair_text(matrix, i, row[k]) + fmt::format(": S = {:.17g}, from there {:.17g}\n", here, there);
      const Enclosure mine = matrix.bounds(i, k), its = matrix.bounds(j, l);
      if (!(a * mine.lower <= b * its.upper * (1 + kRounding) && b * its.lower <= a * mine.upper * (1 + kRounding)))
        wrong += pair_text(matrix, i, row[k]) + ": bounds have nothing in common\n";
      if (row[k].visibility != other->visibility)
        wrong += pair_text(matrix, i, row[k]) + ": Vis is another from there\n";
    }
  }
  return wrong;
}
std::string reciprocity_is_broken(const RoomSubject3& subject) { return of_both(subject, reciprocity_is_wrong); }

std::string verdicts_are_broken(const RoomSubject3& subject) {
  std::string wrong;
  const ExchangeMatrix &loose = subject.loose(), &tight = subject.tight();
  for (std::uint32_t i = 0; i < tight.size(); ++i) {
    const auto a = loose.row(i), b = tight.row(i);
    std::size_t k = 0, l = 0;
    while (k < a.size() || l < b.size()) {
      if (l == b.size() || (k < a.size() && a[k].to < b[l].to))
        wrong += pair_text(loose, i, a[k++]) + ", 0 within 1e-12\n";
      else if (k == a.size() || b[l].to < a[k].to)
        wrong += pair_text(tight, i, b[l++]) + ", 0 within 1e-9\n";
      else {
        if (b[l].to != tight.sky() && (a[k].visibility == 1) != (b[l].visibility == 1))
          wrong += pair_text(tight, i, b[l]) +
                   fmt::format(": Vis {:.17g}, within 1e-9 {:.17g}\n", b[l].visibility, a[k].visibility);
        ++k, ++l;
      }
    }
  }
  return wrong;
}

std::string values_are_broken(const RoomSubject3& subject) {
  std::string wrong;
  const ExchangeMatrix &loose = subject.loose(), &tight = subject.tight();
  for (std::uint32_t i = 0; i < tight.size(); ++i) {
    const auto a = loose.row(i), b = tight.row(i);
    for (std::size_t k = 0; k < a.size() && k < b.size() && a[k].to == b[k].to; ++k) {
      const double off = std::abs(a[k].factor.value - b[k].factor.value);
      const double errors = error_of(loose, i, k, kRoomTolerances3[0]) + error_of(tight, i, k, kRoomTolerances3[1]);
      if (!(off <= errors + kRounding * b[k].factor.value))
        wrong += pair_text(tight, i, b[k]) +
                 fmt::format(", within 1e-9 {:.17g}: off by {:.3g}, errors {:.3g}\n", a[k].factor.value, off, errors);
      const Enclosure x = loose.bounds(i, k), y = tight.bounds(i, k);
      if (!(std::max(x.lower, y.lower) <= std::min(x.upper, y.upper)))
        wrong += pair_text(tight, i, b[k]) + ": bounds have nothing in common\n";
    }
  }
  return wrong;
}

std::string radiosity_is_broken(const RoomSubject3& subject) {
  return of_both(subject,
                 [&](const ExchangeMatrix& matrix, double) { return radiosities_are_wrong(matrix, subject.scene()); });
}

Scene3 warm_scene(const SolidBodies3& bodies) {
  Scene3 scene = to_scene_3(bodies);
  for (Material& material : scene.materials) material.emission = Spectrum::scalar(1 - material.reflectivity.value[0]);
  scene.sky_emission = Spectrum::scalar(1);
  return scene;
}

}  // namespace

RoomSubject3::RoomSubject3(SolidBodies3 bodies, std::uint64_t chance)
    : bodies_(std::move(bodies)), chance_(chance), scene_(warm_scene(bodies_)) {
  validate(scene_);
  try {
    prepared_ = std::make_shared<const PreparedScene3>(prepare(scene_));
  } catch (const InputError&) {
    is_disputed_ = true;
    return;
  }
  for (std::size_t t = 0; t < 2; ++t) try {
      matrices_[t] = std::make_shared<const ExchangeMatrix>(matrix_of(*prepared_, kRoomTolerances3[t]));
    } catch (const RequestError& error) {
      refusals_[t] = error.what();
    }
}

const std::vector<RoomLaw3>& room_laws_3() {
  static const std::vector<RoomLaw3> laws{{"measured", measured_is_broken, 1, true},
                                          {"rows", rows_are_broken, 1},
                                          {"backs", backs_are_broken, 1},
                                          {"range", range_is_broken, 1},
                                          {"reciprocity", reciprocity_is_broken, 1},
                                          {"verdicts", verdicts_are_broken, 1},
                                          {"values", values_are_broken, 1},
                                          {"radiosity", radiosity_is_broken, 1},
                                          {"patches", room_patches_are_broken, 4},
                                          {"repair", room_repair_is_broken, 4}};
  return laws;
}

}  // namespace hottel::storm
