#include "solver/radiosity/direct_light.h"

#include <array>
#include <cmath>
#include <utility>

#include "geometry/name.h"
#include "kernel/support/failure.h"
#include "solver/radiosity/printed_number.h"

namespace hottel {
namespace {

using Channels = std::array<RationalEnclosure, 3>;

void add(const Enclosure& share, const Spectrum& power, Channels& sum) {
  if (share.upper == 0) return;
  const Rational lower(share.lower), upper(share.upper);
  for (std::size_t c = 0; c < 3; ++c) {
    sum[c].lower += lower * power.value[c];
    sum[c].upper += upper * power.value[c];
  }
}

// `what`: for the message where doubles cannot tell it.
SourceSpectrum rounded_outward(const Channels& sum, const Enclosure& area, bool is_scalar, const std::string& what) {
  std::array<Enclosure, 3> within;
  for (std::size_t c = 0; c < 3; ++c) {
    const Rational lower = sum[c].lower / Rational(area.upper), upper = sum[c].upper / Rational(area.lower);
    within[c] = {rounded_down(lower), rounded_up(upper)};
    if (!std::isfinite(within[c].upper)) throw RequestError(what + " is beyond the range of doubles");
  }
  return is_scalar ? SourceSpectrum::scalar(within[0]) : SourceSpectrum::of(within);
}

}  // namespace

void add_lights(const ExchangeMatrix& matrix, std::span<const Light> lights, std::span<const LightShares> shares,
                RadiositySources& sources) {
  HOTTEL_REQUIRE(lights.size() == shares.size());
  if (lights.empty()) return;
  bool is_scalar = true;
  for (const Light& light : lights) is_scalar &= light.power.is_scalar;
  sources.has_channels |= !is_scalar;
  sources.direct_irradiance.resize(matrix.size());
  Channels absorbed, to_sky;
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    Channels sum;
    for (std::size_t k = 0; k < lights.size(); ++k) {
      HOTTEL_REQUIRE(shares[k].of_element.size() == matrix.size());
      add(shares[k].of_element[i], lights[k].power, matrix.has_row(i) ? sum : absorbed);
    }
    if (!matrix.has_row(i) || sum == Channels()) continue;
    const Enclosure area = matrix.elements()[i].area.enclosure();
    if (area.lower > 0)  // else it has no radiosity that doubles can tell, and is refused by name
      sources.direct_irradiance[i] =
          rounded_outward(sum, area, is_scalar, "the light of lamps on '" + matrix.elements()[i].name + "'");
  }
  for (std::size_t k = 0; k < lights.size(); ++k) {
    // The sky is what is left: where that may be nothing and is less than doubles tell of the rest, it counts as none.
    const Enclosure& sky = shares[k].sky;
    if (sky.lower > 0 || sky.upper > 0x1p-64) add(sky, lights[k].power, to_sky);
    if (!shares[k].solid.empty()) add({1, 1}, lights[k].power, absorbed);
  }
  const Enclosure one{1, 1};
  const std::string what = "the power of lamps";
  sources.besides = {rounded_outward(absorbed, one, is_scalar, what), rounded_outward(to_sky, one, is_scalar, what)};
}

RadiositySources sources_of(const ExchangeMatrix& matrix, const SceneTable& scene,
                            std::span<const LightShares> lights) {
  RadiositySources sources = sources_of(matrix, scene.materials, scene.sky_emission);
  add_lights(matrix, scene.lights, lights, sources);
  return sources;
}

std::string lost_light_text(const Light& light, const LightShares& shares) {
  return "light " + quoted_name(light.name) + " is in the solid " + quoted_name(shares.solid) +
         ": its power is lost there";
}

std::vector<std::string> lost_light_notes(std::span<const Light> lights, std::span<const LightShares> shares) {
  std::vector<std::string> notes;
  for (std::size_t k = 0; k < shares.size(); ++k)
    if (!shares[k].solid.empty()) notes.push_back(lost_light_text(lights[k], shares[k]));
  return notes;
}

}  // namespace hottel
