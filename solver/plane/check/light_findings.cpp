#include "solver/plane/check/light_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "geometry/name.h"
#include "geometry/plane/check/wording.h"
#include "kernel/plain_functions.h"
#include "kernel/support/failure.h"
#include "solver/check/dark_suns.h"
#include "solver/check/light_errors.h"
#include "solver/check/light_fates.h"

namespace hottel {
namespace {

constexpr double kResidual = 1e-12;

// Of jacobi: the spectral radius is at least its Rayleigh quotient for equal irradiances.
double iterations(const LightFate& fate) {
  return fate.loss > 0 && fate.loss < 1 ? same_bits::log(kResidual) / same_bits::log1p(-fate.loss) : 0;
}

using Faces = std::vector<std::uint32_t>;  // elements of the matrix, ascending

class LightTeller {
 public:
  LightTeller(const Scene2& scene, const ExchangeMatrix& matrix, std::span<const LightShares> lights,
              const std::function<void(double)>& progress)
      : scene_(scene), matrix_(matrix), lights_(lights), progress_(progress) {}

  Findings2 tell() {
    const RadiositySources sources = given_sources();
    const LightFates fates = light_fates(scene_, matrix_, sources);
    for (const auto& [faces, fate] : fates.of) tell_component(faces, fate);
    for (LightError& error : light_errors(scene_, matrix_, sources, fates, "length", progress_))
      add(Severity::kError, std::move(error.kind), std::move(error.surfaces), std::move(error.message),
          std::move(error.suggestion));
    if (!scene_.surfaces.empty() && !has_source())
      add(Severity::kNote, "no-light", {}, "nothing emits: every radiosity is 0",
          "view factors do not need any light; to solve, give a material or the sky an emission");
    for (std::size_t k = 0; k < lights_.size(); ++k)
      if (!lights_[k].solid.empty())
        findings_.push_back({Severity::kWarning,
                             "light-in-solid",
                             {},
                             scene_.light_places[k].position,
                             lost_light_text(scene_.lights[k], lights_[k]),
                             "move it out, or turn the points of that solid around where a room was meant"});
    for (std::size_t k = 0; k < lights_.size(); ++k)
      if (scene_.light_places[k].rotation == 0)  // else it may come
        if (std::string text = dark_sun_text(scene_.lights[k], lights_[k], matrix_); !text.empty())
          add(Severity::kNote, "dark-sun", {}, std::move(text), kDarkSunSuggestion);
    tell_materials();
    return std::move(findings_);
  }

 private:
  // Those of the scene; without its lights, and an error, where these are too much for doubles or cannot be told.
  RadiositySources given_sources() {
    try {
      return sources_of(matrix_, scene_, lights_);
    } catch (const RequestError& error) {
      const LightError told = refused_light(scene_, error.what());
      add(Severity::kError, told.kind, {}, told.message, told.suggestion);
      return sources_of(matrix_, scene_.materials, scene_.sky_emission);
    }
  }

  void add(Severity severity, std::string kind, std::vector<std::uint32_t> surfaces, std::string message,
           std::string suggestion) {
    std::optional<Point2> at;
    if (!surfaces.empty()) at = middle(scene_.edges[surfaces.front()]);
    findings_.push_back(
        {severity, std::move(kind), std::move(surfaces), at, std::move(message), std::move(suggestion)});
  }

  std::vector<std::uint32_t> surfaces_of(const Faces& faces) const {
    std::vector<std::uint32_t> surfaces;
    for (const std::uint32_t face : faces)
      if (surfaces.empty() || surfaces.back() != matrix_.elements()[face].surface)
        surfaces.push_back(matrix_.elements()[face].surface);
    return surfaces;
  }

  void tell_component(const Faces& faces, const LightFate& fate) {
    const std::vector<std::uint32_t> surfaces = surfaces_of(faces);
    const std::string names = names_text(scene_, surfaces);
    if (fate.has_no_solution) return;  // an error
    if (fate.reflects_all)
      add(Severity::kNote, "all-reflecting", surfaces,
          fmt::format("all light that meets {} is reflected and none gets out, but none is emitted there either: "
                      "radiosity is 0, the limit",
                      names),
          "nothing to do where that is meant");
    else if (!fate.is_lit && has_source() && sees_material(faces.front()))
      add(Severity::kNote, "dark", surfaces, fmt::format("no light reaches {}: radiosity is exactly 0", names),
          "open a way for light, or let something there emit");
    else if (iterations(fate) >= kManyIterations)
      add(Severity::kNote, "slow-convergence", surfaces,
          fmt::format("light stays long between {}: jacobi needs about {:.2g} iterations or more for a residual of {}",
                      names, iterations(fate), shortest(kResidual)),
          "solve with cholesky or cg, as auto does; they do not mind");
  }

  // What sees nothing that could send light is told as that (visibility_findings).
  bool sees_material(std::uint32_t face) const {
    const auto row = matrix_.row(face);
    return std::any_of(row.begin(), row.end(), [this](const FactorEntry& entry) {
      return entry.to != matrix_.sky() && matrix_.elements()[entry.to].material;
    });
  }

  bool has_source() const {
    const auto shines = [](const Light& light) { return !light.power.is_zero(); };
    if (std::any_of(scene_.lights.begin(), scene_.lights.end(), shines)) return true;
    return !scene_.sky_emission.is_zero() || std::any_of(scene_.surfaces.begin(), scene_.surfaces.end(), [&](auto& s) {
      return !scene_.materials[s.material].emission.is_zero() ||
             (s.back && !scene_.materials[*s.back].emission.is_zero());
    });
  }

  void tell_materials() {
    std::vector<char> is_used(scene_.materials.size(), 0);
    for (const Surface& surface : scene_.surfaces) {
      is_used[surface.material] = 1;
      if (surface.back) is_used[*surface.back] = 1;
    }
    for (std::size_t m = 0; m < is_used.size(); ++m)
      if (!is_used[m])
        add(Severity::kNote, "unused-material", {},
            fmt::format("no surface has the material {}", quoted_name(scene_.materials[m].name)),
            "take it away, or look for a surface that should have it");
  }

  const Scene2& scene_;
  const ExchangeMatrix& matrix_;
  const std::span<const LightShares> lights_;
  const std::function<void(double)>& progress_;
  Findings2 findings_;
};

}  // namespace

Findings2 light_findings(const Scene2& scene, const ExchangeMatrix& matrix, std::span<const LightShares> lights,
                         const std::function<void(double)>& progress) {
  return LightTeller(scene, matrix, lights, progress).tell();
}

}  // namespace hottel
