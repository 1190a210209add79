// Texts that are longer than their room, and how far they are scrolled.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/picture/canvas.h"

namespace hottel {

// How far one text is scrolled, and where it was drawn last.
class Scroll {
 public:
  // To be called by who draws: so many lines, for so many of which there is room, in that box. Returns the first line
  // to be drawn: none is left out at the end where others are at the beginning.
  std::size_t draw(std::size_t lines, std::size_t room, const Pixel& low, const Pixel& high);
  // Moves by lines, which may be parts of one; as far as the text goes.
  void move(double lines);
  // Moves by pages, a line of the page before staying in sight.
  void turn(int pages);
  void to_end(bool is_last) { line_ = is_last ? most() : 0; }

  bool has_more() const { return lines_ > room_; }
  bool holds(const Pixel& place) const;
  double line() const { return line_; }
  std::size_t lines() const { return lines_; }
  std::size_t room() const { return room_; }

 private:
  double most() const { return has_more() ? static_cast<double>(lines_ - room_) : 0; }

  double line_ = 0;
  std::size_t lines_ = 0, room_ = 0;
  Pixel low_{}, high_{};
};

// Draws how much of a text is seen, and which part, at the right border of its box; nothing where all is. unit: of
// sizes, in pixels.
void draw_scroll_mark(PictureCanvas& canvas, const Scroll& scroll, const Pixel& low, const Pixel& high, double unit);

// The texts of a window, by name. What was not drawn in the last frame has no place, and begins at its first line when
// it comes back.
class Scrolls {
 public:
  // Before and after a frame is drawn.
  void begin_frame() { drawn_.clear(); }
  void end_frame();
  // The text of that name, to be drawn in this frame. The reference lasts until the text is missing in a frame.
  Scroll& of(const std::string& name);

  // Scrolls what lies there and has more to show than it does. Returns false where there is none.
  bool wheel(const Pixel& place, double notches);
  // Does what pageup, pagedown, home and end do to what lies there; with the arrows to the text of that name, wherever
  // the mouse is. Returns false for other keys, and where there is nothing to be scrolled.
  bool key(std::string_view key, const Pixel& place, const std::string& open = {});
  // Turns a page of what lies there, else of the last that was drawn and has more to show. Returns false where there is
  // none.
  bool turn(int pages, const Pixel& place);

 private:
  Scroll* at(const Pixel& place);

  std::map<std::string, Scroll> texts_;
  std::vector<std::string> drawn_;  // in this frame, in order
};

}  // namespace hottel
