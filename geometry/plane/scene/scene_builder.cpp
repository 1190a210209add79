#include "geometry/plane/scene/scene_builder.h"

#include <utility>

#include "geometry/grid_names.h"
#include "geometry/name.h"
#include "geometry/patch_bases.h"
#include "geometry/plane/scene/patch_seats.h"
#include "geometry/plane/scene/scene_entries.h"
#include "geometry/scene_names.h"
#include "kernel/support/failure.h"

namespace hottel {
namespace {

// Refuses on behalf of one scene.
class Reader {
 public:
  explicit Reader(const std::string& file) : file_(file) {}

  [[noreturn]] void refuse(const std::string& text, std::vector<std::string> hints = {}) const {
    throw InputError({file_, 0}, text, std::move(hints));
  }

  const Rational& number(const std::string& subject, const Number& number) const {
    const auto& [problem, hint] = number.problem();
    if (!problem.empty())
      refuse(subject + " " + problem, hint.empty() ? std::vector<std::string>() : std::vector{hint});
    return number.value();
  }

  Point2 point(const std::string& subject, const TypedPoint2& typed) const {
    return {number(subject, typed.x), number(subject, typed.y)};
  }

  Spectrum spectrum(const std::string& subject, const TypedSpectrum& typed, SpectrumKind kind) const {
    Spectrum result;
    if (typed.numbers.size() == 1) result = Spectrum::scalar(number(subject, typed.numbers[0]));
    if (typed.numbers.size() == 3) {
      result.is_scalar = false;
      for (std::size_t c = 0; c < 3; ++c) result.value[c] = number(subject, typed.numbers[c]);
    }
    if (const auto problem = spectrum_problem(result, kind); !problem.empty())
      refuse(subject + " " + std::string(problem));
    return result;
  }

