#include "solver/radiosity/direct_light.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

#include "geometry/name.h"
#include "geometry/unit_of_length.h"
#include "kernel/exact_double.h"
#include "kernel/support/failure.h"
#include "solver/radiosity/printed_number.h"

namespace hottel {
namespace {

using Channels = std::array<RationalEnclosure, 3>;

void add(const Enclosure& share, const Spectrum& power, Channels& sum) {
  if (share.upper == 0) return;
  const Rational lower = exact_value(share.lower), upper = exact_value(share.upper);
  for (std::size_t c = 0; c < 3; ++c) {
    sum[c].lower += lower * power.value[c];
    sum[c].upper += upper * power.value[c];
  }
}

// `what`: for the message where doubles cannot tell it.
SourceSpectrum rounded_outward(const Channels& sum, const Enclosure& area, bool is_scalar, const std::string& what) {
  std::array<Enclosure, 3> within;
  for (std::size_t c = 0; c < 3; ++c) {
    const Rational lower = sum[c].lower / exact_value(area.upper), upper = sum[c].upper / exact_value(area.lower);
    within[c] = {rounded_down(lower), rounded_up(upper)};
    if (!std::isfinite(within[c].upper)) throw RequestError(what + " is beyond the range of doubles");
  }
  return is_scalar ? SourceSpectrum::scalar(within[0]) : SourceSpectrum::of(within);
}

bool counts(const Enclosure& sky) { return sky.lower > 0 || sky.upper > 0x1p-64; }

Rational middle(const Enclosure& within) { return (exact_value(within.lower) + exact_value(within.upper)) / 2; }

// What the shares of a light lack of all of it.
Rational missing_share(const LightShares& shares) {
  if (!shares.solid.empty()) return 0;
  Rational rest = middle(shares.whole);
  for (const Enclosure& share : shares.of_element) rest -= exact_value(share.lower);
  if (counts(shares.sky)) rest -= middle(shares.sky);
  return rest;
}

// Whether it certainly lights no row. What a sun does is told by the check alone: at night it lights none.
bool is_useless_lamp(const ExchangeMatrix& matrix, const Light& light, const LightShares& shares) {
  if (light.is_sun() || light.power.is_zero() || shares.test != LightTest::kExact) return false;
  for (std::uint32_t i = 0; i < matrix.size(); ++i)
    if (matrix.has_row(i) && shares.of_element[i].upper > 0) return false;
  return true;
}

}  // namespace

std::map<std::uint32_t, std::array<RationalEnclosure, 3>> power_without_rows(const ExchangeMatrix& matrix,
                                                                             std::span<const Light> lights,
                                                                             std::span<const LightShares> shares) {
  HOTTEL_REQUIRE(lights.size() == shares.size());
  std::map<std::uint32_t, Channels> result;
  for (std::size_t k = 0; k < lights.size(); ++k) {
    HOTTEL_REQUIRE(shares[k].of_element.size() == matrix.size());
    for (std::uint32_t i = 0; i < matrix.size(); ++i)
      if (!matrix.has_row(i) && shares[k].of_element[i].upper > 0)
        add(shares[k].of_element[i], lights[k].power, result[i]);
    // The sky is what is left: where that may be nothing and is less than doubles tell of the rest, it counts as none.
    if (counts(shares[k].sky)) add(shares[k].sky, lights[k].power, result[matrix.sky()]);
  }
  return result;
}

void add_lights(const ExchangeMatrix& matrix, std::span<const Light> lights, std::span<const LightShares> shares,
                RadiositySources& sources) {
  HOTTEL_REQUIRE(lights.size() == shares.size());
  if (lights.empty()) return;
  bool is_scalar = true;
  for (const Light& light : lights) is_scalar &= light.power.is_scalar;
  sources.has_channels |= !is_scalar;
  sources.direct_irradiance.resize(matrix.size());
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    Channels sum;
    for (std::size_t k = 0; k < lights.size(); ++k) {
      HOTTEL_REQUIRE(shares[k].of_element.size() == matrix.size());
      add(shares[k].of_element[i], lights[k].power, sum);
    }
    if (sum == Channels()) continue;
    const Enclosure area = matrix.elements()[i].area.enclosure();
    if (area.lower > 0 &&
        std::isfinite(area.upper))  // else it has no radiosity that doubles can tell, and is refused by name
      sources.direct_irradiance[i] =
          rounded_outward(sum, area, is_scalar, "the light of lamps on '" + matrix.elements()[i].name + "'");
  }
  Channels absorbed, to_sky;
  for (const auto& [element, power] : power_without_rows(matrix, lights, shares)) {
    Channels& sum = element == matrix.sky() ? to_sky : absorbed;
    for (std::size_t c = 0; c < 3; ++c) {
      sum[c].lower += power[c].lower;
      sum[c].upper += power[c].upper;
    }
  }
  for (std::size_t k = 0; k < lights.size(); ++k)
    if (!shares[k].solid.empty()) add({1, 1}, lights[k].power, absorbed);
  for (std::size_t k = 0; k < lights.size(); ++k) {
    if (shares[k].test == LightTest::kExact) continue;
    const Rational missing = missing_share(shares[k]);
    for (std::size_t c = 0; c < 3; ++c) sources.besides.unaccounted[c] += missing * lights[k].power.value[c];
  }
  const Enclosure one{1, 1};
  const std::string what = "the power of lamps";
  sources.besides.absorbed = rounded_outward(absorbed, one, is_scalar, what);
  sources.besides.to_sky = rounded_outward(to_sky, one, is_scalar, what);
}

