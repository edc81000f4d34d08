// The module that links OpenImageIO (module.h): writes grey pictures row by row.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "devices/image/module.h"

namespace {

/// A file that remembers its first failure and goes on as if it had taken everything: libjpeg ends
/// the program when a write fails, and others lose the error in a buffer.
class CarefulFile final : public OIIO::Filesystem::IOProxy {
 public:
  explicit CarefulFile(const char* path)
      : IOProxy(path, Write), file_(std::fopen(path, "w+b")), error_(file_ ? 0 : errno) {}
  ~CarefulFile() override {
    if (file_) std::fclose(file_);
  }

  const char* proxytype() const override { return "overstrike"; }
  bool opened() const override { return file_ != nullptr; }
  int64_t tell() override { return position_; }
  bool seek(int64_t offset) override {
    position_ = offset;
    return true;
  }
  size_t read(void* bytes, size_t count) override {
    const size_t done = pread(bytes, count, position_);
    position_ += static_cast<int64_t>(done);
    return done;
  }
  size_t write(const void* bytes, size_t count) override {
    pwrite(bytes, count, position_);
    position_ += static_cast<int64_t>(count);
    return count;
  }
  size_t pread(void* bytes, size_t count, int64_t offset) override {
    at_ = -1;
    const size_t done = go_to(offset) ? std::fread(bytes, 1, count, file_) : 0;
    at_ = -1;
    return done;
  }
  size_t pwrite(const void* bytes, size_t count, int64_t offset) override {
    if (count == 0) return 0;
    if (go_to(offset) && std::fwrite(bytes, 1, count, file_) != count) fail();
    at_ = error_ ? -1 : offset + static_cast<int64_t>(count);
    if (at_ > size_) size_ = at_;
    return count;
  }
  size_t size() const override { return static_cast<size_t>(size_); }
  void flush() const override {}

  /// Everything is with the system; the failure's number or 0.
  int finish() {
    if (file_ && std::fflush(file_) != 0) fail();
    if (file_ && std::fclose(file_) != 0) fail();
    file_ = nullptr;
    return error_;
  }
  int error() const { return error_; }
  /// From now on nothing is written.
  void give_up() {
    if (error_ == 0) error_ = ECANCELED;
  }

 private:
  // Seeking empties the buffer: only where needed, and always between reading and writing.
  bool go_to(int64_t offset) {
    if (error_) return false;
    if (offset == at_) return true;
    if (::fseeko(file_, offset, SEEK_SET) != 0) fail();
    at_ = -1;
    return error_ == 0;
  }
  void fail() {
    if (error_ == 0) error_ = errno ? errno : EIO;
  }

