// The scene that is being edited, and those before it.
#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "kernel/support/failure.h"

namespace hottel {

// A row of scenes, one of which is the current one. A step leads from each to the next and says what was done.
//
//   (1) undo and redo bring back the very same scene: the same object
//   (2) all that is shown between begin() and commit() is one step; cancel() leaves none
//   (3) at most kMostSteps steps are kept, fewer where their scenes together have more than kMostSurfaces surfaces, but
//       kLeastSteps in any case: the oldest are forgotten
//   (4) a new step forgets those that were undone
// Scene: a SceneTable with the geometry of a dimension.
template <class Scene>
class EditHistory {
 public:
  static constexpr std::size_t kMostSteps = 300, kLeastSteps = 20, kMostSurfaces = 400'000;

  using ScenePointer = std::shared_ptr<const Scene>;

  // The scene counts as saved. REQUIRES: not null.
  explicit EditHistory(ScenePointer scene) : saved_(scene) {
    HOTTEL_REQUIRE(scene != nullptr);
    surfaces_ = scene->surfaces.size();
    states_.push_back({std::move(scene), ""});
  }
  explicit EditHistory(Scene scene) : EditHistory(std::make_shared<const Scene>(std::move(scene))) {}

  // The current scene: while something is dragged, what it shows.
  const ScenePointer& scene() const { return shown_ ? shown_ : states_[current_].scene; }

  // Makes a step. what: "move a wall". REQUIRES: !is_dragging().
  void set(Scene scene, std::string what) {
    HOTTEL_REQUIRE(!is_dragging());
    push(std::make_shared<const Scene>(std::move(scene)), std::move(what));
  }

  // A drag begins: preview() shows a scene, as often as one likes; commit() makes a step to the one shown last, and
  // none where none was; cancel() goes back to where it began. REQUIRES: begin() that nothing is dragged, the others
  // that something is.
  void begin(std::string what) {
    HOTTEL_REQUIRE(!is_dragging());
    dragged_ = std::move(what);
  }
  void preview(Scene scene) {
    HOTTEL_REQUIRE(is_dragging());
    shown_ = std::make_shared<const Scene>(std::move(scene));
  }
  void commit() {
    HOTTEL_REQUIRE(is_dragging());
    ScenePointer scene = std::exchange(shown_, nullptr);
    std::string what = *std::exchange(dragged_, std::nullopt);
    if (scene) push(std::move(scene), std::move(what));
  }
  void cancel() {
    HOTTEL_REQUIRE(is_dragging());
    dragged_.reset();
    shown_.reset();
  }
  bool is_dragging() const { return dragged_.has_value(); }
  // The scene in which the drag began, and the current one where nothing is dragged.
  const ScenePointer& scene_before_drag() const { return states_[current_].scene; }

  // Each returns false, and does nothing, where there is nothing to undo or redo. While something is dragged, undo()
  // cancels that and redo() does nothing.
  bool undo() {
    if (!can_undo()) return false;
    if (is_dragging())
      cancel();
    else
      --current_;
    return true;
  }
  bool redo() {
    if (!can_redo()) return false;
    ++current_;
    return true;
  }
  bool can_undo() const { return is_dragging() || current_ > 0; }
  bool can_redo() const { return !is_dragging() && current_ + 1 < states_.size(); }
  // What undo() undoes and redo() does again; empty where there is nothing.
  std::string what_undo() const { return is_dragging() ? *dragged_ : states_[current_].what; }
  std::string what_redo() const { return can_redo() ? states_[current_ + 1].what : ""; }

  // The current scene is that of a file now.
  void mark_saved() { saved_ = scene(); }
  // Whether the current scene is another object than the one that was saved: false again after undo leads back to it.
  bool is_changed() const { return scene() != saved_; }

 private:
  struct State {
    ScenePointer scene;
    std::string what;  // the step that leads here
  };

  void push(ScenePointer scene, std::string what) {
    while (states_.size() > current_ + 1) {
      surfaces_ -= states_.back().scene->surfaces.size();
      states_.pop_back();
    }
    surfaces_ += scene->surfaces.size();
    states_.push_back({std::move(scene), std::move(what)});
    ++current_;
    while (current_ > kMostSteps || (current_ > kLeastSteps && surfaces_ > kMostSurfaces)) forget_oldest();
  }
  void forget_oldest() {
    surfaces_ -= states_.front().scene->surfaces.size();
    states_.pop_front();
    states_.front().what.clear();
    --current_;
  }

  std::deque<State> states_;
  std::size_t current_ = 0, surfaces_ = 0;  // of all states
  ScenePointer saved_;
  ScenePointer shown_;                  // by a drag
  std::optional<std::string> dragged_;  // what it does
};

}  // namespace hottel
