#include "devices/image/image.h"

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>

#include "devices/image/formats.h"
#include "devices/srgb.h"

namespace overstrike {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::string read(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string error_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no error";
}

std::string with_extension(std::string name, const ImageFormat& format) {
  return name.append(format.extensions.front());
}

std::string cannot_write(const fs::path& path) {
  return std::string("cannot write '").append(path.string());
}

/// Density of a test picture: 0 to 1 along each row, another way in each.
float density(int x, int y, int columns) {
  return static_cast<float>((x + 7 * y) % columns) / static_cast<float>(columns - 1);
}

struct Shape {
  int columns, rows;
};

void draw(Device& device, Shape shape) {
  device.begin();
  std::vector<float> row(static_cast<std::size_t>(shape.columns));
  for (int y = 0; y < shape.rows; ++y) {
    for (int x = 0; x < shape.columns; ++x)
      row[static_cast<std::size_t>(x)] = density(x, y, shape.columns);
    device.cells({y, row});
  }
  device.end();
}

class Images : public testing::Test {
 protected:
  Images() {
    std::string name = (fs::temp_directory_path() / "image_test.XXXXXX").string();
    directory_ = ::mkdtemp(name.data());
  }
  ~Images() override { fs::remove_all(directory_); }

  std::unique_ptr<Device> open(const std::string& name, Shape shape, Settings settings = {}) {
    settings.emplace_back("size", std::to_string(shape.columns) + "x" + std::to_string(shape.rows));
    const fs::path path = directory_ / name;
    return image_device().make(settings, path.string(), open_file(path));
  }
  fs::path write(const std::string& name, Shape shape, const Settings& settings = {}) {
    draw(*open(name, shape, settings), shape);
    return directory_ / name;
  }
  std::size_t count() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(directory_), {}));
  }

  fs::path directory_;
};

/// The samples of the file's own type as numbers, channel 0; the spec too.
std::vector<double> samples(const fs::path& path, OIIO::ImageSpec& spec) {
  const auto input = OIIO::ImageInput::open(path.string());
  if (!input) return {};
  spec = input->spec();
  std::vector<float> pixels(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
  input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, pixels.data());
  std::vector<double> result;
  for (std::size_t i = 0; i < pixels.size(); i += static_cast<std::size_t>(spec.nchannels))
    result.push_back(pixels[i]);
  return result;
}

struct Case {
  std::string file;
  std::string depth;
  int most;  ///< largest code; 0: float
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.file << ' ' << c.depth; }

class Exact : public Images, public testing::WithParamInterface<Case> {};

TEST_P(Exact, ValuesComeBack) {
  const Case& c = GetParam();
  const Shape shape{101, 60};
  const fs::path path = write(c.file, shape, {{"depth", c.depth}});
  OIIO::ImageSpec spec;
  const std::vector<double> got = samples(path, spec);
  ASSERT_EQ(got.size(), 101u * 60u);
  EXPECT_EQ(spec.width, shape.columns);
  const SrgbEncoder encode(c.most == 0 ? 255 : c.most);
  for (int y = 0; y < shape.rows; ++y)
    for (int x = 0; x < shape.columns; ++x) {
      const float linear = 1 - density(x, y, shape.columns);
      const double sample = got[static_cast<std::size_t>(y * shape.columns + x)];
      if (c.most == 0)
        ASSERT_EQ(sample, linear);
      else
        ASSERT_EQ(std::lround(sample * c.most), encode(linear)) << x << ' ' << y;
    }
}

INSTANTIATE_TEST_SUITE_P(Formats, Exact,
                         testing::Values(Case{"a.png", "8", 255}, Case{"a.png", "16", 65535},
                                         Case{"a.tif", "8", 255}, Case{"a.tiff", "16", 65535},
                                         Case{"a.tif", "float", 0}, Case{"a.exr", "float", 0},
                                         Case{"a.bmp", "8", 255}, Case{"a.pgm", "8", 255},
                                         Case{"a.ppm", "auto", 255}, Case{"a.tga", "8", 255},
                                         Case{"a.gif", "8", 255}, Case{"a.fits", "8", 255},
                                         Case{"a.fits", "float", 0}, Case{"a.sgi", "8", 255},
                                         Case{"a.bw", "16", 65535}, Case{"a.dib", "8", 255},
                                         Case{"a.zfile", "auto", 0}));

