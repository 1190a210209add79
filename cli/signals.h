// What the program does when the system asks it to stop.
#pragma once

namespace hottel {

// Ctrl-C asks for a stop (kernel/support/interrupt.h). Work that does not heed it within a second, or a second Ctrl-C,
// ends the process there and then with 130; termination and hang-up end it at once with 128 + signal; temporary files
// and folders (io/files/pending_removal.h) are removed in each case. A closed pipe and an exceeded file size become
// errors of the write.
void install_signal_handlers();

}  // namespace hottel
