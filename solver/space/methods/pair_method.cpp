#include "solver/space/methods/pair_method.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include "kernel/plain_functions.h"
#include "kernel/support/parallel.h"

namespace hottel {
namespace {

// Directions over a patch: a spiral with equal steps of the square of the sine, by the golden angle.
constexpr int kDirections = 256;

bool sees_open_space(const SegmentVisibility3& visibility, const ElementPatch3& patch) {
  const Vector3d along = 1 / length(patch.corners[1] - patch.corners[0]) * (patch.corners[1] - patch.corners[0]);
  const Vector3d across = cross(patch.normal, along);
  for (int k = 0; k < kDirections; ++k) {
    const double square = (k + 0.5) / kDirections, turn = k * std::numbers::pi * (3 - std::sqrt(5.0));
    const double sine = std::sqrt(square), cosine = std::sqrt(1 - square);
    if (visibility.sees_sky(centre_point(patch), cosine * patch.normal + sine * same_bits::cos(turn) * along +
                                                     sine * same_bits::sin(turn) * across))
      return true;
  }
  return false;
}

std::vector<char> open_elements(const ElementGeometry3& geometry, const SegmentVisibility3& visibility) {
  std::vector<char> is_open(geometry.count(), 0);
  parallel_for(is_open.size(), [&](std::size_t k) {
    const auto element = static_cast<std::uint32_t>(k);
    if (!geometry.has_row(element)) return;
    for (const ElementPatch3& patch : geometry.patches(element))
      if (sees_open_space(visibility, patch)) is_open[element] = 1;
  });
  return is_open;
}

}  // namespace

PairsOfElements PairMethod3::pairs_and_contacts(const Setting& setting) const {
  const auto contact = [&geometry = setting.geometry](std::uint32_t i,
                                                      std::uint32_t j) -> const ElementGeometry3::Contact* {
    const auto contacts = geometry.contacts(i);
    const auto found =
        std::find_if(contacts.begin(), contacts.end(), [j](const ElementGeometry3::Contact& c) { return c.to == j; });
    return found == contacts.end() ? nullptr : &*found;
  };
  const PairsOfElements seen = pairs(setting);
  return {.append_partners =
              [seen, &geometry = setting.geometry](std::uint32_t i, std::vector<std::uint32_t>& partners) {
                seen.append_partners(i, partners);
                for (const ElementGeometry3::Contact& c : geometry.contacts(i)) partners.push_back(c.to);
              },
          .factors = [seen, contact](std::uint32_t i, std::uint32_t j) -> PairFactors {
            const ElementGeometry3::Contact* const forth = contact(i, j);
            return forth == nullptr ? seen.factors(i, j) : PairFactors{forth->factor, contact(j, i)->factor};
          }};
}

ExchangeMatrix PairMethod3::compute_elements(const PreparedScene3& prepared,
                                             const std::function<void(double)>& progress, MethodReport& report) const {
  const ElementGeometry3 geometry(prepared);
  const SegmentVisibility3 visibility(prepared.occluders());
  return matrix_of_pairs({.elements = geometry.table().elements(),
                          .has_row = [&geometry](std::uint32_t i) { return geometry.has_row(i); },
                          .is_open = open_elements(geometry, visibility)},
                         pairs_and_contacts({prepared, geometry, visibility}), progress, report);
}

ExchangeMethod3::FactorsOfPairs PairMethod3::factors_of_pairs(const PreparedScene3& prepared) const {
  struct Known {
    explicit Known(const PreparedScene3& of) : geometry(of), visibility(of.occluders()) {}
    ElementGeometry3 geometry;
    SegmentVisibility3 visibility;
  };
  const auto known = std::make_shared<const Known>(prepared);
  return one_way(pairs_and_contacts({prepared, known->geometry, known->visibility}), known);
}

// The sky of an element of which no direction was found to be free is not what the others leave.
ExchangeMethod3::ClaimedErrors PairMethod3::claimed_errors(const PreparedScene3& prepared) const {
  if (!rule_) return ElementMethod3::claimed_errors(prepared);
  const ElementGeometry3 geometry(prepared);
  const std::vector<char> is_open = open_elements(geometry, SegmentVisibility3(prepared.occluders()));
  const bool is_closed = prepared.scene.closed;
  return [claims = quadrature_claims_3(prepared, *rule_), sky = geometry.table().sky(), is_open, is_closed](
             std::uint32_t from, std::uint32_t to) {
    if (to == sky && !is_open[from] && !is_closed) return std::numeric_limits<double>::infinity();
    return claims(from, to);
  };
}

std::optional<double> PairMethod3::declared_error(const PreparedScene3& prepared) const {
  if (!rule_) return std::nullopt;
  const std::optional<double> claim = quadrature_claim_3(prepared, *rule_);
  if (!claim) return std::nullopt;
  const ElementGeometry3 geometry(prepared);
  const std::vector<char> is_open = open_elements(geometry, SegmentVisibility3(prepared.occluders()));
  for (std::uint32_t i = 0; i < geometry.count(); ++i)
    if (geometry.has_row(i) && !is_open[i] && !prepared.scene.closed) return std::nullopt;
  return claim;
}

std::function<void(std::uint32_t, std::vector<std::uint32_t>&)> all_later_elements(const ElementGeometry3& geometry) {
  return [&geometry](std::uint32_t i, std::vector<std::uint32_t>& partners) {
    for (std::uint32_t j = i + 1; j < geometry.count(); ++j) partners.push_back(j);
  };
}

}  // namespace hottel
