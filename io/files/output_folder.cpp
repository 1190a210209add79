#include "io/files/output_folder.h"

#include <unistd.h>

#include "io/files/output_file.h"

namespace hottel {

OutputFolder::OutputFolder(const std::filesystem::path& folder) {
  if (folder.empty()) throw OutputError("''", "is no name of a folder");
  std::vector<std::filesystem::path> missing;
  for (std::filesystem::path path = folder; !path.empty() && !std::filesystem::exists(path); path = path.parent_path())
    missing.push_back(path);
  for (auto path = missing.rbegin(); path != missing.rend(); ++path)
    if (std::filesystem::create_directory(*path))
      made_.emplace_back(*path, PendingRemoval(path->string(), Removal::kEmptyFolder));
  if (!std::filesystem::is_directory(folder)) throw OutputError(folder.string(), "is a file, not a folder");
}

OutputFolder::~OutputFolder() {
  while (!made_.empty()) {
    ::rmdir(made_.back().first.c_str());  // fails where something is in it, as it should
    made_.pop_back();
  }
}

}  // namespace hottel