 private:
  const std::string& file_;
};

bool is_given(const TypedSpectrum& spectrum) { return !spectrum.numbers.empty(); }

// What may stand beside a flux.
void require_flux_alone(const Reader& reader, const std::string& owner, const MaterialOptions& options) {
  if (is_given(options.temperature))
    reader.refuse(owner + " has a temperature and a flux: one of them is given, the other comes out");
  if (!is_given(options.emissivity)) reader.refuse(owner + " has a flux but no emissivity");
  if (options.emissivity.numbers.size() > 1 || options.flux.numbers.size() > 1)
    reader.refuse(owner + ": emissivity and flux are one number each");
}

// The name that is meant, once it is found to be one.
std::string name_or_default(const Reader& reader, const std::string& name, const char* noun, std::size_t count) {
  const std::string by_place = piece_name(noun, count);
  if (name.empty()) return by_place;
  if (const auto problem = name_problem(name); !problem.empty())
    reader.refuse(by_place + ": the name " + quoted_name(name) + " " + std::string(problem));
  return name;
}

}  // namespace

SceneBuilder2::SceneBuilder2(std::string title) {
  scene_.file = std::move(title);
  polylines_.file = scene_.file;
}

SceneBuilder2& SceneBuilder2::add_material(const std::string& name, const MaterialOptions& options) {
  const Reader reader(scene_.file);
  if (const auto problem = material_name_problem(name); !problem.empty()) reader.refuse(problem);
  const std::string owner = "material " + quoted_name(name);
  if (material_index_.contains(name)) reader.refuse(owner + " is there already");
  if ((is_given(options.reflectivity) || is_given(options.emission)) &&
      (is_given(options.emissivity) || is_given(options.temperature)))
    reader.refuse(owner + " mixes two ways to say what it emits",
                  {"give either reflectivity and emission, or emissivity and temperature"});
  if (options.insulated && (is_given(options.reflectivity) || is_given(options.emission) ||
                            is_given(options.emissivity) || is_given(options.temperature) || is_given(options.flux)))
    reader.refuse(owner + " is insulated, which is reflectivity 1 and emission 0: it has no other values");
  if (is_given(options.temperature) && !is_given(options.emissivity))
    reader.refuse(owner + " has a temperature but no emissivity");
  if (is_given(options.flux)) require_flux_alone(reader, owner, options);
  Material material;
  material.name = name;
  material.is_two_sided = options.two_sided;
  const auto read = [&](const char* part, const TypedSpectrum& spectrum, SpectrumKind kind) {
    return reader.spectrum(owner + ": " + part, spectrum, kind);
  };
  if (options.insulated) {
    set_insulated(material);
  } else if (is_given(options.flux)) {
    const std::string of_emissivity = owner + ": emissivity";
    const Rational& emissivity = reader.number(of_emissivity, options.emissivity.numbers[0]);
    if (!(0 < emissivity && emissivity <= 1)) reader.refuse(of_emissivity + " beside flux must be above 0, at most 1");
    set_given_flux(emissivity, reader.number(owner + ": flux", options.flux.numbers[0]), material);
  } else if (is_given(options.emissivity)) {
    set_gray_body(read("emissivity", options.emissivity, SpectrumKind::kFraction),
                  read("temperature", options.temperature, SpectrumKind::kQuantity), material);
  } else {
    material.reflectivity = read("reflectivity", options.reflectivity, SpectrumKind::kFraction);
    material.emission = read("emission", options.emission, SpectrumKind::kQuantity);
  }
  material_index_.emplace(name, static_cast<std::uint32_t>(scene_.materials.size()));
  scene_.materials.push_back(std::move(material));
  return *this;
}

SceneBuilder2& SceneBuilder2::add_edge(const std::string& name, const TypedPoint2& from, const TypedPoint2& to,
                                       const std::string& material, const EdgeOptions2& options) {
  const Reader reader(scene_.file);
  const std::string own = name_or_default(reader, name, "edge", scene_.groups.size());
  const std::string owner = "edge " + quoted_name(own);
  Surface surface = surface_of(owner, material, options.back, options.elements);
  surface.name = own;
  surface.group = static_cast<std::uint32_t>(scene_.groups.size());
  put_on(surface, owner, options.on, options.behind);
  const std::string coordinate = owner + ": coordinate";
  hottel::add_edge(scene_, std::move(surface), {reader.point(coordinate, from), reader.point(coordinate, to)});
  scene_.groups.emplace_back(own, options.behind);
  return *this;
}

SceneBuilder2& SceneBuilder2::add_polyline(const std::string& name, const std::vector<TypedPoint2>& points,
                                           const std::string& material, const PolylineOptions2& options) {
  const Reader reader(scene_.file);
  const std::string own = name_or_default(reader, name, "polyline", polylines_.groups.size());
  const std::string owner = "polyline " + quoted_name(own);
  Surface surface = surface_of(owner, material, options.back, options.elements);
  surface.group = static_cast<std::uint32_t>(polylines_.groups.size());
  if (points.size() < 2) reader.refuse(owner + " has fewer than two points");
  put_on(surface, owner, options.on, options.behind);
  std::vector<PolylinePoint2> read;
  for (const TypedPoint2& point : points) read.push_back({reader.point(owner + ": coordinate", point)});
  const std::size_t before = polylines_.surfaces.size();
  try {
    hottel::add_polyline(polylines_, surface, own, std::move(read), options.closed);
  } catch (const InputError&) {
    polylines_.surfaces.resize(before);
    polylines_.edges.resize(before);
    throw;
  }
  polylines_.groups.emplace_back(own, options.behind);
  return *this;
}

SceneBuilder2& SceneBuilder2::set_sky(const TypedSpectrum& emission) {
  scene_.sky_emission = Reader(scene_.file).spectrum("sky: emission", emission, SpectrumKind::kQuantity);
  return *this;
}

SceneBuilder2& SceneBuilder2::set_sky_temperature(const TypedSpectrum& temperature) {
  scene_.sky_emission =
      black_emission(Reader(scene_.file).spectrum("sky: temperature", temperature, SpectrumKind::kQuantity));
  return *this;
}

SceneBuilder2& SceneBuilder2::set_grid(const TypedPoint2& min, const TypedPoint2& max, std::uint32_t nx,
                                       std::uint32_t ny) {
  const Reader reader(scene_.file);
  std::vector<Grid2> grids{{reader.point("grid: min", min), reader.point("grid: max", max), nx, ny}};
  validate_grids(grids, scene_.file);
  scene_.grids = std::move(grids);
  return *this;
}

SceneBuilder2& SceneBuilder2::add_grid(const std::string& name, const TypedPoint2& min, const TypedPoint2& max,
                                       std::uint32_t nx, std::uint32_t ny) {
  const Reader reader(scene_.file);
  if (name.empty()) reader.refuse("grid: a name " + grid_name_problem(name));
  std::vector<Grid2> grids = scene_.grids;
  grids.push_back({reader.point("grid: min", min), reader.point("grid: max", max), nx, ny, name});
  validate_grids(grids, scene_.file);
  scene_.grids = std::move(grids);
  return *this;
}

SceneBuilder2& SceneBuilder2::set_closed(bool closed) {
  scene_.closed = closed;
  return *this;
}

SceneBuilder2& SceneBuilder2::set_about(std::string about) {
  scene_.about = std::move(about);
  return *this;
}

SceneBuilder2& SceneBuilder2::set_unit(std::string unit) {
  if (const auto problem = unit_problem(unit); !problem.empty())
    Reader(scene_.file).refuse("unit " + std::string(problem));
  scene_.unit = std::move(unit);
  return *this;
}

ValidScene2 SceneBuilder2::build() const {
  Scene2 scene = scene_;
  append_polylines(scene, polylines_);
  seat_patches(scene, 0);
  settle_two_sided(scene);
  ValidScene2 valid(std::move(scene));
  refuse_names_of_edges(*valid, std::vector<int>(polylines_.groups.size()));
  return valid;
}

std::uint32_t SceneBuilder2::material_of(const std::string& owner, const char* part, const std::string& name) const {
  if (const auto found = material_index_.find(name); found != material_index_.end()) return found->second;
  Reader(scene_.file)
      .refuse(owner + ": " + part + " " + quoted_name(name) + " is not defined",
              undefined_material_hints(scene_, name));
}

Surface SceneBuilder2::surface_of(const std::string& owner, const std::string& material, const std::string& back,
                                  std::uint32_t elements) const {
  Surface surface;
  surface.material = material_of(owner, "material", material);
  if (!back.empty()) surface.back = material_of(owner, "back", back);
  if (elements < 1 || elements > kMaxElements)
    Reader(scene_.file).refuse(owner + ": elements must be an integer from 1 to " + std::to_string(kMaxElements));
  surface.elements = elements;
  return surface;
}

// A base that no surface has in the end does no harm: a throw that follows leaves one.
void SceneBuilder2::put_on(Surface& surface, const std::string& owner, const std::string& base, Behind behind) {
  if (base.empty()) return;
  if (behind != Behind::kByOutline)
    Reader(scene_.file)
        .refuse(owner + " lies on another surface: it makes nothing solid, and says nothing of what is behind");
  surface.on = static_cast<std::uint32_t>(scene_.bases.size());
  scene_.bases.push_back(side_named(base));
}

}  // namespace hottel