struct Lossy {
  std::string file;
  double worst;  ///< of full scale
};
void PrintTo(const Lossy& c, std::ostream* out) { *out << c.file; }

class Near : public Images, public testing::WithParamInterface<Lossy> {};

TEST_P(Near, ValuesAlmostComeBack) {
  const Shape shape{101, 60};
  OIIO::ImageSpec spec;
  const std::vector<double> got = samples(write(GetParam().file, shape), spec);
  ASSERT_EQ(got.size(), 101u * 60u);
  const SrgbEncoder encode(255);
  const bool real = GetParam().file == "a.hdr";
  double sum = 0;
  for (int y = 0; y < shape.rows; ++y)
    for (int x = 0; x < shape.columns; ++x) {
      const float linear = 1 - density(x, y, shape.columns);
      const double expected = real ? linear : encode(linear) / 255.0;
      sum += std::abs(got[static_cast<std::size_t>(y * shape.columns + x)] - expected);
    }
  EXPECT_LT(sum / static_cast<double>(got.size()), GetParam().worst);
}

// HDR shares an exponent among 8-bit mantissas; the others drop what eyes miss.
INSTANTIATE_TEST_SUITE_P(Formats, Near,
                         testing::Values(Lossy{"a.hdr", 1.0 / 256}, Lossy{"a.jpg", 0.02},
                                         Lossy{"a.jfif", 0.02}, Lossy{"a.webp", 0.02}));

TEST_F(Images, HaveTheSameBytesEveryTime) {
  const Shape shape{64, 40};
  for (const ImageFormat& format : image_formats()) {
    const std::string first = read(write(with_extension("first", format), shape));
    ::sleep(format.name == "openexr" || format.name == "tiff" ? 1 : 0);  // dates count seconds
    const std::string again = read(write(with_extension("again", format), shape));
    EXPECT_FALSE(first.empty());
    EXPECT_TRUE(first == again) << format.name;
  }
}

TEST_F(Images, KeepNoTimeOfDay) {
  for (const char* name : {"a.png", "a.tif", "a.exr", "a.jpg", "a.bmp"}) {
    OIIO::ImageSpec spec;
    samples(write(name, {20, 10}), spec);
    EXPECT_EQ(spec.get_string_attribute("DateTime"), "") << name;
  }
}

TEST_F(Images, PngIsGreyAndSaysSrgb) {
  OIIO::ImageSpec spec;
  const fs::path path = write("a.png", {20, 10});
  samples(path, spec);
  EXPECT_EQ(spec.nchannels, 1);
  EXPECT_EQ(spec.format, OIIO::TypeDesc::UINT8);
  EXPECT_THAT(read(path), HasSubstr("sRGB"));
  samples(write("b.png", {20, 10}, {{"depth", "16"}}), spec);
  EXPECT_EQ(spec.format, OIIO::TypeDesc::UINT16);
  samples(write("a.exr", {20, 10}), spec);
  EXPECT_EQ(spec.get_string_attribute("oiio:ColorSpace"), "Linear");
  EXPECT_EQ(spec.nchannels, 1);
}

TEST_F(Images, LargePngsAreExactToo) {
  const Shape shape{2048, 2048};
  OIIO::ImageSpec spec;
  const std::vector<double> got = samples(write("a.png", shape), spec);
  ASSERT_EQ(got.size(), 2048u * 2048u);
  const SrgbEncoder encode(255);
  for (int y = 0; y < shape.rows; y += 97)
    for (int x = 0; x < shape.columns; ++x)
      ASSERT_EQ(std::lround(got[static_cast<std::size_t>(y * shape.columns + x)] * 255),
                encode(1 - density(x, y, shape.columns)));
}

TEST_F(Images, LayoutIsSquareCellsOfTheAskedSize) {
  const Layout layout = open("a.png", {30, 20})->layout();
  EXPECT_EQ(layout.grid.columns, 30);
  EXPECT_EQ(layout.grid.rows, 20);
  EXPECT_EQ(layout.grid.pitch_x_mm, layout.grid.pitch_y_mm);
  EXPECT_TRUE(layout.cells);
  EXPECT_FALSE(layout.strokes);
  EXPECT_TRUE(layout.hatches.empty());
  EXPECT_EQ(layout.tolerance, 0.05);
  const Grid wide = open("b.png", {30, 20}, {{"aspect", "2"}})->layout().grid;
  EXPECT_EQ(wide.pitch_x_mm, 2 * wide.pitch_y_mm);
}