  std::FILE* file_;
  int error_;
  int64_t position_ = 0, size_ = 0;
  int64_t at_ = 0;  ///< where the next byte written goes without seeking; -1: unknown
};

struct Writer {
  OIIO::ImageSpec spec;
  std::string path;
  std::unique_ptr<CarefulFile> file;  ///< none for formats that open files themselves
  std::unique_ptr<OIIO::ImageOutput> output;
  int row = 0;
  std::vector<char> repeated;  ///< one row of `channels` equal samples
};

void say(char* error, std::size_t size, const std::string& text) {
  if (size > 0) std::snprintf(error, size, "%s", text.c_str());
}

std::string first_line(const std::string& text, const char* otherwise) {
  return text.empty() ? otherwise : text.substr(0, text.find('\n'));
}

OIIO::ImageSpec spec_of(const OverstrikeImageRequest& request) {
  const OIIO::TypeDesc type = request.bits == 8    ? OIIO::TypeDesc::UINT8
                              : request.bits == 16 ? OIIO::TypeDesc::UINT16
                                                   : OIIO::TypeDesc::FLOAT;
  OIIO::ImageSpec spec(request.width, request.height, request.channels, type);
  // TIFF's writer puts "sRGB" into an Exif directory, for which it would have to read the file.
  if (std::string(request.format) != "tiff")
    spec.attribute("oiio:ColorSpace", request.bits == 32 ? "Linear" : "sRGB");
  // An empty date keeps OpenEXR's and TIFF's writers from putting in the time of day.
  spec.attribute("DateTime", "");
  if (std::string(request.format) == "sgi") {
    // Its writer leaves what the name does not fill of the header's 80 bytes uninitialised.
    constexpr std::size_t kLongestSgiName = 79;
    spec.attribute("ImageDescription", std::string(kLongestSgiName, ' '));
  }
  if (request.pixel_aspect != 1)
    spec.attribute("PixelAspectRatio", static_cast<float>(request.pixel_aspect));
  if (request.fast) {
    constexpr int kNoFilter = 8;  // PNG_FILTER_NONE
    spec.attribute("png:compressionLevel", 1);
    spec.attribute("png:filter", kNoFilter);
  }
  return spec;
}

std::unique_ptr<Writer> open_writer(const OverstrikeImageRequest& request, std::string& error) {
  auto writer = std::make_unique<Writer>();
  writer->spec = spec_of(request);
  writer->path = request.path;
  writer->output = OIIO::ImageOutput::create(request.format);
  if (!writer->output) {
    error = first_line(OIIO::geterror(), "OpenImageIO does not write this format");
    return nullptr;
  }
  if (writer->output->supports("ioproxy")) {
    writer->file = std::make_unique<CarefulFile>(request.path);
    writer->output->set_ioproxy(writer->file.get());
  }
  const bool open =
      (!writer->file || writer->file->opened()) && writer->output->open(writer->path, writer->spec);
  if (writer->file && writer->file->error() != 0)
    error = std::strerror(writer->file->error());
  else if (!open)
    error = first_line(writer->output->geterror(), "the format's writer gives no reason");
  else if (writer->output->spec().format != writer->spec.format)
    error = "the format has no samples of this type";
  return error.empty() ? std::move(writer) : nullptr;
}

const void* repeat(Writer& writer, const void* samples) {
  const int channels = writer.spec.nchannels;
  if (channels == 1) return samples;
  const std::size_t size = writer.spec.format.size();
  writer.repeated.resize(writer.spec.scanline_bytes());
  const char* from = static_cast<const char*>(samples);
  char* to = writer.repeated.data();
  for (int x = 0; x < writer.spec.width; ++x, from += size)
    for (int c = 0; c < channels; ++c, to += size) std::memcpy(to, from, size);
  return writer.repeated.data();
}

bool write_one(Writer& writer, const void* samples, std::string& error) {
  const bool written =
      writer.output->write_scanline(writer.row++, 0, writer.spec.format, repeat(writer, samples));
  if (writer.file && writer.file->error() != 0)
    error = std::strerror(writer.file->error());
  else if (!written)
    error = first_line(writer.output->geterror(), "the format's writer gives no reason");
  return error.empty();
}

/// For formats whose writers open files themselves and say nothing of a full disk.
bool can_be_read(const Writer& writer) {
  const auto input = OIIO::ImageInput::open(writer.path);
  if (!input || input->spec().height != writer.spec.height) return false;
  std::vector<float> row(static_cast<std::size_t>(input->spec().width) *
                         static_cast<std::size_t>(input->spec().nchannels));
  for (int y = 0; y < writer.spec.height; ++y)
    if (!input->read_scanline(y, 0, OIIO::TypeDesc::FLOAT, row.data())) return false;
  return true;
}

bool close_all(Writer& writer, std::string& error) {
  if (!writer.output->close())
    error = first_line(writer.output->geterror(), "the format's writer gives no reason");
  writer.output.reset();
  if (const int failed = writer.file ? writer.file->finish() : 0; failed != 0)
    error = std::strerror(failed);
  if (!writer.file && error.empty() && !can_be_read(writer))
    error = "it came out incomplete; is the disk full?";
  OIIO::geterror();  // what reading left
  return error.empty();
}

/// libpng complains on stderr of a file that is closed before its first block of data is full (8
/// kB, which 8 MB of white may squeeze into): gives it the rest of the picture or enough of it.
/// Nothing reaches the disk.
void say_something(Writer& writer) {
  constexpr std::size_t kEnough = std::size_t{1} << 24;
  if (!writer.file) return;
  writer.file->give_up();
  const std::vector<char> row(writer.spec.scanline_bytes());
  for (std::size_t bytes = 0; writer.row < writer.spec.height && bytes < kEnough;
       bytes += row.size())
    if (!writer.output->write_scanline(writer.row++, 0, writer.spec.format, row.data())) return;
}

/// Runs `work(text)`; whatever it throws becomes text.
template <typename Work>
auto guarded(char* error, std::size_t size, Work&& work)
    -> decltype(work(std::declval<std::string&>())) {
  std::string text;
  try {
    auto result = work(text);
    if (!text.empty()) say(error, size, text);
    return result;
  } catch (const std::exception& failure) {
    say(error, size, failure.what());
  } catch (...) {
    say(error, size, "an unknown failure");
  }
  return {};
}

void* open(const OverstrikeImageRequest* request, char* error, std::size_t size) {
  return guarded(error, size,
                 [&](std::string& text) -> void* { return open_writer(*request, text).release(); });
}

int write_row(void* writer, const void* samples, char* error, std::size_t size) {
  return guarded(error, size, [&](std::string& text) -> int {
    return write_one(*static_cast<Writer*>(writer), samples, text);
  });
}

int close(void* writer, char* error, std::size_t size) {
  const std::unique_ptr<Writer> owned(static_cast<Writer*>(writer));
  return guarded(error, size, [&](std::string& text) -> int { return close_all(*owned, text); });
}

void abandon(void* writer) {
  Writer& unfinished = *static_cast<Writer*>(writer);
  char ignored[1];
  guarded(ignored, sizeof ignored, [&](std::string&) -> int {
    say_something(unfinished);
    return 1;
  });
  close(writer, ignored, sizeof ignored);
}

}  // namespace

extern "C" __attribute__((visibility("default"))) const OverstrikeImageModule*
overstrike_image_module() {
  static const OverstrikeImageModule module = {OVERSTRIKE_IMAGE_ABI, open, write_row, close,
                                               abandon};
  return &module;
}
