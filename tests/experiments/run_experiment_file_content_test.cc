#include <archive.h>
#include <archive_entry.h>

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/run_experiment/config/file_content.h"
#include "experiments/run_experiment/run/mesh_files.h"
#include "tests/common/temporary_folder.h"

namespace cirque {
namespace {

/// Packs the members as tar.gz, longer ones first.
void Pack(const std::string& path,
          const std::vector<std::pair<std::string, std::string>>& members) {
  ::archive* handle = archive_write_new();
  archive_write_add_filter_gzip(handle);
  archive_write_set_format_pax_restricted(handle);
  ASSERT_EQ(archive_write_open_filename(handle, path.c_str()), ARCHIVE_OK);
  for (const auto& [name, content] : members) {
    archive_entry* entry = archive_entry_new();
    archive_entry_set_pathname(entry, name.c_str());
    archive_entry_set_size(entry, static_cast<la_int64_t>(content.size()));
    archive_entry_set_filetype(entry, AE_IFREG);
    archive_entry_set_perm(entry, 0644);
    archive_write_header(handle, entry);
    archive_write_data(handle, content.data(), content.size());
    archive_entry_free(entry);
  }
  archive_write_close(handle);
  archive_write_free(handle);
}

class RunExperimentArchive : public ::testing::Test {
 protected:
  RunExperimentArchive() : path_(folder_.path() + "/a.tar.gz") {
    for (int i = 0; i < 200000; ++i) lion_ += static_cast<char>('a' + i % 1009 % 23);
    Pack(path_, {{"data/cat.off", "meow"}, {"data/lion.off", lion_}});
    mesh_ = {"lion", "", path_, "data/lion.off", "", {}};
  }

  TemporaryFolder folder_;
  std::string path_, lion_;
  MeshSpec mesh_;
};

TEST_F(RunExperimentArchive, GivesTheBytesOfAMember) {
  const StatusOr<std::string> content = ReadArchiveMember(path_, "data/lion.off");
  ASSERT_TRUE(content.ok()) << content.status().message();
  EXPECT_EQ(*content, lion_);
}

TEST_F(RunExperimentArchive, NamesTheNearestMember) {
  EXPECT_EQ(FindArchiveMember(path_, "data/lion.of").message(),
            path_ + " has no member 'data/lion.of' among its 2; did you mean 'data/lion.off'?");
}

TEST_F(RunExperimentArchive, BrokenArchivesAreErrors) {
  const std::string whole = folder_.Read("a.tar.gz");
  const std::string cut = folder_.Write("cut.tar.gz", whole.substr(0, whole.size() / 2));
  EXPECT_EQ(ReadArchiveMember(cut, "data/lion.off").status().code(), StatusCode::kInvalidInput);
  EXPECT_THAT(ReadArchiveMember(folder_.path() + "/no.tgz", "a").status().message(),
              ::testing::HasSubstr("/no.tgz: cannot be read as an archive: "));
}

TEST_F(RunExperimentArchive, AMemberThatSwellsIsRefusedBeforeItFillsTheMemory) {
  const std::string bomb = folder_.Path("bomb.tar.gz");
  Pack(bomb, {{"small.off", "meow"}, {"zeros.off", std::string(65 << 20, '0')}});
  EXPECT_EQ(*ReadArchiveMember(bomb, "small.off"), "meow");
  EXPECT_EQ(ReadArchiveMember(bomb, "zeros.off").status().message(),
            bomb +
                ": its member 'zeros.off' has more than 64 MiB, over 200 times the archive's own "
                "size; if that is meant, unpack it and give it as 'file'");
}

TEST_F(RunExperimentArchive, MembersAreTakenOutOnceUntilTheArchiveChanges) {
  const std::string cache = folder_.path() + "/cache";
  const StatusOr<LocatedMesh> first = LocateMesh(mesh_, cache);
  ASSERT_TRUE(first.ok()) << first.status().message();
  EXPECT_EQ(std::filesystem::path(first->path).extension(), ".off");
  EXPECT_EQ(std::filesystem::file_size(first->path), lion_.size());
  const auto written = std::filesystem::last_write_time(first->path);
  EXPECT_EQ(LocateMesh(mesh_, cache)->path, first->path);
  EXPECT_EQ(std::filesystem::last_write_time(first->path), written);

  Pack(path_, {{"data/lion.off", "another lion"}});
  const StatusOr<LocatedMesh> second = LocateMesh(mesh_, cache);
  ASSERT_TRUE(second.ok()) << second.status().message();
  EXPECT_NE(second->hash, first->hash);
  EXPECT_EQ(std::filesystem::file_size(second->path), 12u);
}

}  // namespace
}  // namespace cirque
