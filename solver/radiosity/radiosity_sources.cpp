#include "solver/radiosity/radiosity_sources.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "kernel/exact_double.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

RationalEnclosure rational(const Enclosure& within) {
  HOTTEL_REQUIRE(std::isfinite(within.lower) && std::isfinite(within.upper));
  return {exact_value(within.lower), exact_value(within.upper)};
}

Rational number_at(const RationalEnclosure& within, End end) {
  switch (end) {
    case End::kLower:
      return within.lower;
    case End::kMiddle:
      return within.is_exact() ? within.lower : Rational((within.lower + within.upper) / 2);
    case End::kUpper:
      return within.upper;
  }
  return within.upper;
}

}  // namespace

SourceSpectrum::SourceSpectrum(Numbers numbers) {
  for (const RationalEnclosure& number : numbers.value)
    HOTTEL_REQUIRE(number.lower >= 0 && number.lower <= number.upper);
  numbers_ = std::make_shared<const Numbers>(std::move(numbers));
}

SourceSpectrum::SourceSpectrum(const Spectrum& exact)
    : SourceSpectrum(Numbers{
          {{exact.value[0], exact.value[0]}, {exact.value[1], exact.value[1]}, {exact.value[2], exact.value[2]}},
          exact.is_scalar}) {}

SourceSpectrum SourceSpectrum::scalar(const Enclosure& within) {
  return SourceSpectrum(Numbers{{rational(within)}, true});
}

SourceSpectrum SourceSpectrum::of(const std::array<Enclosure, 3>& within) {
  return SourceSpectrum(Numbers{{rational(within[0]), rational(within[1]), rational(within[2])}, false});
}

SourceSpectrum SourceSpectrum::of(const std::array<RationalEnclosure, 3>& within) {
  return SourceSpectrum(Numbers{{within.begin(), within.end()}, false});
}

const RationalEnclosure& SourceSpectrum::operator[](int channel) const {
  static const RationalEnclosure zero;
  if (!numbers_) return zero;
  return numbers_->value.size() == 1 ? numbers_->value.front() : numbers_->value[static_cast<std::size_t>(channel)];
}

SourceSpectrum SourceSpectrum::at(End end) const {
  if (!numbers_ ||
      std::all_of(numbers_->value.begin(), numbers_->value.end(), [](const auto& n) { return n.is_exact(); }))
    return *this;
  Numbers result{{}, numbers_->is_scalar};
  for (const RationalEnclosure& within : numbers_->value) {
    const Rational number = number_at(within, end);
    result.value.push_back({number, number});
  }
  return SourceSpectrum(std::move(result));
}

bool operator==(const SourceSpectrum& a, const SourceSpectrum& b) {
  return a.is_scalar() == b.is_scalar() && a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

RadiositySources RadiositySources::at(End end) const {
  RadiositySources result = without_numbers();
  result.sky = sky.at(end);
  result.besides = {besides.absorbed.at(end), besides.to_sky.at(end), besides.unaccounted};
  std::unordered_map<const RationalEnclosure*, SourceSpectrum> known;  // elements of one material share their numbers
  const auto add = [&](const std::vector<SourceSpectrum>& from, std::vector<SourceSpectrum>& to) {
    to.reserve(from.size());
    for (const SourceSpectrum& spectrum : from) {
      const auto place = known.try_emplace(&spectrum[0]);
      if (place.second) place.first->second = spectrum.at(end);
      to.push_back(place.first->second);
    }
  };
  add(emission, result.emission);
  add(direct_irradiance, result.direct_irradiance);
  add(withdrawn, result.withdrawn);
  return result;
}

RadiositySources RadiositySources::withdrawn_alone(bool in_channels) const {
  RadiositySources result = without_numbers();
  result.emission = withdrawn;
  result.has_channels = in_channels;
  return result;
}

RadiositySources RadiositySources::without_numbers() const {
  RadiositySources result;
  result.has_channels = has_channels;
  result.has_bands = has_bands;
  result.keeps_gains = keeps_gains;
  result.only_channel = only_channel;
  result.has_given_fluxes = has_given_fluxes;
  return result;
}

RadiositySources sources_of(const ExchangeMatrix& matrix, const std::vector<Material>& materials,
                            const Spectrum& sky_emission) {
  RadiositySources result;
  std::vector<SourceSpectrum> of_material, withdrawn(materials.size());  // by material
  for (const Material& material : materials) {
    Spectrum supplied = material.emission, taken{{}, supplied.is_scalar};
    for (std::size_t c = 0; c < 3; ++c)
      if (supplied.value[c] < 0) {
        taken.value[c] = -supplied.value[c];
        supplied.value[c] = 0;
      }
    of_material.emplace_back(supplied);
    if (!taken.is_zero()) withdrawn[of_material.size() - 1] = taken;
    result.has_channels |= !material.emission.is_scalar;
    result.has_bands |= material.has_bands;
  }
  if (result.has_bands) result.keeps_gains.resize(matrix.size());
  result.emission.resize(matrix.size());
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    const std::uint32_t material = *matrix.elements()[i].material;
    HOTTEL_REQUIRE(material < materials.size());
    result.emission[i] = of_material[material];
    result.has_given_fluxes |= materials[material].has_given_flux();
    if (result.has_bands) result.keeps_gains[i] = materials[material].keeps_gains();
    if (materials[material].thermal(materials[material].emission) >= 0) continue;
    result.withdrawn.resize(matrix.size());
    result.withdrawn[i] = withdrawn[material];
  }
  result.sky = sky_emission;
  return result;
}

std::vector<Spectrum> reflectivities_of(const std::vector<Material>& materials) {
  std::vector<Spectrum> result;
  for (const Material& material : materials) result.push_back(material.reflectivity);
  return result;
}

std::vector<Rational> in_channel(const std::vector<Spectrum>& spectra, int channel) {
  std::vector<Rational> result;
  for (const Spectrum& spectrum : spectra) result.push_back(spectrum.value[static_cast<std::size_t>(channel)]);
  return result;
}

}  // namespace hottel
