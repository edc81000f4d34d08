#pragma once
// Ctrl-C and its like: unfinished files go, then the process.

namespace overstrike {

/// On SIGINT, SIGTERM and SIGHUP: removes temporary files and exits with 128 + the signal's number.
/// Ignores SIGPIPE, so that a closed pipe is an error of write(). Call once, before any thread.
void catch_interrupts();

}  // namespace overstrike
