#include "devices/transport/transport.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <functional>
#include <iterator>
#include <thread>

#include "core/error.h"
#include "devices/transport/descriptor.h"

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
  } catch (const WorkError& error) {
    return error.what();
  }
  return "no error";
}

class Files : public testing::Test {
 protected:
  Files() {
    std::string name = (fs::temp_directory_path() / "transport_test.XXXXXX").string();
    directory_ = ::mkdtemp(name.data());
  }
  ~Files() override { fs::remove_all(directory_); }
  std::size_t count() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(directory_), {}));
  }
  fs::path directory_;
};

TEST_F(Files, GetTheirNameAtFinish) {
  const fs::path path = directory_ / "page.txt";
  auto transport = open_file(path);
  transport->write("one ");
  EXPECT_FALSE(fs::exists(path));
  transport->write(std::string(200000, 'x'));
  transport->write(" two");
  transport->finish();
  EXPECT_EQ(read(path), "one " + std::string(200000, 'x') + " two");
  EXPECT_EQ(count(), 1u);
}

TEST_F(Files, StandBesideTheTargetWithItsExtension) {
  const auto transport = open_file(directory_ / "picture.png");
  const fs::path path = transport->path_to_write();
  EXPECT_EQ(path.parent_path(), directory_);
  EXPECT_EQ(path.extension(), ".png");
  EXPECT_THAT(path.filename().string(), testing::MatchesRegex("\\.picture\\.[a-z2-7]{6}\\.png"));
}

TEST_F(Files, WrittenByNameBecomeTheOutput) {
  auto transport = open_file(directory_ / "picture.png");
  std::ofstream(transport->path_to_write()) << "pixels";
  transport->finish();
  EXPECT_EQ(read(directory_ / "picture.png"), "pixels");
  EXPECT_EQ(count(), 1u);
}

TEST_F(Files, LeaveTheOldFileWhenTheyAreNotFinished) {
  const fs::path path = directory_ / "page.txt";
  std::ofstream(path) << "old";
  try {
    auto transport = open_file(path);
    transport->write("half");
    throw WorkError("the work failed");
  } catch (const WorkError&) {
  }
  EXPECT_EQ(read(path), "old");
  EXPECT_EQ(count(), 1u);
}

TEST_F(Files, AreRemovedByASignalHandler) {
  auto first = open_file(directory_ / "a.txt");
  auto second = open_file(directory_ / "b.txt");
  std::ofstream(directory_ / "done.txt") << "done";
  open_file(directory_ / "c.txt")->finish();
  EXPECT_EQ(count(), 4u);
  remove_unfinished_files();
  EXPECT_EQ(count(), 2u);
  EXPECT_THAT(error_of([&] { first->finish(); }), HasSubstr("No such file or directory"));
}

TEST_F(Files, AreRemovedWhenAProgramIsInterrupted) {
  const auto draw = [this] {
    ::signal(SIGINT, [](int) {
      remove_unfinished_files();
      ::_exit(130);
    });
    auto transport = open_file(directory_ / "page.txt");
    transport->write("half");
    ::raise(SIGINT);
  };
  EXPECT_EXIT(draw(), testing::ExitedWithCode(130), "");
  EXPECT_EQ(count(), 0u);
}

