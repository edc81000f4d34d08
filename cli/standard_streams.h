#pragma once
// Standard streams that whoever started the command has closed (`overstrike ... >&-`).

namespace overstrike {

/// Fills the descriptors 0, 1 and 2 that are closed, so that no file opened later takes their
/// numbers and gets the picture or the messages. What fills them refuses to be read or written
/// (EBADF), as the closed ones would. Call once, before anything opens a file.
void fill_closed_standard_streams();

}  // namespace overstrike