TEST_F(Images, ToAStreamArePngOrWhatIsAsked) {
  for (const auto& [settings, magic] : {std::pair<Settings, std::string>{{}, "\x89PNG"},
                                        {{{"format", "tif"}}, "II*"},
                                        {{{"format", "jpeg"}}, "\xff\xd8"},
                                        {{{"format", ".EXR"}}, "\x76\x2f\x31\x01"}}) {
    std::string bytes;
    Settings all = settings;
    all.emplace_back("size", "8x4");
    draw(*image_device().make(all, "-", open_memory(bytes)), {8, 4});
    EXPECT_EQ(bytes.substr(0, magic.size()), magic);
  }
}

TEST_F(Images, ThatAreNotFinishedLeaveNothing) {
  for (const ImageFormat& format : image_formats()) {
    auto device = open(with_extension("a", format), {16, 16});
    device->begin();
    const std::vector<float> row(16, 0.5f);
    for (int y = 0; y < 5; ++y) device->cells({y, row});
    testing::internal::CaptureStderr();
    device.reset();
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << format.name;
    EXPECT_EQ(count(), 0u) << format.name;
  }
}

/// No file may grow beyond `bytes`, as on a disk that is almost full.
class LittleRoom {
 public:
  explicit LittleRoom(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    rlimit little = before_;
    little.rlim_cur = bytes;
    ::setrlimit(RLIMIT_FSIZE, &little);
  }
  ~LittleRoom() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int);
};

TEST_F(Images, OnAFullDiskFailAndLeaveNothing) {
  for (const ImageFormat& format : image_formats())
    for (const Shape shape : {Shape{40, 30}, Shape{256, 200}}) {
      const std::string name = with_extension("a", format);
      std::string error;
      {
        const LittleRoom room(100);
        error = error_of([&] { write(name, shape); });
      }
      EXPECT_THAT(error, testing::StartsWith(cannot_write(directory_ / name))) << format.name;
      EXPECT_EQ(count(), 0u) << format.name;
    }
}

TEST_F(Images, OnAFullDiskSayWhatTheSystemSays) {
  const LittleRoom room(100);
  EXPECT_EQ(error_of([&] {
              write("a.png", {256, 200});
            }),
            cannot_write(directory_ / "a.png") + "': File too large");
}

TEST_F(Images, OfUnknownFormatsNameTheKnown) {
  const auto make = [](const Settings& settings, const char* output) {
    std::string bytes;
    return error_of([&] { image_device().make(settings, output, open_memory(bytes)); });
  };
  EXPECT_THAT(make({}, "a.xyz"),
              testing::StartsWith("error: 'xyz' is no picture format that is known (known are png, "
                                  "exr, tif, tiff, jpg, "));
  EXPECT_THAT(make({{"format", "bitmap"}}, "-"), HasSubstr("'bitmap' is no picture format"));
  EXPECT_EQ(make({{"depth", "16"}}, "a.jpg"),
            "error: depth must be one that jpeg holds (8), found '16'");
  EXPECT_EQ(make({{"depth", "8"}}, "a.exr"),
            "error: depth must be one that openexr holds (float), found '8'");
  EXPECT_EQ(make({{"depth", "float"}}, "a.png"),
            "error: depth must be one that png holds (8, 16), found 'float'");
  EXPECT_EQ(make({{"depth", "12"}}, "a.png"),
            "error: depth must be one of auto, 8, 16, float, found '12' (did you mean '16'?)");
  EXPECT_EQ(make({{"size", "10x20000"}}, "a.webp"),
            "error: size must be COLUMNSxROWS, each between 1 and 16383, found '10x20000'");
  EXPECT_EQ(make({{"size", "65536x65536"}}, "a.png"), "no error");
  EXPECT_EQ(make({{"aspect", "0"}}, "a.png"),
            "error: aspect must be a number between 0.1 and 10, found '0'");
}

}  // namespace
}  // namespace overstrike
