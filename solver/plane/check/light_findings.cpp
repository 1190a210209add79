#include "solver/plane/check/light_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "geometry/name.h"
#include "geometry/plane/check/wording.h"
#include "kernel/support/failure.h"
#include "solver/plan.h"
#include "solver/radiosity/matrix_checks.h"
#include "solver/radiosity/radiosity.h"
#include "solver/radiosity/radiosity_system.h"

namespace hottel {
namespace {

constexpr double kResidual = 1e-12;
constexpr double kModerate = 1e60;

// What becomes of light in one component, over all channels.
struct Fate {
  bool is_lit = false, has_no_solution = false, reflects_all = false;
  double loss = std::numeric_limits<double>::infinity();  // the part that is lost at a reflection, of equal irradiances
};

// Of jacobi: the spectral radius is at least its Rayleigh quotient for equal irradiances.
double iterations(const Fate& fate) {
  return fate.loss > 0 && fate.loss < 1 ? std::log(kResidual) / std::log1p(-fate.loss) : 0;
}

using Faces = std::vector<std::uint32_t>;  // elements of the matrix, ascending

void add_fates(const Scene2& scene, const ExchangeMatrix& matrix, int channel, std::map<Faces, Fate>& fates) {
  const RadiositySystem system(matrix, scene.materials, channel);
  const Sources sources = system.sources(scene.materials, scene.sky_emission, channel);
  const std::size_t count = system.components().size();
  std::vector<Faces> faces(count);
  std::vector<double> area(count), lost(count);
  for (const SystemRow& row : system.rows()) {
    double out = 0;
    for (const FactorEntry& entry : matrix.row(row.element))
      if (system.unknown(entry.to) < 0) out += entry.factor.value;
    const double size = matrix.elements()[row.element].area.value;
    area[row.component] += size;
    lost[row.component] += size * (row.loss.hi + row.reflectivity.hi * out);
    faces[row.component].push_back(row.element);
  }
  for (std::size_t c = 0; c < count; ++c) {
    Fate& fate = fates[faces[c]];
    const bool is_lit = sources.is_lit[c] != 0, loses = system.components()[c].loses;
    fate.is_lit |= is_lit;
    fate.has_no_solution |= !loses && is_lit;
    fate.reflects_all |= !loses;
    fate.loss = std::min(fate.loss, lost[c] / area[c]);
  }
}

class LightTeller {
 public:
  LightTeller(const Scene2& scene, const ExchangeMatrix& matrix, const std::function<void(double)>& progress)
      : scene_(scene), matrix_(matrix), progress_(progress) {}

  Findings2 tell() {
    std::map<Faces, Fate> fates;
    for (int channel = 0; channel < channel_count(scene_); ++channel) add_fates(scene_, matrix_, channel, fates);
    for (const auto& [faces, fate] : fates) tell_component(faces, fate);
    if (!has_error(findings_)) tell_range(fates);
    if (!scene_.surfaces.empty() && !has_source())
      add(Severity::kNote, "no-light", {}, "nothing emits: every radiosity is 0",
          "view factors do not need any light; to solve, give a material or the sky an emission");
    tell_materials();
    return std::move(findings_);
  }

 private:
  void add(Severity severity, const char* kind, std::vector<std::uint32_t> surfaces, std::string message,
           std::string suggestion) {
    std::optional<Point2> at;
    if (!surfaces.empty()) at = middle(scene_.edges[surfaces.front()]);
    findings_.push_back({severity, kind, std::move(surfaces), at, std::move(message), std::move(suggestion)});
  }

  std::vector<std::uint32_t> surfaces_of(const Faces& faces) const {
    std::vector<std::uint32_t> surfaces;
    for (const std::uint32_t face : faces)
      if (surfaces.empty() || surfaces.back() != matrix_.elements()[face].surface)
        surfaces.push_back(matrix_.elements()[face].surface);
    return surfaces;
  }

