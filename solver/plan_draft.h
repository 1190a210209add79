// A plan while it is made: effects one after another, those without a dimension ready made.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "solver/plan.h"

namespace hottel {

// What surfaces are called in the words of a plan.
struct SurfaceWords {
  std::string one;     // "edge"
  std::string across;  // where elements show gradients: "along edges"
};

// Adds effects to a plan in the order of the calls. An effect that only `everything` asks for has a reason that says so
// and why the scene does not need it.
//
// REQUIRES that scene and request outlive this.
class PlanDraft {
 public:
  PlanDraft(const SceneTable& scene, const PlanRequest& request, SurfaceWords words);

  // An effect that the scene needs, `why`, or does not, `why_not`. seconds: what it costs where it is used.
  void add(const char* effect, bool is_needed, const std::string& why, const std::string& why_not, double seconds = 0);
  // An effect of which there is what was asked for: that everything is asked for makes it no more.
  void add_as_asked(const char* effect, bool is_asked, const std::string& why, const std::string& why_not,
                    double seconds);

  // Those of the scene's table. is_one_room: one closed room in which every face is seen.
  void add_back_faces();
  void add_sky(bool is_one_room, double seconds, bool is_by_closure = false);
  void add_subdivision();
  void add_channels();
  void add_interreflection(double unknowns, double entries);  // of the matrix, that are not 0
  void add_unreachable(bool is_one_room);
  void add_dividing(double seconds);
  void add_lights(double seconds);  // of one light
  void add_movement(bool moves);

  // "1 edge", "7 edges".
  std::string count_text(std::size_t count) const;
  bool reflects() const;

  Plan take() { return Plan(std::move(effects_)); }

 private:
  template <class Test>
  std::size_t count(const Test& test) const;
  template <class Test>
  bool has_material(const Test& test) const;

  const SceneTable& scene_;
  const PlanRequest& request_;
  SurfaceWords words_;
  std::vector<PlannedEffect> effects_;
};

}  // namespace hottel
