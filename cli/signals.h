// What the program does when the system asks it to stop.
#pragma once

namespace hottel {

// Ctrl-C, termination and hang-up ask for a stop (kernel/support/interrupt.h): what was computed is committed to a
// store then. Work that does not heed it within a second, or a second signal, ends the process there and then; with
// ends_at_first the first one does. The exit code is 128 + signal, 130 for Ctrl-C; temporary files and folders
// (io/files/pending_removal.h) are removed in each case. A closed pipe and an exceeded file size become errors of the
// write.
void install_signal_handlers(bool ends_at_first);

// The exit code of a program that was asked to stop, and did.
int code_of_interruption();

}  // namespace hottel
