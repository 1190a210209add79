#include "viewer/window/prompt.h"

#include <stdexcept>

#include "viewer/window/panel.h"

namespace hottel {

void answer_prompt(std::optional<Prompt>& prompt, const WindowEvent& event) {
  if (event.key == "escape") {
    prompt.reset();
    return;
  }
  if (!prompt->keys.empty()) {
    for (const auto& [key, action] : prompt->keys)
      if (key == event.key) {
        const std::function<void()> act = action;
        prompt.reset();
        return act();
      }
    return;
  }
  if (event.key == "backspace") {
    std::string& text = prompt->text;
    while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xC0) == 0x80) text.pop_back();
    if (!text.empty()) text.pop_back();
  } else if (event.key == "u" && event.held.ctrl) {
    prompt->text.clear();
  } else if (event.key == "enter") {
    const Prompt asked = *prompt;
    prompt.reset();
    const std::string problem = asked.answer(asked.text);
    if (problem.empty()) return;
    prompt = asked;
    prompt->problem = problem;
  }
}

Prompt file_prompt(const std::string& question, const std::string& text,
                   const std::function<void(const std::string&)>& use) {
  return Prompt{.question = question, .text = text, .answer = [use](const std::string& name) -> std::string {
                  if (name.empty()) return "a name, please";
                  try {
                    use(name);
                    return "";
                  } catch (const std::runtime_error& error) {
                    return error.what();
                  }
                }};
}

void draw_prompt(PictureCanvas& canvas, const Prompt& prompt, double unit) {
  Panel panel{.lines = {prompt.question}};
  if (prompt.keys.empty()) panel.lines.push_back(prompt.text + "|");
  if (!prompt.problem.empty()) panel.lines.push_back(prompt.problem);
  const double width = canvas.width(), height = canvas.height();
  draw_panel(canvas, panel, {.corner = {width / 2, 0.4 * height}, .is_centred = true, .width = 0.8 * width}, unit);
}

}  // namespace hottel
