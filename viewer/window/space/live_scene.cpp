#include "viewer/window/space/live_scene.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <thread>
#include <utility>

#include "geometry/space/visibility/direction.h"
#include "kernel/support/failure.h"
#include "kernel/support/interrupt.h"

namespace hottel {
namespace {

constexpr int kMostSweepsSoFar = 50;
constexpr double kLeastChange = 1e-3;  // of the largest radiosity

}  // namespace

LiveModel3::LiveModel3(const PreparedScene3& scene)
    : prepared(scene),
      table(prepared.scene, prepared.arrangement(), prepared.blockers(), Granularity::kElement),
      mesh(prepared, table) {}

LiveScene3::LiveScene3(SimulationRequest3 request, const std::function<void()>& changed)
    : watch_(std::make_shared<NearestRows3>(changed)),
      request_(std::move(request)),
      preparing_(changed),
      lighting_(changed) {
  request_.factors.watch = watch_;
}

void LiveScene3::set(std::shared_ptr<const Scene3> scene) {
  const bool is_same_shape = scene_ && scene_->file == scene->file && scene_->polygons == scene->polygons &&
                             scene_->surfaces == scene->surfaces &&
                             scene_->materials.size() == scene->materials.size() && scene_->groups == scene->groups &&
                             scene_->masks == scene->masks && scene_->sky_emission == scene->sky_emission &&
                             scene_->closed == scene->closed;
  const bool keeps_factors = is_same_shape && are_alike_as_before_3(scene_->materials, scene->materials);
  simulation_ = is_same_shape ? simulation_->with_scene(*scene) : Simulation3(*scene, request_);
  if (is_same_shape) {
    state_.whole = state_.whole->with_scene(*scene);
  } else {
    state_ = {};
    SimulationRequest3 whole = request_;
    whole.factors.granularity = Granularity::kFace;
    whole.factors.watch = nullptr;
    state_.whole = simulation_->with_request(whole);
  }
  scene_ = std::move(scene);
  since_ = {};
  is_changed_ = is_changed_ || !state_.radiosities;
  if (keeps_factors && state_.problem.empty()) {
    state_.factors ? light_anew() : sweep_anew();
    return;
  }
  is_changed_ = true;
  lighting_.cancel();
  state_.problem.clear();
  prepare_anew();
}

// A tenth of a second between what is told of what runs.
void LiveScene3::prepare_anew() {
  state_.factors = nullptr;
  state_.so_far.reset();
  rows_ = nullptr;
  watch_->take();  // of the scene before
  preparing_.post([this, simulation = *simulation_](const StageProgress& go_on, const Background::Tell& tell) {
    const auto fail = [this](const std::string& problem) {
      return [this, problem] {
        state_.problem = problem;
        state_.stage.clear();
        is_changed_ = true;
      };
    };
    const auto show = [this](const std::string& stage) {
      return [this, stage] {
        state_.stage = stage;
        is_changed_ = true;
      };
    };
    std::string told;
    const StageProgress progress = [&](std::string_view stage, double fraction) {
      go_on(stage, fraction);
      std::string text = fmt::format("{} {:.0f} %", stage, 100 * fraction);
      if (text != told) tell(show(text));
      told = std::move(text);
    };
    try {
      tell(show("preparation"));
      const auto model = std::make_shared<const LiveModel3>(*simulation.prepared(progress));
      tell([this, model] {
        state_.model = model;
        is_changed_ = true;
      });
      const auto factors = simulation.factors(progress);
      return Background::Apply([this, factors] {
        state_.factors = factors;
        state_.stage.clear();
        lighting_.cancel();  // sweeps
        light_anew();
      });
    } catch (const Interrupted&) {
      throw;
    } catch (const std::exception& error) {
      return Background::Apply(fail(error.what()));
    }
  });
}

void LiveScene3::light_anew() {
  lighting_.follow([this, simulation = *simulation_, scene = scene_, since = since_](const StageProgress& progress,
                                                                                     const Background::Tell&) {
    try {
      const auto radiosities = simulation.radiosities(progress);
      const double seconds = Stopwatch(since).lap();
      return Background::Apply([this, radiosities, scene, simulation, seconds] {
        state_.radiosities = radiosities;
        state_.lit = scene;
        state_.simulation = simulation;
        state_.seconds = seconds;
        state_.problem.clear();
        is_changed_ = true;
      });
    } catch (const Interrupted&) {
      throw;
    } catch (const std::exception& error) {
      return Background::Apply([this, problem = std::string(error.what())] {
        state_.problem = problem;
        is_changed_ = true;
      });
    }
  });
}

// Sweeps until next to nothing changes, and tells of each.
void LiveScene3::sweep_anew() {
  if (!rows_ || !state_.model || state_.factors) return;
  const bool goes_on = state_.so_far && state_.so_far->channels == static_cast<std::size_t>(channel_count(*scene_));
  lighting_.post([this, scene = scene_, simulation = *simulation_, model = state_.model, rows = rows_,
                  from = goes_on ? *state_.so_far : light_before_factors_3(*scene_, state_.model->table)](
                     const StageProgress& progress, const Background::Tell& tell) {
    const auto show = [this](const ElementPaint3& light) {
      return [this, light] {
        state_.so_far = light;
        is_changed_ = true;
      };
    };
    RowSweeps3 sweeps(*scene, model->table, *rows, *simulation.light_shares(progress), from);
    for (int k = 0; k < kMostSweepsSoFar; ++k) {
      progress("sweeps", static_cast<double>(k) / kMostSweepsSoFar);
      if (sweeps.sweep() < kLeastChange) break;
      tell(show(sweeps.light()));
    }
    return Background::Apply(show(sweeps.light()));
  });
}

bool LiveScene3::collect() {
  preparing_.collect();
  if (auto rows = watch_->take(); rows && state_.model && !state_.factors) {
    rows_ = std::move(rows);
    state_.rows = rows_->count;
    state_.all_rows = rows_->all;
    is_changed_ = true;
    sweep_anew();
  }
  lighting_.collect();
  return std::exchange(is_changed_, false);
}

bool LiveScene3::is_at_rest() const { return !preparing_.is_busy() && !lighting_.is_busy(); }

bool LiveScene3::wait(double seconds) {
  Stopwatch watch;
  bool has_changed = false;
  for (double waited = 0; waited < seconds; waited += watch.lap()) {
    has_changed = collect() || has_changed;
    if (is_at_rest()) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  is_changed_ = has_changed || is_changed_;
  return is_at_rest();
}

ElementPaint3 light_before_factors_3(const Scene3& scene, const ElementTable3& table) {
  constexpr double kAmbient = 0.65, kAbove = 0.35;
  const Direction3 above = unit({1, -2, 3});
  ElementPaint3 paint;
  paint.channels = static_cast<std::size_t>(channel_count(scene));
  std::vector<double> emission(scene.materials.size()), reflectivity(scene.materials.size());
  std::vector<double> by_channel(table.count() * paint.channels, 0);
  for (std::size_t c = 0; c < paint.channels; ++c) {
    for (std::size_t m = 0; m < scene.materials.size(); ++m) {
      emission[m] = to_double(scene.materials[m].emission.value[c]);
      reflectivity[m] = to_double(scene.materials[m].reflectivity.value[c]);
    }
    const double sky = to_double(scene.sky_emission.value[c]);
    double sent = 0, lost = 0;
    for (const Light& light : scene.lights) sent += to_double(light.power.value[c]);
    for (std::uint32_t i = 0; i < table.count(); ++i) {
      if (!table.has_row(i)) continue;
      const Element& element = table.elements()[i];
      sent += element.area.value * emission[*element.material];
      lost += element.area.value * (1 - reflectivity[*element.material]);
    }
    const double mean = (lost > 0 ? sent / lost : 0) + sky / 2;
    for (std::uint32_t i = 0; i < table.count(); ++i) {
      if (!table.has_row(i)) continue;
      const Element& element = table.elements()[i];
      const Vector3 area = doubled_area(scene.polygons[element.surface]);
      const Direction3 front = unit({to_double(area.x), to_double(area.y), to_double(area.z)});
      const double light = mean * (kAmbient + kAbove * (element.is_back ? -1 : 1) * dot(front, above));
      by_channel[i * paint.channels + c] = emission[*element.material] + reflectivity[*element.material] * light;
    }
    paint.sky.push_back(sky);
  }
  paint.values = std::move(by_channel);
  paint.unknown.assign(paint.channels, 0);
  paint.black.assign(paint.channels, 0);
  return paint;
}

}  // namespace hottel
