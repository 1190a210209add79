// What is typed into a question.
#include "viewer/window/prompt.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/temporary_folder.h"
#include "viewer/picture/recording_canvas.h"
#include "viewer/window/commands.h"

namespace hottel::prompt_test {
namespace {

class PromptTest : public testing::Test {
 protected:
  void ask(const std::string& text) {
    prompt = file_prompt("save as", text, [this](const std::string& name) { used = name; });
  }
  void press(const char* key) { answer_prompt(prompt, key_event(key)); }
  void type(const std::string& text) { type_into(*prompt, text); }

  std::optional<Prompt> prompt;
  std::string used;
};

TEST_F(PromptTest, WhatIsTypedReplacesTheShownName) {
  ask("old.json");
  type("n");
  EXPECT_EQ(prompt->text, "n");
  type("ew.json");
  press("enter");
  EXPECT_EQ(used, "new.json");
  EXPECT_FALSE(prompt);
}

TEST_F(PromptTest, EnterTakesTheShownName) {
  ask("old.json");
  press("enter");
  EXPECT_EQ(used, "old.json");
}

TEST_F(PromptTest, ArrowsAndEndKeepTheShownName) {
  for (const auto& [key, expected] :
       {std::pair("end", "old.jsonX"), {"right", "old.jsonX"}, {"home", "Xold.json"}, {"left", "Xold.json"}}) {
    ask("old.json");
    press(key);
    type("X");
    EXPECT_EQ(prompt->text, expected) << key;
  }
}

TEST_F(PromptTest, TheCursorGoesByWholeCharacters) {
  ask("a\xC3\xA4\xE2\x82\xAC"
      "b");
  for (const char* key : {"end", "left", "left"}) press(key);
  type("-");
  EXPECT_EQ(prompt->text,
            "a\xC3\xA4-\xE2\x82\xAC"
            "b");
  press("backspace");
  press("backspace");
  EXPECT_EQ(prompt->text,
            "a\xE2\x82\xAC"
            "b");
  press("delete");
  EXPECT_EQ(prompt->text, "ab");
  for (int k = 0; k < 5; ++k) press("right");
  press("delete");
  for (int k = 0; k < 5; ++k) press("left");
  press("backspace");
  EXPECT_EQ(prompt->text, "ab");
}

TEST_F(PromptTest, BackspaceAndDeleteTakeWhatIsSelected) {
  for (const char* key : {"backspace", "delete", "ctrl+u"}) {
    ask("old.json");
    press(key);
    EXPECT_EQ(prompt->text, "") << key;
    type("x");
    EXPECT_EQ(prompt->text, "x") << key;
    press("ctrl+a");
    type("y");
    EXPECT_EQ(prompt->text, "y") << key;
  }
}

TEST_F(PromptTest, EscapeDropsTheQuestion) {
  ask("old.json");
  press("escape");
  EXPECT_FALSE(prompt);
  EXPECT_EQ(used, "");
}

TEST_F(PromptTest, TabCompletesANameAsFarAsTheFolderTellsIt) {
  const TemporaryFolder folder;
  for (const char* name : {"room_one.json", "room_two.json", "stage.json"}) std::ofstream(folder / name) << "x";
  std::filesystem::create_directory(folder / "sub");
  const auto completed = [&](const std::string& name) {
    ask((folder / name).string());
    press("tab");
    EXPECT_FALSE(prompt->is_selected);
    return prompt->text;
  };
  EXPECT_EQ(completed("ro"), (folder / "room_").string());
  EXPECT_EQ(completed("st"), (folder / "stage.json").string());
  EXPECT_EQ(completed("su"), (folder / "sub").string() + "/");
  EXPECT_EQ(completed("none"), (folder / "none").string());
  EXPECT_EQ(completed("no/such/folder"), (folder / "no/such/folder").string());
}

TEST_F(PromptTest, TabKeepsATextThatIsNoName) {
  prompt = Prompt{.question = "goes to", .text = "1, 2"};
  press("tab");
  EXPECT_EQ(prompt->text, "1, 2");
}

TEST_F(PromptTest, WhatIsSelectedIsMarkedAndTheCursorIsSeenElse) {
  ask("old.json");
  Scroll scroll;
  RecordingCanvas marked(640, 400), edited(640, 400);
  draw_prompt(marked, *prompt, scroll, 1);
  EXPECT_TRUE(marked.wrote("old.json"));
  press("home");
  draw_prompt(edited, *prompt, scroll, 1);
  EXPECT_TRUE(edited.wrote("|old.json"));
  using Kind = RecordingCanvas::Kind;
  EXPECT_EQ(marked.calls(Mark::kLegend, Kind::kFill).size(), edited.calls(Mark::kLegend, Kind::kFill).size() + 1);
}

}  // namespace
}  // namespace hottel::prompt_test
