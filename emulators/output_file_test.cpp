#include "emulators/output_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <fstream>
#include <iterator>

#include "emulators/data_files.h"

namespace overstrike::emulator {
namespace {

namespace fs = std::filesystem;

class OutputFileTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / "overstrike_output_file_test";
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::vector<std::string> names() const {
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      found.push_back(entry.path().filename());
    }
    return found;
  }
  fs::path folder_;
};

TEST_F(OutputFileTest, HasItsNameOnlyWhenItIsWhole) {
  OutputFile file(folder_ / "sheet");
  file.write("abc", 3);
  EXPECT_THAT(names(), testing::ElementsAre(testing::StartsWith("sheet.")));
  file.write("def", 3);
  file.commit();
  EXPECT_THAT(names(), testing::ElementsAre("sheet"));
  std::ifstream in(folder_ / "sheet");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), "abcdef");
  struct stat info {};
  ASSERT_EQ(::stat((folder_ / "sheet").c_str(), &info), 0);
  EXPECT_EQ(info.st_mode & 0600, 0600u);
}

TEST_F(OutputFileTest, LeavesNothingWhenGivenUp) {
  {
    OutputFile file(folder_ / "sheet");
    file.write("abc", 3);
  }
  EXPECT_THAT(names(), testing::IsEmpty());
}

TEST_F(OutputFileTest, SaysWhyItCannotBeWritten) {
  try {
    OutputFile file(folder_ / "none" / "sheet");
    ADD_FAILURE() << "opened";
  } catch (const Error& error) {
    EXPECT_EQ(error.what(), (folder_ / "none" / "sheet").string() +
                                ": cannot be written: No such file or directory");
  }
  fs::create_directories(folder_ / "taken" / "by a folder");
  OutputFile file(folder_ / "taken");
  EXPECT_THROW(file.commit(), Error);
  EXPECT_THAT(names(), testing::ElementsAre("taken"));
}

TEST_F(OutputFileTest, SaysWhenTheDiskIsFull) {
  struct rlimit before {};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  ::signal(SIGXFSZ, SIG_IGN);  // write fails with EFBIG instead
  const struct rlimit small { 4096, before.rlim_max };
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  {
    OutputFile file(folder_ / "sheet");
    const std::string bytes(10000, 'x');
    EXPECT_THROW(file.write(bytes.data(), bytes.size()), Error);
  }
  ::setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_THAT(names(), testing::IsEmpty());
}

}  // namespace
}  // namespace overstrike::emulator
