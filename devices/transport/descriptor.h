#pragma once
// Bytes to an open file descriptor: what standard output, pipes and special files have in common.
#include <memory>
#include <string>
#include <string_view>

#include "devices/transport/transport.h"

namespace overstrike {

/// Writes everything, whatever the descriptor takes at once: continues after short writes and
/// signals, waits when a non-blocking one is full. Throws WorkError "cannot write WHERE: ...".
void write_all(int descriptor, std::string_view bytes, const std::string& where);

enum class Ownership { borrowed, owned };

/// Buffered. `where` names the output in messages. What path_to_write() spools goes to the
/// descriptor at finish(), after what was written. An owned descriptor is closed.
std::unique_ptr<Transport> open_descriptor(int descriptor, Ownership, std::string where);

}  // namespace overstrike
