// Temporary files and folders: whose they are, and what is left of those whose process is gone.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace hottel {

// The kernel that this process runs on, from one start of it to the next: eight hexadecimal digits; "0" where it does
// not tell.
const std::string& running_kernel();

// Temporary files, folders of commands that were run, and folders of sums.
enum class Abandoned : unsigned char { kFiles, kRunFolders, kSumFolders };

// The name of the k-th temporary file of this process, ".hottel-PID-K-KERNEL.tmp", and what mkdtemp() makes the name of
// a temporary folder of, "hottel-run-PID-KERNEL-XXXXXX" or "hottel-sums-...".
std::string temporary_file_name(int k);
std::string temporary_folder_pattern(Abandoned kind);

// Says to all processes that a temporary file or folder is in use, for as long as the descriptor, or a copy of it, is
// open: by an advisory lock, which ends with the process however that ends. False where somebody has just removed it,
// or is about to, who came before: then another one is to be made. Where a file system has no locks nothing is said,
// and nobody removes anything.
bool hold_temporary(int descriptor, const std::string& path);

// Removes temporary files, or folders, that were left behind in a folder: those of this user that nobody holds and that
// were made under the running kernel, whose locks are told to all of its processes; or under any other one, a day
// ago or longer: some shared disks do not tell one machine of the locks of another. The number of the process decides
// nothing: another one may have it by now. What cannot be removed is left, without a word.
//
//   (1) each folder is looked through once in a process
void remove_abandoned(const std::filesystem::path& folder, Abandoned what);

}  // namespace hottel
