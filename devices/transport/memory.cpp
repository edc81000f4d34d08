#include <optional>
#include <utility>

#include "devices/transport/spool.h"
#include "devices/transport/transport.h"

namespace overstrike {
namespace {

class Memory final : public Transport {
 public:
  explicit Memory(std::string& bytes) : target_(bytes) {}

  void write(std::string_view bytes) override { bytes_ += bytes; }

  void finish() override {
    if (spool_) spool_->replay([this](std::string_view piece) { bytes_ += piece; });
    target_ = std::move(bytes_);
  }

  std::filesystem::path path_to_write() override {
    if (!spool_) spool_.emplace();
    return spool_->path();
  }

 private:
  std::string& target_;
  std::string bytes_;
  std::optional<Spool> spool_;
};

}  // namespace

std::unique_ptr<Transport> open_memory(std::string& bytes) {
  return std::make_unique<Memory>(bytes);
}

}  // namespace overstrike
