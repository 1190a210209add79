// What a window can be told, its keys, and boxes of text.
#include "viewer/window/commands.h"

#include <gmock/gmock.h>

#include <map>
#include <set>

#include "viewer/picture/recording_canvas.h"
#include "viewer/window/panel.h"

namespace hottel::commands_test {
namespace {

using Kind = RecordingCanvas::Kind;

TEST(Commands, HaveUniqueKeysAndOneHelpEach) {
  std::set<std::string_view> keys;
  std::map<std::string_view, int> rows, keyless;
  std::string_view before;
  for (const Command& command : commands()) {
    EXPECT_NE(command.name, "");
    EXPECT_NE(command.topic, "");
    if (!command.key.empty()) {
      EXPECT_TRUE(keys.insert(command.key).second) << command.key;
    }
    if (rows[command.name]++ > 0) {
      EXPECT_EQ(command.help, "") << command.name;
      EXPECT_NE(command.key, "") << command.name;
      EXPECT_EQ(command.name, before) << "another key stands right below the first one";
    }
    before = command.name;
  }
}

TEST(Commands, OfATopicStandTogether) {
  std::set<std::string_view> topics;
  std::string_view last;
  for (const Command& command : commands()) {
    if (command.topic == last) continue;
    EXPECT_TRUE(topics.insert(command.topic).second) << command.topic;
    EXPECT_NE(command.help, "") << "the first of a topic carries its heading: " << command.name;
    last = command.topic;
  }
  EXPECT_GE(topics.size(), 4u);
}

TEST(Commands, AreFoundByTheirKeys) {
  for (const Command& command : commands())
    if (!command.key.empty()) {
      EXPECT_EQ(command_of_key(command.key), command.name);
    }
  EXPECT_EQ(command_of_key(""), "");
  EXPECT_EQ(command_of_key("ctrl+f12"), "");
  EXPECT_EQ(command_of_key("ctrl+Z"), "");
}

TEST(Commands, KeysAreReadAsTheyAreWritten) {
  for (const Command& command : commands()) {
    if (command.key.empty()) continue;
    const WindowEvent event = key_event(command.key);
    EXPECT_EQ(event.kind, WindowEvent::Kind::kKey);
    EXPECT_EQ(key_text(event), command.key);
  }
  for (int held = 0; held < 8; ++held)
    for (const char* key : {"a", "+", "-", "[", "space", "f12", "pageup"}) {
      const WindowEvent event{.kind = WindowEvent::Kind::kKey,
                              .key = key,
                              .held = {.shift = (held & 1) != 0, .ctrl = (held & 2) != 0, .alt = (held & 4) != 0}};
      const WindowEvent read = key_event(key_text(event));
      EXPECT_EQ(read.key, key);
      EXPECT_EQ(read.held, event.held) << key_text(event);
    }
  EXPECT_EQ(key_text(key_event("shift+ctrl+z")), "ctrl+shift+z");
}

const TextStyle kStyle{.size = 10};  // 5.5 pixels a byte on the recording canvas

TEST(Panel, WrapsAtBlanksAndKeepsAllWords) {
  const RecordingCanvas canvas(500, 500);
  const std::string text = "the quick brown fox jumps over the lazy dog";
  for (double width : {40.0, 60.0, 90.0, 150.0, 1000.0}) {
    std::string again;
    for (const std::string& line : wrapped(canvas, text, kStyle, width)) {
      EXPECT_LE(canvas.text_width(line, kStyle), width);
      EXPECT_FALSE(line.starts_with(' ') || line.ends_with(' ')) << line;
      again += (again.empty() ? "" : " ") + line;
    }
    EXPECT_EQ(again, text) << width;
  }
  EXPECT_THAT(wrapped(canvas, text, kStyle, 1000), testing::ElementsAre(text));
  EXPECT_THAT(wrapped(canvas, "", kStyle, 10), testing::ElementsAre(""));
}

TEST(Panel, CutsWordsThatAreTooLongBetweenWholeCharacters) {
  const RecordingCanvas canvas(500, 500);
  const std::string word = "\xC3\xA4\xC3\xB6\xC3\xBC\xE2\x82\xAC\xC3\x9F\xC3\xA4\xC3\xB6";
  for (double width = 1; width < 90; width += 1.5) {
    std::string again;
    for (const std::string& line : wrapped(canvas, word, kStyle, width)) {
      ASSERT_FALSE(line.empty());
      EXPECT_NE(static_cast<unsigned char>(line[0]) & 0xC0, 0x80) << width;
      again += line;
    }
    EXPECT_EQ(again, word) << width;
  }
}

// The box of the last panel, and whether its texts lie in it.
std::vector<Pixel> box_of(const RecordingCanvas& canvas) {
  const std::vector<Pixel> box = canvas.calls(Mark::kLegend, Kind::kFill).back().points;
  for (const auto& text : canvas.calls(Mark::kLegend, Kind::kText))
    for (const Pixel& p : text.points) {
      EXPECT_GE(p.x, box[0].x);
      EXPECT_LE(p.x, box[2].x);
      EXPECT_GE(p.y, box[0].y);
      EXPECT_LE(p.y, box[2].y);
    }
  return box;
}

TEST(Panel, StandsAtTheCornerThatIsAskedFor) {
  for (int corner = 0; corner < 4; ++corner) {
    RecordingCanvas canvas(500, 500);
    const bool is_right = corner % 2 == 1, is_bottom = corner / 2 == 1;
    const double height = draw_panel(
        canvas, {.lines = {"head", "a line"}},
        {.corner = {250, 250}, .is_right = is_right, .is_bottom = is_bottom, .width = 200, .height = 200}, 1.5);
    const auto box = box_of(canvas);
    EXPECT_EQ(is_right ? box[2].x : box[0].x, 250);
    EXPECT_EQ(is_bottom ? box[2].y : box[0].y, 250);
    EXPECT_EQ(box[2].y - box[0].y, height);
    EXPECT_TRUE(canvas.wrote("head"));
    EXPECT_TRUE(canvas.wrote("a line"));
  }
}

TEST(Panel, SaysHowManyLinesAreMissing) {
  std::vector<std::string> lines;
  for (int k = 0; k < 40; ++k) lines.push_back("line " + std::to_string(k));
  RecordingCanvas canvas(500, 500);
  const double height = draw_panel(canvas, {.lines = lines}, {.corner = {0, 0}, .width = 300, .height = 210}, 1);
  EXPECT_LE(height, 210);
  const auto texts = canvas.calls(Mark::kLegend, Kind::kText);
  const std::size_t shown = texts.size() - 1;
  EXPECT_EQ(texts.back().text, "... and " + std::to_string(40 - shown) + " lines more");
  EXPECT_EQ(texts[shown - 1].text, "line " + std::to_string(shown - 1));
}

TEST(Panel, OfNoLinesIsNothing) {
  RecordingCanvas canvas(500, 500);
  EXPECT_EQ(draw_panel(canvas, {}, {}, 1), 0);
  EXPECT_TRUE(canvas.calls().empty());
}

TEST(Panel, SetsColumnsBeneathEachOther) {
  RecordingCanvas canvas(500, 500);
  draw_panel(canvas, {.lines = {"a\tone", "a longer one\ttwo", "none"}, .is_head_bold = false}, {.corner = {0, 0}}, 1);
  const auto texts = canvas.calls(Mark::kLegend, Kind::kText);
  ASSERT_EQ(texts.size(), 5u);
  EXPECT_EQ(texts[0].points[0].x, texts[2].points[0].x);
  EXPECT_EQ(texts[1].points[0].x, texts[3].points[0].x);
  EXPECT_GT(texts[3].points[0].x, texts[2].points[1].x);
  EXPECT_EQ(texts[4].points[0].x, texts[0].points[0].x);
  box_of(canvas);
}

}  // namespace
}  // namespace hottel::commands_test
