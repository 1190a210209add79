// Texts that are longer than their room: panels and the help, at any size of the window.
#include "viewer/window/scroll.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <set>
#include <sstream>

#include "viewer/picture/recording_canvas.h"
#include "viewer/window/help.h"
#include "viewer/window/panel.h"
#include "viewer/window/space/commands.h"

namespace hottel::scroll_test {
namespace {

using Kind = RecordingCanvas::Kind;

TEST(Scroll, StaysWithinTheText) {
  Scroll scroll;
  EXPECT_EQ(scroll.draw(20, 5, {0, 0}, {10, 10}), 0u);
  EXPECT_TRUE(scroll.has_more());
  scroll.move(-3);
  EXPECT_EQ(scroll.line(), 0);
  scroll.turn(1);
  EXPECT_EQ(scroll.line(), 4) << "a line of the page before stays";
  scroll.move(1000);
  EXPECT_EQ(scroll.line(), 15);
  EXPECT_EQ(scroll.draw(8, 5, {0, 0}, {10, 10}), 3u) << "a shorter text";
  EXPECT_EQ(scroll.draw(3, 5, {0, 0}, {10, 10}), 0u);
  EXPECT_FALSE(scroll.has_more());
  scroll.to_end(true);
  EXPECT_EQ(scroll.line(), 0);
}

TEST(Scroll, PartsOfALineAddUp) {
  Scroll scroll;
  scroll.draw(20, 5, {0, 0}, {10, 10});
  for (int k = 0; k < 5; ++k) scroll.move(0.25);
  EXPECT_EQ(scroll.draw(20, 5, {0, 0}, {10, 10}), 1u);
}

TEST(Scrolls, TheWheelScrollsWhatLiesThere) {
  Scrolls scrolls;
  scrolls.begin_frame();
  scrolls.of("short").draw(2, 5, {0, 0}, {10, 10});
  scrolls.of("long").draw(20, 5, {100, 0}, {110, 10});
  scrolls.end_frame();
  EXPECT_FALSE(scrolls.wheel({5, 5}, -1));
  EXPECT_FALSE(scrolls.wheel({50, 5}, -1));
  EXPECT_TRUE(scrolls.wheel({105, 5}, -1));
  EXPECT_EQ(scrolls.of("long").line(), 3);
  EXPECT_FALSE(scrolls.key("pagedown", {5, 5}));
  EXPECT_TRUE(scrolls.key("pagedown", {105, 5}));
  EXPECT_EQ(scrolls.of("long").line(), 7);
  EXPECT_FALSE(scrolls.key("down", {105, 5})) << "arrows are for what is open over everything";
  EXPECT_TRUE(scrolls.key("down", {5, 5}, "long"));
  EXPECT_TRUE(scrolls.turn(-1, {5, 5})) << "wherever the mouse is";
  EXPECT_EQ(scrolls.of("long").line(), 4);
  scrolls.begin_frame();
  scrolls.end_frame();
  EXPECT_FALSE(scrolls.wheel({105, 5}, -1)) << "it is not there any more";
  EXPECT_FALSE(scrolls.turn(1, {105, 5}));
}

// What a panel of that many lines writes at each place of its scroll.
TEST(Panel, ShowsEachLineWhenItIsScrolled) {
  std::vector<std::string> lines;
  for (int k = 0; k < 40; ++k) lines.push_back("line " + std::to_string(k));
  Scroll scroll;
  std::set<std::string> seen;
  for (int k = 0; k < 40; ++k) {
    RecordingCanvas canvas(500, 500);
    const double height =
        draw_panel(canvas, {.lines = lines}, {.corner = {0, 0}, .width = 300, .height = 210, .scroll = &scroll}, 1);
    EXPECT_LE(height, 210);
    EXPECT_EQ(canvas.count(Mark::kScaleBar), 2u) << "a mark tells that there is more";
    for (const auto& text : canvas.calls(Mark::kLegend, Kind::kText)) seen.insert(text.text);
    scroll.move(1);
  }
  EXPECT_EQ(seen, std::set<std::string>(lines.begin(), lines.end()));
  RecordingCanvas canvas(500, 500);
  draw_panel(canvas, {.lines = {"all", "of it"}}, {.corner = {0, 0}, .width = 300, .height = 210, .scroll = &scroll},
             1);
  EXPECT_EQ(canvas.count(Mark::kScaleBar), 0u);
}

// Columns for which there is no room: their texts follow each other, and nothing lies beside the box's room.
TEST(Panel, GivesUpColumnsThatDoNotFit) {
  RecordingCanvas canvas(320, 200);
  const std::string name(30, 'n');
  draw_panel(canvas, {.lines = {"head", "0.123456789\t" + name + "\tenclosed"}},
             {.corner = {320, 0}, .is_right = true, .width = 300, .height = 200}, 1);
  for (const auto& text : canvas.calls(Mark::kLegend, Kind::kText)) {
    EXPECT_GE(text.points[0].x, 0) << text.text;
    EXPECT_LE(text.points[1].x, 320) << text.text;
  }
}

std::vector<std::string> words_of(std::string_view text) {
  std::istringstream stream{std::string(text)};
  return {std::istream_iterator<std::string>(stream), {}};
}

bool are_in(const std::set<std::string>& seen, std::string_view text) {
  return std::ranges::all_of(words_of(text), [&](const std::string& word) { return seen.contains(word); });
}

struct HelpCase {
  std::span<const Command> commands;
  std::span<const Gesture> gestures;
};

// Every word of the help is seen somewhere on the way from its beginning to its end, whole, at each scale and size.
TEST(Help, IsSeenWholeAtEachScaleAndSize) {
  for (const HelpCase& help : {HelpCase{commands(), gestures()}, {commands_3(), gestures_3()}})
    for (const double unit : {1.0, 1.5, 2.0})
      for (const auto& [width, height] : {std::pair(640.0, 400.0), {800.0, 600.0}, {1280.0 * unit, 800.0 * unit}}) {
        Scroll scroll;
        std::set<std::string> seen;
        for (bool is_first = true;
             is_first || scroll.line() + static_cast<double>(scroll.room()) < static_cast<double>(scroll.lines());) {
          if (!is_first) scroll.turn(1);
          is_first = false;
          RecordingCanvas canvas(width, height);
          draw_help(canvas, help.commands, help.gestures, scroll, unit);
          for (const auto& text : canvas.calls(Mark::kLegend, Kind::kText)) {
            EXPECT_LE(text.points[1].y, height) << text.text;
            EXPECT_GE(text.points[0].y, 0) << text.text;
            EXPECT_LE(text.points[1].x, width) << text.text;
            EXPECT_GE(text.size, 14 * unit) << "letters keep their size";
            for (const std::string& word : words_of(text.text)) seen.insert(word);
          }
        }
        for (const Command& command : help.commands)
          if (!command.help.empty()) {
            EXPECT_TRUE(are_in(seen, command.help)) << command.name << " " << width << " " << unit;
          }
        for (const Gesture& gesture : help.gestures) {
          EXPECT_TRUE(are_in(seen, gesture.gesture)) << gesture.gesture;
          EXPECT_TRUE(are_in(seen, gesture.help)) << gesture.help;
        }
      }
}

// All commands can be had by letters, digits, arrows, function keys and the like: those of every keyboard.
TEST(Commands, CanBeHadOnEveryKeyboard) {
  const std::set<std::string> named{"space", "enter", "escape", "tab",  "backspace", "delete", "left",
                                    "right", "up",    "down",   "home", "end",       "pageup", "pagedown"};
  const auto is_everywhere = [&](const std::string& key) {
    const bool is_character = key.size() == 1 && (std::isalpha(static_cast<unsigned char>(key[0])) ||
                                                  std::isdigit(static_cast<unsigned char>(key[0])));
    return is_character || named.contains(key) || (key.size() > 1 && key[0] == 'f');
  };
  for (const std::span<const Command> all : {commands(), commands_3()}) {
    std::set<std::string_view> reached, names;
    for (const Command& command : all) {
      names.insert(command.name);
      if (is_everywhere(key_event(command.key).key)) reached.insert(command.name);
    }
    EXPECT_EQ(reached, names);
  }
}

// The help names each of the keys.
TEST(Help, NamesAllKeysOfACommand) {
  RecordingCanvas canvas(1280, 800);
  Scroll scroll;
  draw_help(canvas, commands(), gestures(), scroll, 1);
  for (const char* keys : {"-  f3", "=  f4  shift+=  +", "[  f5", "]  f6", ";  f7", "'  f8", "h  f1"})
    EXPECT_TRUE(canvas.wrote(keys)) << keys;
}

}  // namespace
}  // namespace hottel::scroll_test