  // What doubles cannot tell. Where numbers are so moderate that they can, nothing is solved for it.
  void tell_range(const std::map<Faces, Fate>& fates) {
    tell_beyond(faces_where([this](std::uint32_t i) { return !is_a_size(matrix_.elements()[i].area.value); }),
                "the length of {} is beyond the range of doubles", "choose another unit of length");
    tell_beyond(faces_where([this](std::uint32_t i) { return !std::isfinite(largest_emission(material_of(i))); }),
                "the emission of {} is beyond the range of doubles", "choose another unit of light");
    if (!std::isfinite(largest(scene_.sky_emission)))
      add(Severity::kError, "beyond-doubles", {}, "the emission of the sky is beyond the range of doubles",
          "choose another unit of light");
    if (has_error(findings_) || is_moderate()) return;
    try {
      const RadiositySolution solution =
          solve_radiosity(matrix_, scene_.materials, scene_.sky_emission, {.progress = progress_});
      tell_beyond(faces_where([&](std::uint32_t i) { return !is_finite(solution, i); }),
                  "the light of {} is beyond the range of doubles",
                  "choose another unit of light, or let more of it be absorbed");
      if (!has_error(findings_)) tell_power(solution);
    } catch (const RequestError& error) {
      const auto least =
          std::min_element(fates.begin(), fates.end(), [](auto& a, auto& b) { return a.second.loss < b.second.loss; });
      add(Severity::kError, "beyond-doubles", least == fates.end() ? Faces{} : surfaces_of(least->first), error.what(),
          "give one of them a smaller reflectivity, or open a wider way out");
    }
  }

  void tell_power(const RadiositySolution& solution) {
    try {
      require_doubles(matrix_, scene_.sky_emission, solution);
    } catch (const RequestError& error) {
      add(Severity::kError, "beyond-doubles", surfaces_of(faces_where([](std::uint32_t) { return true; })),
          error.what(), "choose another unit of length or of light");
    }
  }

  static bool is_a_size(double area) { return area > 0 && std::isfinite(area); }
  static double largest(const Spectrum& spectrum) {
    return to_double(*std::max_element(spectrum.value.begin(), spectrum.value.end()));
  }
  static double largest_emission(const Material& material) { return largest(material.emission); }
  static bool is_finite(const RadiositySolution& solution, std::uint32_t i) {
    return std::all_of(solution.channels.begin(), solution.channels.end(), [i](const ChannelSolution& channel) {
      return std::isfinite(channel.elements[i].radiosity) && std::isfinite(channel.elements[i].irradiance);
    });
  }

  const Material& material_of(std::uint32_t face) const { return scene_.materials[*matrix_.elements()[face].material]; }

  template <class Is>
  Faces faces_where(const Is& is) const {
    Faces faces;
    for (std::uint32_t i = 0; i < matrix_.size(); ++i)
      if (matrix_.has_row(i) && is(i)) faces.push_back(i);
    return faces;
  }

  void tell_beyond(const Faces& faces, fmt::format_string<std::string> message, const char* suggestion) {
    if (faces.empty()) return;
    const std::vector<std::uint32_t> surfaces = surfaces_of(faces);
    add(Severity::kError, "beyond-doubles", surfaces, fmt::format(message, names_text(scene_, surfaces)), suggestion);
  }

  // Light that is sent out arrives where it is absorbed by way of exchange areas and absorbing areas, each of which
  // adds to radiosity the power over its area: far from the ends of the range all of it can be told.
  bool is_moderate() const {
    double least = std::numeric_limits<double>::infinity(), most = largest(scene_.sky_emission);
    const auto meet = [&](double value) {
      least = std::min(least, value);
      most = std::max(most, value);
    };
    for (std::uint32_t i = 0; i < matrix_.size(); ++i) {
      if (!matrix_.has_row(i)) continue;
      const Material& material = material_of(i);
      const double area = matrix_.elements()[i].area.value;
      most = std::max(most, largest_emission(material));
      for (const Rational& rho : material.reflectivity.value)
        if (rho != 1) meet(area * to_double(1 - rho));
      for (const FactorEntry& entry : matrix_.row(i)) meet(area * entry.factor.value);
    }
    return least > 1 / kModerate && most < kModerate;
  }

  void tell_component(const Faces& faces, const Fate& fate) {
    const std::vector<std::uint32_t> surfaces = surfaces_of(faces);
    const std::string names = names_text(scene_, surfaces);
    if (fate.has_no_solution)
      add(Severity::kError, "no-solution", surfaces,
          fmt::format("all light that meets {} is reflected and none gets out, yet some is emitted there: it would "
                      "grow without end",
                      names),
          "give one of them a reflectivity below 1, or open a way to the sky");
    else if (fate.reflects_all)
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

  // What sees nothing that could send light is told as that (sight_findings).
  bool sees_material(std::uint32_t face) const {
    const auto row = matrix_.row(face);
    return std::any_of(row.begin(), row.end(), [this](const FactorEntry& entry) {
      return entry.to != matrix_.sky() && matrix_.elements()[entry.to].material;
    });
  }

  bool has_source() const {
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
  const std::function<void(double)>& progress_;
  Findings2 findings_;
};

}  // namespace

Findings2 light_findings(const Scene2& scene, const ExchangeMatrix& matrix,
                         const std::function<void(double)>& progress) {
  return LightTeller(scene, matrix, progress).tell();
}

}  // namespace hottel
