#include "cirque/core/atomic_file.h"

#include <unistd.h>

#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/temporary_folder.h"

namespace cirque {
namespace {

using testing::HasSubstr;

int CountFiles(const TemporaryFolder& folder) {
  const std::filesystem::recursive_directory_iterator files(folder.path());
  return static_cast<int>(std::distance(begin(files), end(files)));
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
  EXPECT_EQ(CountFiles(folder), 0);
}

TEST(AtomicFile, WhatCannotBeReplacedStaysAndNothingIsLeftBehind) {
  const TemporaryFolder folder;
  folder.Write("taken/inside", "kept");
  const Status status = WriteFileAtomically(folder.Path("taken"), "content");
  EXPECT_EQ(status.code(), StatusCode::kInvalidInput);
  EXPECT_THAT(status.message(), HasSubstr("taken: cannot replace: "));
  EXPECT_EQ(folder.Read("taken/inside"), "kept");
  EXPECT_EQ(CountFiles(folder), 2);
}

TEST(AtomicFile, AFullDeviceIsAFailure) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  // The temporary name lies beside the target, so that a link stands for it.
  const TemporaryFolder folder;
  const std::string path = folder.Path("x");
  const std::string temporary = path + ".tmp." + std::to_string(getpid());
  std::filesystem::create_symlink("/dev/full", temporary);
  const Status status = WriteFileAtomically(path, std::string(100000, 'x'));
  EXPECT_EQ(status.code(), StatusCode::kInvalidInput);
  EXPECT_THAT(status.message(), HasSubstr("x: cannot write: No space left on device"));
  EXPECT_EQ(CountFiles(folder), 0);
}

}  // namespace
}  // namespace cirque
