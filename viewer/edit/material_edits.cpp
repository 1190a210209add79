#include "viewer/edit/material_edits.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "kernel/decimal.h"
#include "kernel/support/failure.h"
#include "viewer/edit/decimals.h"
#include "viewer/edit/typed_numbers.h"

namespace hottel {
namespace {

constexpr std::array<std::string_view, 5> kEdits{"less reflectivity", "more reflectivity", "less emission",
                                                 "more emission", "colour"};

// Paints, at a lightness near that of plaster.
const std::array<Spectrum, 6>& paints() {
  const auto colour = [](int r, int g, int b) {
    return Spectrum{{Rational(r) / 100, Rational(g) / 100, Rational(b) / 100}, false};
  };
  static const std::array<Spectrum, 6> kPaints{Spectrum::scalar(Rational(4) / 5),
                                               colour(80, 36, 24),
                                               colour(82, 70, 34),
                                               colour(42, 64, 40),
                                               colour(34, 50, 76),
                                               colour(58, 38, 64)};
  return kPaints;
}

// The paint after one; the first after what is none.
const Spectrum& paint_after(const Spectrum& paint) {
  const auto& all = paints();
  const auto found = std::ranges::find(all, paint);
  return found == all.end() || found + 1 == all.end() ? all[0] : *(found + 1);
}

// The colour of a paint, as strong as something that is not 0.
Spectrum in_colour(const Spectrum& paint, const Spectrum& quantity) {
  const Rational most = *std::ranges::max_element(quantity.value), lightest = *std::ranges::max_element(paint.value);
  Spectrum coloured = paint;
  for (Rational& value : coloured.value) value *= most / lightest;
  return coloured;
}

// What was a net flux below 0 is no emission; of two bands there are two values.
void drop_void_flux(Material& material) {
  for (Spectrum* spectrum : {&material.reflectivity, &material.emission})
    if (material.has_bands) *spectrum = in_bands(spectrum->value[kSolarBand], spectrum->value[kThermalBand]);
  if (!material.has_given_flux() && material.thermal(material.emission) < 0)
    material.emission = material.has_bands ? in_bands(material.emission.value[kSolarBand], 0) : Spectrum();
}

// The next paint after the one a material has; a material that emits emits in that colour, as strongly.
void next_paint(Material& material) {
  material.reflectivity = paint_after(material.reflectivity);
  drop_void_flux(material);
  if (!material.emission.is_zero()) material.emission = in_colour(material.reflectivity, material.emission);
}

void step_reflectivity(Material& material, int sign) {
  for (Rational& value : material.reflectivity.value)
    value = std::clamp<Rational>(value + Rational(sign) / 20, Rational(0), Rational(1));
}

}  // namespace

// A quarter more or less, to two significant digits; from nothing to 1, and below a thousandth to nothing.
void step_quantity(Spectrum& quantity, int sign) {
  if (quantity.is_zero()) {
    if (sign > 0) quantity = Spectrum::scalar(Rational(1));
    return;
  }
  for (Rational& value : quantity.value) {
    if (value == 0) continue;
    const bool grows = (sign > 0) == (value > 0);
    value = grows ? value * 5 / 4 : value * 4 / 5;
    value = rounded_decimal(value, 2 - decades(abs(value)));
    if (abs(value) < Rational(1) / 1000) value = 0;
  }
}

void next_colour(Spectrum& quantity) {
  if (quantity.is_zero()) return;
  const auto has_colour = [&](const Spectrum& paint) { return in_colour(paint, quantity) == quantity; };
  const auto found = std::ranges::find_if(paints(), has_colour);
  quantity = in_colour(found == paints().end() ? paints()[0] : paint_after(*found), quantity);
}

bool is_material_edit(std::string_view name) { return std::ranges::find(kEdits, name) != kEdits.end(); }

void edit_material(Material& material, std::string_view name) {
  HOTTEL_REQUIRE(is_material_edit(name));
  const int sign = name.starts_with("more") ? 1 : -1;
  if (name == "colour" && material.has_bands) return;
  if (name == "colour")
    next_paint(material);
  else
    name.ends_with("emission") ? step_quantity(material.emission, sign) : step_reflectivity(material, sign);
  drop_void_flux(material);
}

std::string material_text(const Material& material) {
  return fmt::format("reflectivity {}; emission {}", spectrum_text(material.reflectivity),
                     spectrum_text(material.emission));
}

std::string spectrum_text(const Spectrum& spectrum) {
  if (spectrum.is_scalar) return short_text(spectrum.value[0]);
  return fmt::format("{} {} {}", short_text(spectrum.value[0]), short_text(spectrum.value[1]),
                     short_text(spectrum.value[2]));
}

std::string read_material(const std::string& text, Material& material) {
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find(';', begin), text.size());
    std::string part = text.substr(begin, end - begin);
    begin = end + 1;
    part.erase(0, std::min(part.find_first_not_of(' '), part.size()));
    if (part.empty()) continue;
    const std::size_t blank = std::min(part.find(' '), part.size());
    const std::string word = part.substr(0, blank);
    const bool is_emission = word == "emission";
    if (!is_emission && word != "reflectivity") return "say 'reflectivity' or 'emission', not '" + word + "'";
    Spectrum& spectrum = is_emission ? material.emission : material.reflectivity;
    if (part == word + " " + spectrum_text(spectrum)) continue;  // as it was shown, with all the digits that it has
    const Typed<Spectrum> typed =
        typed_spectrum(part.substr(blank), is_emission ? SpectrumKind::kQuantity : SpectrumKind::kFraction);
    if (!typed.value) return word + ": " + typed.problem;
    spectrum = *typed.value;
  }
  drop_void_flux(material);
  return "";
}

}  // namespace hottel
