#include "viewer/window/file_questions.h"

namespace hottel {

FileAnswer answer_to(FileNews news, const WatchedFile& file, bool is_changed, const std::function<void()>& read) {
  const std::string name = file.path().filename().string();
  if (news == FileNews::kNone) return {};
  if (news == FileNews::kGone)
    return {.message = name + " is gone, or cannot be read; what is here stays: ctrl+s writes it again"};
  if (news == FileNews::kBack && !is_changed) return {.message = name + " is there again", .is_to_be_read = true};
  const std::string lost = is_changed ? " (your changes are lost)" : "";
  return {.question = Prompt{.question = name + (news == FileNews::kBack ? " is there again" : " has changed on disk") +
                                         ":  r  read it" + lost + "   escape  keep what is here",
                             .keys = {{"r", read}}}};
}

std::string title_of(const WatchedFile& file, bool is_changed) {
  return file.path().filename().string() + (is_changed ? " *" : "") + (file.is_gone() ? " (gone)" : "");
}

bool quitting_loses(const WatchedFile& file, bool is_changed) { return is_changed || file.is_gone(); }

Prompt quit_question(const WatchedFile& file, const std::function<std::string()>& save,
                     const std::function<void()>& quit) {
  const std::string what = file.is_gone() ? "the file is gone" : "unsaved changes";
  const auto save_and_quit = [save, quit] {
    if (save().empty()) quit();
  };
  return Prompt{.question = what + ":  s  save and quit   d  " +
                            (file.is_gone() ? "quit without it" : "drop them and quit") + "   escape  stay",
                .keys = {{"s", save_and_quit}, {"d", quit}}};
}

}  // namespace hottel
