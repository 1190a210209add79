#include "viewer/window/scroll.h"

#include <algorithm>

#include "viewer/picture/palette.h"

namespace hottel {
namespace {

constexpr double kLinesPerNotch = 3;
constexpr double kMarkWidth = 4, kMarkSides = 3, kLeastMark = 10;  // units

}  // namespace

std::size_t Scroll::draw(std::size_t lines, std::size_t room, const Pixel& low, const Pixel& high) {
  lines_ = lines;
  room_ = room;
  low_ = low;
  high_ = high;
  line_ = std::min(line_, most());
  return static_cast<std::size_t>(line_);
}

void Scroll::move(double lines) { line_ = std::clamp(line_ + lines, 0.0, most()); }

void Scroll::turn(int pages) { move(pages * std::max(1.0, static_cast<double>(room_) - 1)); }

bool Scroll::holds(const Pixel& place) const {
  return low_.x <= place.x && place.x <= high_.x && low_.y <= place.y && place.y <= high_.y;
}

void draw_scroll_mark(PictureCanvas& canvas, const Scroll& scroll, const Pixel& low, const Pixel& high, double unit) {
  if (!scroll.has_more()) return;
  const double right = high.x - kMarkSides * unit, left = right - kMarkWidth * unit;
  const double top = low.y + kMarkSides * unit, height = std::max(0.0, high.y - low.y - 2 * kMarkSides * unit);
  const double all = static_cast<double>(scroll.lines());
  const double mark = std::min(height, std::max(kLeastMark * unit, height * static_cast<double>(scroll.room()) / all));
  const double share = scroll.line() / (all - static_cast<double>(scroll.room()));
  const double begin = top + share * (height - mark);
  canvas.fill_rectangle(Mark::kScaleBar, {left, top}, {right, top + height}, palette::kInk.with_alpha(0.12));
  canvas.fill_rectangle(Mark::kScaleBar, {left, begin}, {right, begin + mark}, palette::kInk.with_alpha(0.6));
}

void Scrolls::end_frame() {
  std::erase_if(texts_, [this](const auto& text) { return std::ranges::find(drawn_, text.first) == drawn_.end(); });
}

Scroll& Scrolls::of(const std::string& name) {
  drawn_.push_back(name);
  return texts_[name];
}

// The last one that was drawn there.
Scroll* Scrolls::at(const Pixel& place) {
  Scroll* found = nullptr;
  for (const std::string& name : drawn_)
    if (texts_[name].holds(place)) found = &texts_[name];
  return found != nullptr && found->has_more() ? found : nullptr;
}

bool Scrolls::wheel(const Pixel& place, double notches) {
  Scroll* const text = at(place);
  if (text != nullptr) text->move(-kLinesPerNotch * notches);
  return text != nullptr;
}

bool Scrolls::key(std::string_view key, const Pixel& place, const std::string& open) {
  const auto found = texts_.find(open);
  Scroll* const text = found != texts_.end() ? &found->second : at(place);
  if (text == nullptr) return false;
  if (key == "pageup" || key == "pagedown")
    text->turn(key == "pageup" ? -1 : 1);
  else if (key == "home" || key == "end")
    text->to_end(key == "end");
  else if ((key == "up" || key == "down") && found != texts_.end())
    text->move(key == "up" ? -1 : 1);
  else
    return false;
  return true;
}

bool Scrolls::turn(int pages, const Pixel& place) {
  Scroll* text = at(place);
  for (const std::string& name : drawn_)
    if (at(place) == nullptr && texts_[name].has_more()) text = &texts_[name];
  if (text != nullptr) text->turn(pages);
  return text != nullptr;
}

}  // namespace hottel
