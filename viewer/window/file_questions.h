// What a window says and asks about the file of its scene.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "viewer/window/prompt.h"
#include "viewer/window/watched_file.h"

namespace hottel {

// What follows from news of a file: a message, a question, or that it is to be read now.
struct FileAnswer {
  std::string message{};
  std::optional<Prompt> question{};
  bool is_to_be_read = false;
};

// is_changed: there are unsaved changes, which reading would lose. read: reads the file again.
//
//   (1) a file that is gone is told, and what is in the window stays
//   (2) one that is back is read, but not over unsaved changes: then it is asked, as where another program wrote it
FileAnswer answer_to(FileNews news, const WatchedFile& file, bool is_changed, const std::function<void()>& read);

// The name of the file, with a star where it lacks an edit, and whether it is gone.
std::string title_of(const WatchedFile& file, bool is_changed);

// Whether quitting loses something, and the question then. save: returns what is wrong, or nothing.
bool quitting_loses(const WatchedFile& file, bool is_changed);
Prompt quit_question(const WatchedFile& file, const std::function<std::string()>& save,
                     const std::function<void()>& quit);

}  // namespace hottel
