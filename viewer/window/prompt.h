// A question in a window, and what is typed.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "viewer/picture/canvas.h"
#include "viewer/window/scroll.h"
#include "viewer/window/window.h"

namespace hottel {

struct Prompt {
  std::string question;
  std::string text{};
  std::string problem{};  // of what was typed last
  // What to do with the text: returns what is wrong with it, or nothing.
  std::function<std::string(const std::string&)> answer{};
  // Instead of a text: single keys, and what each does.
  std::vector<std::pair<std::string, std::function<void()>>> keys{};
  std::size_t behind = 0;    // bytes of the text behind the cursor
  bool is_selected = false;  // all of the text: what is typed replaces it
  // What tab makes of the text; without it the text stays.
  std::function<std::string(const std::string&)> complete{};
};

// Does what a key does to a question: escape drops it, enter answers it, and where the answer is wrong it stays and
// says so; left, right, home and end move the cursor, tab completes the text, backspace and delete take a character, or
// what is selected, ctrl+a selects all of the text, ctrl+u drops it. REQUIRES a question, a kKey.
void answer_prompt(std::optional<Prompt>& prompt, const WindowEvent& event);

// Puts what was typed where the cursor is, or in the place of what is selected.
void type_into(Prompt& prompt, const std::string& text);

// Asks for the name of a file: a name is shown, selected, and tab completes a name as far as the folder tells it. What
// `use` throws as a runtime_error is told as the problem of the name.
Prompt file_prompt(const std::string& question, const std::string& text,
                   const std::function<void(const std::string&)>& use);

// Returns a path completed by the names in its folder: as far as all that begin like it agree, with a / behind a
// folder.
std::string completed_path(const std::string& path);

// Draws the question in the middle of the canvas. unit: of sizes, in pixels.
void draw_prompt(PictureCanvas& canvas, const Prompt& prompt, Scroll& scroll, double unit);

}  // namespace hottel
