#include "cirque/core/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/temporary_folder.h"

namespace cirque {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

int CountFiles(const TemporaryFolder& folder) {
  const fs::recursive_directory_iterator files(folder.path());
  return static_cast<int>(std::distance(begin(files), end(files)));
}

mode_t ModeOf(const std::string& path) {
  struct stat file = {};
  EXPECT_EQ(stat(path.c_str(), &file), 0);
  return file.st_mode & 07777;
}

TEST(AtomicFile, WritesWholeAndReplacesWhatWasThere) {
  const TemporaryFolder folder;
  const std::string bytes("a\0b\r\n\xff", 6);
  ASSERT_TRUE(WriteFileAtomically(folder.Path("x"), bytes).ok());
  EXPECT_EQ(folder.Read("x"), bytes);
  ASSERT_TRUE(WriteFileAtomically(folder.Path("x"), TextPieces{"one", "", " two\n"}).ok());
  EXPECT_EQ(folder.Read("x"), "one two\n");
  ASSERT_TRUE(WriteFileAtomically(folder.Path("x"), "").ok());
  EXPECT_EQ(folder.Read("x"), "");
  EXPECT_EQ(CountFiles(folder), 1);  // no temporary file stays
}

TEST(AtomicFile, AFolderThatIsMissingIsNamed) {
  const TemporaryFolder folder;
  const std::string path = folder.Path("no/such/folder/x");
  const Status status = WriteFileAtomically(path, "content");
  EXPECT_EQ(status.code(), StatusCode::kInvalidInput);
  EXPECT_EQ(status.message(), path + ": cannot open for writing: No such file or directory");
  EXPECT_THAT(CheckOutputPath(path).message(), HasSubstr("/no/such/folder: No such file"));
  EXPECT_EQ(CountFiles(folder), 0);
}

TEST(AtomicFile, AFolderInItsPlaceStays) {
  const TemporaryFolder folder;
  folder.Write("taken/inside", "kept");
  const Status status = WriteFileAtomically(folder.Path("taken"), "content");
  EXPECT_EQ(status.code(), StatusCode::kInvalidInput);
  EXPECT_THAT(status.message(), HasSubstr("taken: cannot write: Is a directory"));
  EXPECT_EQ(CheckOutputPath(folder.Path("taken")).message(), status.message());
  EXPECT_EQ(folder.Read("taken/inside"), "kept");
  EXPECT_EQ(CountFiles(folder), 2);
}

TEST(AtomicFile, AFullDeviceIsAFailureOfTheMachine) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  const TemporaryFolder folder;
  fs::create_symlink("/dev/full", folder.Path("x"));
  const Status status = WriteFileAtomically(folder.Path("x"), std::string(100000, 'x'));
  EXPECT_EQ(status.code(), StatusCode::kResource);
  EXPECT_THAT(status.message(), HasSubstr("x: cannot write: No space left on device"));
  EXPECT_TRUE(fs::is_symlink(folder.Path("x")));
  EXPECT_EQ(CountFiles(folder), 1);
}

TEST(AtomicFile, LinksAreFollowedAndStayLinks) {
  const TemporaryFolder folder;
  folder.Write("there/target", "old");
  fs::create_symlink("there/target", folder.Path("link"));
  fs::create_symlink(folder.Path("link"), folder.Path("link_to_link"));
  fs::create_symlink("there/new", folder.Path("dangling"));
  for (const auto& [link, target] :
       {std::pair("link_to_link", "there/target"), std::pair("dangling", "there/new")}) {
    EXPECT_TRUE(CheckOutputPath(folder.Path(link)).ok());
    ASSERT_TRUE(WriteFileAtomically(folder.Path(link), "new").ok());
    EXPECT_TRUE(fs::is_symlink(folder.Path(link))) << link;
    EXPECT_EQ(folder.Read(target), "new");
  }
  fs::create_symlink("circle", folder.Path("circle"));
  EXPECT_THAT(WriteFileAtomically(folder.Path("circle"), "x").message(),
              HasSubstr("symbolic link"));
  EXPECT_THAT(CheckOutputPath(folder.Path("circle")).message(), HasSubstr("symbolic link"));
}

TEST(AtomicFile, KeepsTheModeAndGivesNewFilesTheUmasks) {
  const TemporaryFolder folder;
  folder.Write("x", "old");
  for (const mode_t mode : {0600, 0755, 0664}) {
    ASSERT_EQ(chmod(folder.Path("x").c_str(), mode), 0);
    ASSERT_TRUE(WriteFileAtomically(folder.Path("x"), "new").ok());
    EXPECT_EQ(ModeOf(folder.Path("x")), mode);
  }
  const mode_t before = umask(027);
  ASSERT_TRUE(WriteFileAtomically(folder.Path("y"), "new").ok());
  umask(before);
  EXPECT_EQ(ModeOf(folder.Path("y")), 0640u);
}

TEST(AtomicFile, APipeIsWrittenIntoAndStaysAPipe) {
  const TemporaryFolder folder;
  const std::string pipe = folder.Path("pipe"), content(200000, 'x');  // more than a pipe holds
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_TRUE(CheckOutputPath(pipe).ok());
  std::string received;
  std::thread reader([&] {
    const int file = open(pipe.c_str(), O_RDONLY);
    char block[4096];
    for (ssize_t size; (size = read(file, block, sizeof(block))) > 0;) received.append(block, size);
    close(file);
  });
  const Status status = WriteFileAtomically(pipe, TextPieces{content, "end"});
  reader.join();
  EXPECT_TRUE(status.ok()) << status.message();
  EXPECT_EQ(received, content + "end");
  EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST(AtomicFile, DescriptorsOfThisProcessAreWrittenIntoWhereTheyStand) {
  const TemporaryFolder folder;
  folder.Write("log", "");
  const int file = open(folder.Path("log").c_str(), O_WRONLY);
  ASSERT_EQ(write(file, "before ", 7), 7);
  const std::string name = "/dev/fd/" + std::to_string(file);
  EXPECT_TRUE(CheckOutputPath(name).ok());
  EXPECT_TRUE(WriteFileAtomically(name, "now").ok());
  fs::create_symlink(name, folder.Path("link"));
  EXPECT_TRUE(WriteFileAtomically(folder.Path("link"), " again").ok());
  close(file);
  EXPECT_EQ(folder.Read("log"), "before now again");
  EXPECT_THAT(WriteFileAtomically(name, "gone").message(), HasSubstr("Bad file descriptor"));
}

TEST(AtomicFile, NamesThatOthersMayKnowAreNotUsed) {
  const TemporaryFolder folder;
  // A name made of the process's number could be prepared to lead elsewhere.
  folder.Write("victim", "kept");
  fs::create_symlink("victim", folder.Path("x.tmp." + std::to_string(getpid())));
  ASSERT_TRUE(WriteFileAtomically(folder.Path("x"), "content").ok());
  EXPECT_EQ(folder.Read("victim"), "kept");
  EXPECT_EQ(folder.Read("x"), "content");
}

}  // namespace
}  // namespace cirque
