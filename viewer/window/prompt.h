// A question in a window, and what is typed.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "viewer/picture/canvas.h"
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
};

// Does what a key does to a question: escape drops it, enter answers it, and where the answer is wrong it stays and
// says so; backspace, and ctrl+u for all of the text. Typed letters are for the owner to add. REQUIRES a question, a
// kKey.
void answer_prompt(std::optional<Prompt>& prompt, const WindowEvent& event);

// Asks for the name of a file. What `use` throws as a runtime_error is told as the problem of the name.
Prompt file_prompt(const std::string& question, const std::string& text,
                   const std::function<void(const std::string&)>& use);

// Draws the question in the middle of the canvas. unit: of sizes, in pixels.
void draw_prompt(PictureCanvas& canvas, const Prompt& prompt, double unit);

}  // namespace hottel
