#include "io/results/radiosity_files.h"

#include <fmt/format.h>

#include "geometry/face.h"
#include "geometry/scene_names.h"
#include "geometry/unit_of_length.h"
#include "io/results/csv_field.h"
#include "io/results/short_digits.h"
#include "kernel/support/failure.h"

namespace hottel {

void write_radiosity_csv(const SceneTable& scene, const ExchangeMatrix& matrix, const RadiositySolution& solution,
                         const std::function<void(std::string_view)>& sink, std::optional<int> digits) {
  for (const ChannelSolution& channel : solution.channels) HOTTEL_REQUIRE(channel.elements.size() == matrix.size());
  sink("face,element,channel,area,emission,reflectivity,radiosity,lower,upper,irradiance,net\n");
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (!matrix.has_row(i)) continue;
    const Element& element = matrix.elements()[i];
    const std::string face = csv_field(face_name(scene, {element.surface, element.is_back}));
    for (std::size_t c = 0; c < solution.channels.size(); ++c) {
      const ElementRadiosity& r = solution.channels[c].elements[i];
      std::string line = fmt::format("{},{},{}", face, element.node().text(), solution.channel_names[c]);
      const auto add = [&](double value, RoundedTo to = RoundedTo::kNearest) {
        line += "," + short_digits(value, digits, to);
      };
      for (const double value : {element.area.value, r.emission, r.reflectivity, r.radiosity}) add(value);
      add(r.lower, RoundedTo::kBelow);
      add(r.upper, RoundedTo::kAbove);
      for (const double value : {r.irradiance, r.net()}) add(value);
      sink(line + "\n");
    }
  }
}

namespace {

// The three columns of a power.
std::string power_text(const NetFlux::Power& power, std::optional<int> digits) {
  return short_digits(power.value, digits) + "," + short_digits(power.lower, digits, RoundedTo::kBelow) + "," +
         short_digits(power.upper, digits, RoundedTo::kAbove);
}

void write_fluxes(const char* per, const std::vector<NetFlux>& some, const NetFluxes& all, std::optional<int> digits,
                  const std::function<void(std::string_view)>& sink) {
  for (const NetFlux& flux : some)
    for (std::size_t c = 0; c < all.channel_names.size(); ++c)
      sink(fmt::format("{},{},{},{},{}\n", per, csv_field(flux.name), all.channel_names[c],
                       flux.area ? short_digits(*flux.area, digits) : "",
                       all.are_in_watts ? power_text(flux.by_channel[c], digits) : ",,"));
}

}  // namespace

NetFluxes::NetFluxes(const SceneTable& scene, const ExchangeMatrix& matrix, const RadiositySolution& solution,
                     std::span<const LightShares> shares)
    : are_in_watts(has_known_unit(scene)) {
  const ShiningLights shining{scene.lights, shares};
  faces = net_flux(
      matrix, solution, scene.sky_emission,
      [&](const Element& e) {
        return face_name(scene, {e.surface, e.is_back});
      },
      shining);
  groups = net_flux(
      matrix, solution, scene.sky_emission,
      [&](const Element& e) {
        return side_text({scene.groups[scene.surfaces[e.surface].group].name, e.is_back});
      },
      shining);
  lights = light_flux(shining, solution.channels.size());
  channel_names = solution.channel_names;
  for (const Light& light : scene.lights)
    if (light.is_sun()) has_sun[scene.has_bands && light.is_thermal ? kThermalBand : kSolarBand] = true;
  if (!scene.has_bands) return;
  channel_names.emplace_back("total");
  for (std::vector<NetFlux>* some : {&faces, &groups, &lights})
    for (NetFlux& flux : *some)
      flux.by_channel.push_back(sum(flux.by_channel[kSolarBand], flux.by_channel[kThermalBand]));
}

void write_flux_csv(const NetFluxes& fluxes, const std::function<void(std::string_view)>& sink,
                    std::optional<int> digits) {
  sink("per,name,channel,area,net,lower,upper\n");
  write_fluxes("face", fluxes.faces, fluxes, digits, sink);
  write_fluxes("group", fluxes.groups, fluxes, digits, sink);
  write_fluxes("light", fluxes.lights, fluxes, digits, sink);
}

}  // namespace hottel