RadiositySources sources_of(const ExchangeMatrix& matrix, const SceneTable& scene,
                            std::span<const LightShares> lights) {
  require_told_lamps(scene);
  RadiositySources sources = sources_of(matrix, scene.materials, scene.sky_emission);
  add_lights(matrix, scene.lights, lights, sources);
  return sources;
}

std::string lost_light_text(const Light& light, const LightShares& shares) {
  return "light " + quoted_name(light.name) + " is in the solid " + quoted_name(shares.solid) +
         ": its power is lost there";
}

std::vector<std::string> lost_light_notes(const ExchangeMatrix& matrix, std::span<const Light> lights,
                                          std::span<const LightShares> shares) {
  std::vector<std::string> notes;
  for (std::size_t k = 0; k < shares.size(); ++k) {
    if (!shares[k].solid.empty())
      notes.push_back(lost_light_text(lights[k], shares[k]));
    else if (is_useless_lamp(matrix, lights[k], shares[k]))
      notes.push_back("light " + quoted_name(lights[k].name) +
                      " shines on no face with a material: its power goes to faces without one and to the sky");
  }
  return notes;
}

std::optional<std::string> estimated_light_note(std::span<const Light> lights, std::span<const LightShares> shares) {
  Rational power, missing;
  const LightShares* estimated = nullptr;
  for (std::size_t k = 0; k < shares.size(); ++k) {
    if (shares[k].test == LightTest::kExact) continue;
    estimated = &shares[k];
    const Spectrum& its = lights[k].power;
    const Rational all = its.is_scalar ? its.value[0] : Rational(its.value[0] + its.value[1] + its.value[2]);
    power += all * middle(shares[k].whole);
    missing += all * missing_share(shares[k]);
  }
  if (estimated == nullptr) return std::nullopt;
  const std::string defect =
      power == 0 ? ""
                 : fmt::format(", {:.3g} % of the power of the lights {}", 100 * std::fabs(to_double(missing / power)),
                               missing < 0 ? "too much" : "missing");
  return fmt::format(
      "what lights shine on first is an estimate (test: {}){}; the bounds are those of the radiosities of this light, "
      "and say nothing of the scene",
      to_string(estimated->test), defect);
}

}  // namespace hottel
