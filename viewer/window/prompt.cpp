#include "viewer/window/prompt.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "viewer/window/panel.h"

namespace hottel {
namespace {

bool is_inside_character(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

// Bytes of the character that ends, or begins, there; 0 where there is none.
std::size_t size_before(const std::string& text, std::size_t at) {
  std::size_t from = at;
  while (from > 0 && is_inside_character(text[from - 1])) --from;
  return at - (from > 0 ? from - 1 : 0);
}
std::size_t size_after(const std::string& text, std::size_t at) {
  std::size_t to = std::min(at + 1, text.size());
  while (to < text.size() && is_inside_character(text[to])) ++to;
  return to - at;
}

void clear(Prompt& prompt) {
  prompt.text.clear();
  prompt.behind = 0;
  prompt.is_selected = false;
}

// False for keys that do not move the cursor. From what is selected it goes to one of its ends.
bool move_cursor(Prompt& prompt, const std::string& key) {
  const std::size_t at = prompt.text.size() - prompt.behind;
  const bool was_selected = prompt.is_selected;
  if (key == "home" || (key == "left" && was_selected))
    prompt.behind = prompt.text.size();
  else if (key == "end" || (key == "right" && was_selected))
    prompt.behind = 0;
  else if (key == "left")
    prompt.behind += size_before(prompt.text, at);
  else if (key == "right")
    prompt.behind -= size_after(prompt.text, at);
  else
    return false;
  prompt.is_selected = false;
  return true;
}

void erase(Prompt& prompt, bool is_before) {
  if (prompt.is_selected) return clear(prompt);
  const std::size_t at = prompt.text.size() - prompt.behind;
  const std::size_t size = is_before ? size_before(prompt.text, at) : size_after(prompt.text, at);
  prompt.text.erase(is_before ? at - size : at, size);
  if (!is_before) prompt.behind -= size;
}

void complete(Prompt& prompt) {
  if (prompt.complete) prompt.text = prompt.complete(prompt.text);
  prompt.behind = 0;
  prompt.is_selected = false;
}

}  // namespace

void type_into(Prompt& prompt, const std::string& text) {
  if (prompt.is_selected) clear(prompt);
  prompt.text.insert(prompt.text.size() - prompt.behind, text);
}

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
  if (event.key == "backspace" || event.key == "delete") {
    erase(*prompt, event.key == "backspace");
  } else if (event.held.ctrl && event.key == "u") {
    clear(*prompt);
  } else if (event.held.ctrl && event.key == "a") {
    prompt->is_selected = !prompt->text.empty();
    prompt->behind = 0;
  } else if (event.key == "tab") {
    complete(*prompt);
  } else if (event.key == "enter") {
    const Prompt asked = *prompt;
    prompt.reset();
    const std::string problem = asked.answer(asked.text);
    if (problem.empty()) return;
    prompt = asked;
    prompt->problem = problem;
  } else {
    move_cursor(*prompt, event.key);
  }
}

std::string completed_path(const std::string& path) {
  const std::filesystem::path typed(path), folder = typed.parent_path();
  const std::string begin = typed.filename().string();
  std::optional<std::string> common;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder.empty() ? "." : folder, error)) {
    const std::string name = entry.path().filename().string() + (entry.is_directory(error) ? "/" : "");
    if (!name.starts_with(begin)) continue;
    if (!common) common = name;
    common->resize(static_cast<std::size_t>(std::ranges::mismatch(*common, name).in1 - common->begin()));
  }
  return common ? (folder / *common).string() : path;
}

Prompt file_prompt(const std::string& question, const std::string& text,
                   const std::function<void(const std::string&)>& use) {
  const auto answer = [use](const std::string& name) -> std::string {
    if (name.empty()) return "a name, please";
    try {
      use(name);
      return "";
    } catch (const std::runtime_error& error) {
      return error.what();
    }
  };
  return Prompt{.question = question, .text = text, .answer = answer, .is_selected = true, .complete = completed_path};
}

void draw_prompt(PictureCanvas& canvas, const Prompt& prompt, Scroll& scroll, double unit) {
  Panel panel{.lines = {prompt.question}};
  if (prompt.keys.empty()) {
    std::string text = prompt.text;
    if (!prompt.is_selected) text.insert(text.size() - prompt.behind, "|");
    panel.lines.push_back(text);
    if (prompt.is_selected) panel.marked = 1;
  }
  if (!prompt.problem.empty()) panel.lines.push_back(prompt.problem);
  const double width = canvas.width(), height = canvas.height();
  draw_panel(canvas, panel,
             {.corner = {width / 2, 0.3 * height},
              .is_centred = true,
              .width = 0.9 * width,
              .height = 0.65 * height,
              .scroll = &scroll},
             unit);
}

}  // namespace hottel