TEST_F(Files, HaveTheModeOfTheUmask) {
  const mode_t before = ::umask(027);
  open_file(directory_ / "page.txt")->finish();
  ::umask(before);
  struct stat status {};
  ASSERT_EQ(::stat((directory_ / "page.txt").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777u, 0640u);
}

TEST_F(Files, FollowLinks) {
  std::ofstream(directory_ / "page.txt") << "old";
  fs::create_symlink("page.txt", directory_ / "link.txt");
  fs::create_symlink("new.txt", directory_ / "dangling.txt");
  for (const char* name : {"link.txt", "dangling.txt"}) {
    auto transport = open_file(directory_ / name);
    transport->write("new");
    transport->finish();
    EXPECT_TRUE(fs::is_symlink(directory_ / name));
  }
  EXPECT_EQ(read(directory_ / "page.txt"), "new");
  EXPECT_EQ(read(directory_ / "new.txt"), "new");
}

TEST_F(Files, WithLongNamesAreFine) {
  const fs::path path = directory_ / (std::string(251, 'n') + ".txt");
  open_file(path)->finish();
  EXPECT_TRUE(fs::exists(path));
}

TEST_F(Files, ThatCannotBeSayWhy) {
  const auto open = [](const fs::path& path) { return error_of([&] { open_file(path); }); };
  const std::string d = directory_.string();
  EXPECT_EQ(open(directory_ / "none" / "a.txt"),
            "cannot write '" + d + "/none/a.txt': No such file or directory");
  EXPECT_EQ(open(directory_), "cannot write '" + d + "': Is a directory");
  EXPECT_EQ(open(d + "/"), "cannot write '" + d + "/': Is a directory");
  EXPECT_EQ(open(""), "cannot write '': No such file or directory");
  std::ofstream(directory_ / "file") << "x";
  EXPECT_EQ(open(directory_ / "file" / "a.txt"),
            "cannot write '" + d + "/file/a.txt': Not a directory");
  EXPECT_EQ(open(directory_ / (std::string(300, 'n') + ".txt")),
            "cannot write '" + d + "/" + std::string(300, 'n') + ".txt': File name too long");
  fs::create_symlink("circle", directory_ / "circle");
  EXPECT_THAT(open(directory_ / "circle"), HasSubstr("Too many levels of symbolic links"));
  if (::geteuid() == 0) return;  // root may write anywhere
  ::chmod((directory_ / "file").c_str(), 0444);
  EXPECT_EQ(open(directory_ / "file"), "cannot write '" + d + "/file': Permission denied");
}

TEST_F(Files, GoneFromUnderTheirNameSayWhy) {
  fs::create_directory(directory_ / "sub");
  auto transport = open_file(directory_ / "sub" / "a.txt");
  fs::remove_all(directory_ / "sub");
  EXPECT_EQ(error_of([&] { transport->finish(); }),
            "cannot write '" + directory_.string() + "/sub/a.txt': No such file or directory");
}

TEST(SpecialFiles, AreWrittenAsTheyStand) {
  auto transport = open_file("/dev/null");
  transport->write("gone");
  transport->finish();
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(SpecialFiles, ThatAreFullSaySo) {
  auto transport = open_file("/dev/full");
  transport->write("little");
  EXPECT_EQ(error_of([&] { transport->finish(); }),
            "cannot write '/dev/full': No space left on device");
  EXPECT_EQ(error_of([&] { open_file("/dev/full")->write(std::string(1 << 20, 'x')); }),
            "cannot write '/dev/full': No space left on device");
  auto by_name = open_file("/dev/full");
  std::ofstream(by_name->path_to_write()) << "pixels";
  EXPECT_EQ(error_of([&] { by_name->finish(); }),
            "cannot write '/dev/full': No space left on device");
}

TEST_F(Files, ThatAreFifosAreWrittenAsTheyStand) {
  const fs::path path = directory_ / "fifo";
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  std::string got;
  std::thread reader([&] { got = read(path); });
  auto transport = open_file(path);
  transport->write("through");
  transport->finish();
  transport.reset();
  reader.join();
  EXPECT_EQ(got, "through");
  EXPECT_TRUE(fs::is_fifo(path));
}

TEST(Memory, HasTheBytesAtFinish) {
  std::string bytes = "before";
  auto transport = open_memory(bytes);
  transport->write("a");
  transport->write("b");
  EXPECT_EQ(bytes, "before");
  transport->finish();
  EXPECT_EQ(bytes, "ab");
}

TEST(Memory, TakesAFileWrittenByName) {
  std::string bytes;
  auto transport = open_memory(bytes);
  const fs::path path = transport->path_to_write();
  EXPECT_EQ(transport->path_to_write(), path);
  std::ofstream(path) << std::string(1000000, 'p');
  transport->finish();
  transport.reset();
  EXPECT_EQ(bytes, std::string(1000000, 'p'));
  EXPECT_FALSE(fs::exists(path));
}

/// Standard output is another file for a while.
class StandardOutput {
 public:
  explicit StandardOutput(int instead) : saved_(::dup(STDOUT_FILENO)) {
    if (instead >= 0)
      ::dup2(instead, STDOUT_FILENO);
    else
      ::close(STDOUT_FILENO);
  }
  ~StandardOutput() {
    ::dup2(saved_, STDOUT_FILENO);
    ::close(saved_);
  }

 private:
  int saved_;
};

std::string write_to_stdout(int instead, std::string_view bytes) {
  const StandardOutput redirected(instead);
  return error_of([&] {
    auto transport = open_stdout();
    transport->write(bytes);
    transport->finish();
  });
}

TEST(Stdout, SaysWhatFails) {
  EXPECT_EQ(write_to_stdout(-1, "x"), "cannot write to standard output: Bad file descriptor");
  const int full = ::open("/dev/full", O_WRONLY);
  EXPECT_EQ(write_to_stdout(full, "x"), "cannot write to standard output: No space left on device");
  ::close(full);
  ::signal(SIGPIPE, SIG_IGN);
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  ::close(ends[0]);
  EXPECT_EQ(write_to_stdout(ends[1], "x"), "cannot write to standard output: Broken pipe");
  ::close(ends[1]);
}

TEST(Stdout, GetsTheBytes) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  EXPECT_EQ(write_to_stdout(ends[1], "page"), "no error");
  ::close(ends[1]);
  char bytes[8] = {};
  EXPECT_EQ(::read(ends[0], bytes, sizeof bytes), 4);
  EXPECT_STREQ(bytes, "page");
  ::close(ends[0]);
}

/// Sends `bytes` through a pipe of `flags` to a reader that takes odd pieces.
std::string through_pipe(int flags, const std::string& bytes) {
  int ends[2];
  if (::pipe2(ends, flags) != 0) return "no pipe";
  ::fcntl(ends[0], F_SETFL, 0);
  std::string got;
  std::thread reader([&] {
    char piece[3001];
    for (ssize_t n; (n = ::read(ends[0], piece, sizeof piece)) != 0;)
      if (n > 0) got.append(piece, static_cast<std::size_t>(n));
  });
  auto transport = open_descriptor(ends[1], Ownership::owned, "to the pipe");
  transport->write(bytes);
  transport->finish();
  reader.join();
  ::close(ends[0]);
  return got;
}

std::string many_bytes() {
  std::string bytes;
  for (unsigned i = 0; bytes.size() < 4000000; ++i) bytes += std::to_string(i * 2654435761u);
  return bytes;
}

TEST(Descriptor, WaitsWhenItIsFull) {
  EXPECT_TRUE(through_pipe(O_NONBLOCK, many_bytes()) == many_bytes());
}

TEST(Descriptor, ContinuesAfterSignals) {
  static volatile std::sig_atomic_t signals = 0;
  signals = 0;
  struct sigaction action {
  }, before{};
  action.sa_handler = [](int) { signals = signals + 1; };  // and no SA_RESTART
  ::sigaction(SIGALRM, &action, &before);
  const itimerval often{{0, 200}, {0, 200}}, never{};
  ::setitimer(ITIMER_REAL, &often, nullptr);
  const bool same = through_pipe(0, many_bytes()) == many_bytes();
  ::setitimer(ITIMER_REAL, &never, nullptr);
  ::sigaction(SIGALRM, &before, nullptr);
  EXPECT_TRUE(same);
  EXPECT_GT(signals, 0);
}

}  // namespace
}  // namespace overstrike
