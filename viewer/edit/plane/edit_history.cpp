#include "viewer/edit/plane/edit_history.h"

#include <utility>

#include "kernel/support/failure.h"

namespace hottel {

EditHistory2::EditHistory2(ScenePointer scene) : saved_(scene) {
  HOTTEL_REQUIRE(scene != nullptr);
  surfaces_ = scene->surfaces.size();
  states_.push_back({std::move(scene), ""});
}

void EditHistory2::set(Scene2 scene, std::string what) {
  HOTTEL_REQUIRE(!is_dragging());
  push(std::make_shared<const Scene2>(std::move(scene)), std::move(what));
}

void EditHistory2::begin(std::string what) {
  HOTTEL_REQUIRE(!is_dragging());
  dragged_ = std::move(what);
}

void EditHistory2::preview(Scene2 scene) {
  HOTTEL_REQUIRE(is_dragging());
  shown_ = std::make_shared<const Scene2>(std::move(scene));
}

void EditHistory2::commit() {
  HOTTEL_REQUIRE(is_dragging());
  ScenePointer scene = std::exchange(shown_, nullptr);
  std::string what = *std::exchange(dragged_, std::nullopt);
  if (scene) push(std::move(scene), std::move(what));
}

void EditHistory2::cancel() {
  HOTTEL_REQUIRE(is_dragging());
  dragged_.reset();
  shown_.reset();
}

bool EditHistory2::undo() {
  if (!can_undo()) return false;
  if (is_dragging())
    cancel();
  else
    --current_;
  return true;
}

bool EditHistory2::redo() {
  if (!can_redo()) return false;
  ++current_;
  return true;
}

std::string EditHistory2::what_undo() const { return is_dragging() ? *dragged_ : states_[current_].what; }

std::string EditHistory2::what_redo() const { return can_redo() ? states_[current_ + 1].what : ""; }

void EditHistory2::push(ScenePointer scene, std::string what) {
  while (states_.size() > current_ + 1) {
    surfaces_ -= states_.back().scene->surfaces.size();
    states_.pop_back();
  }
  surfaces_ += scene->surfaces.size();
  states_.push_back({std::move(scene), std::move(what)});
  ++current_;
  while (current_ > kMostSteps || (current_ > kLeastSteps && surfaces_ > kMostSurfaces)) forget_oldest();
}

void EditHistory2::forget_oldest() {
  surfaces_ -= states_.front().scene->surfaces.size();
  states_.pop_front();
  states_.front().what.clear();
  --current_;
}

}  // namespace hottel
