#include "devices/transport/spool.h"

#include <cerrno>
#include <fstream>
#include <vector>

#include "devices/transport/system_error.h"

namespace overstrike {

void Spool::replay(const std::function<void(std::string_view)>& sink) const {
  // By name: the writer may have put another file there.
  std::ifstream in(path(), std::ios::binary);
  if (!in) throw_system_error("cannot read '" + path().string() + "'", errno);
  std::vector<char> piece(1 << 18);
  while (in.read(piece.data(), static_cast<std::streamsize>(piece.size())), in.gcount() > 0)
    sink({piece.data(), static_cast<std::size_t>(in.gcount())});
  if (in.bad()) throw_system_error("cannot read '" + path().string() + "'", errno);
}

}  // namespace overstrike
