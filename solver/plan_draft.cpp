#include "solver/plan_draft.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "kernel/plain_functions.h"
#include "kernel/support/counted.h"

namespace hottel {

PlanDraft::PlanDraft(const SceneTable& scene, const PlanRequest& request, SurfaceWords words)
    : scene_(scene), request_(request), words_(std::move(words)) {}

template <class Test>
std::size_t PlanDraft::count(const Test& test) const {
  return static_cast<std::size_t>(std::count_if(scene_.surfaces.begin(), scene_.surfaces.end(), test));
}

template <class Test>
bool PlanDraft::has_material(const Test& test) const {
  return std::any_of(scene_.surfaces.begin(), scene_.surfaces.end(), [&](const Surface& surface) {
    const auto passes = [&](const std::optional<std::uint32_t>& material) {
      return material && test(scene_.materials[*material]);
    };
    return passes(surface.material_of(false)) || passes(surface.material_of(true));
  });
}

void PlanDraft::add(const char* effect, bool is_needed, const std::string& why, const std::string& why_not,
                    double seconds) {
  const bool is_used = is_needed || request_.everything;
  effects_.push_back({effect, is_used,
                      is_needed ? why
                      : is_used ? "asked for; the scene does not need it: " + why_not
                                : why_not,
                      is_used ? seconds : 0});
}

void PlanDraft::add_as_asked(const char* effect, bool is_asked, const std::string& why, const std::string& why_not,
                             double seconds) {
  effects_.push_back({effect, is_asked, is_asked ? why : why_not, is_asked ? seconds : 0});
}

void PlanDraft::add_back_faces() {
  const std::size_t backs = count([](const Surface& surface) { return surface.back.has_value(); });
  add(Plan::kBackFaces, backs > 0, counted(backs, "back") + " with a material",
      "no back has a material: backs are black and have no row");
}

void PlanDraft::add_sky(bool is_one_room, double seconds, bool is_by_closure) {
  const std::string why =
      scene_.sky_emission.is_zero() ? "the scene is not promised to be closed; the sky is dark" : "the sky emits";
  add(Plan::kSky, !is_one_room && !scene_.closed, why + (is_by_closure ? "; told by closure" : ""),
      is_one_room ? "one closed room" : "the scene is promised to be closed", seconds);
}

void PlanDraft::add_subdivision() {
  const std::size_t divided = count([](const Surface& surface) { return surface.is_divided(); });
  add(Plan::kSubdivision, divided > 0, count_text(divided) + " divided into elements",
      fmt::format("no gradients {} are asked for", words_.across));
}

void PlanDraft::add_channels() {
  add(Plan::kChannels, channel_count(scene_) > 1,
      scene_.has_bands ? "two bands: solar, then thermal with what is gained" : "spectra differ: r, g, b",
      "every spectrum is a scalar: one channel");
}

void PlanDraft::add_interreflection(double unknowns, double entries) {
  // Factored, or by conjugate gradients; and the certificate of each unknown. Each channel is solved for itself.
  const double seconds = static_cast<double>(channel_count(scene_)) *
                         (std::min(same_bits::pow(unknowns, 3) / 3 * 6e-10, entries * 2e-7) + unknowns * 1e-5);
  const bool is_any_taken =
      has_material([](const Material& m) { return m.has_given_flux() && m.thermal(m.emission) < 0; });
  add(Plan::kInterreflection, reflects(),
      is_any_taken ? "some faces reflect; heat is supplied and taken: solved for each apart" : "some faces reflect",
      "every reflectivity is 0: radiosity is emission", is_any_taken ? 2 * seconds : seconds);
}

void PlanDraft::add_unreachable(bool is_one_room) {
  const bool emits = has_material([](const Material& material) { return !material.emission.is_zero(); });
  const bool is_lit = emits || !scene_.sky_emission.is_zero() || !scene_.lights.empty();
  add(Plan::kUnreachable, !is_one_room || !is_lit,
      is_lit ? "rooms that no light reaches stay exactly dark and are not solved"
             : "nothing emits: everything stays exactly dark and is not solved",
      "one room with light");
}

void PlanDraft::add_dividing(double seconds) {
  add(Plan::kDividing, reflects(), "an estimate of what dividing once more would change",
      "every reflectivity is 0: dividing changes no radiosity", seconds);
}

void PlanDraft::add_lights(double seconds) {
  const std::size_t beams =
      static_cast<std::size_t>(std::count_if(scene_.lights.begin(), scene_.lights.end(),
                                             [](const Light& light) { return !light.is_sun() && !light.is_round(); }));
  const auto suns = static_cast<std::size_t>(std::ranges::count_if(scene_.lights, &Light::is_sun));
  std::string what = counted(scene_.lights.size(), "light");
  if (suns > 0) what += ", " + counted(suns, "sun") + " among them";
  add_as_asked(Plan::kLights, !scene_.lights.empty(), what, "the scene lists no lights",
               static_cast<double>(scene_.lights.size()) * seconds);
  add_as_asked(Plan::kBeams, beams > 0,
               counted(beams, "beam") + " with a border: --light-levels divides what it crosses",
               scene_.lights.empty() ? "the scene lists no lights"
               : suns > 0            ? "no light has a beam"
                                     : "every light shines all around",
               0);
}

void PlanDraft::add_movement(bool moves) {
  add_as_asked(Plan::kMovement, moves, "lights turn or follow paths: solve takes the time 0, animate makes frames",
               scene_.lights.empty() ? "the scene lists no lights" : "no light moves", 0);
}

std::string PlanDraft::count_text(std::size_t count) const { return counted(count, words_.one); }

bool PlanDraft::reflects() const {
  return has_material([](const Material& material) { return !material.reflectivity.is_zero(); });
}

}  // namespace hottel
