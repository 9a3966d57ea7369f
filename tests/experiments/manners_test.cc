// How circle_patterns is called, what it says and what it leaves behind; and the manual pages of all
// programs.
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/core/version.h"
#include "cirque/generators/generators.h"
#include "cirque/io/io.h"

#include "experiments/circle_patterns/flags.h"
#include "tests/common/paths.h"
#include "tests/common/run_program.h"

namespace cirque {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

namespace fs = std::filesystem;

class Manners : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(WriteMesh(in_, *GenerateMesh("bumpy_terrain", {200, 1})).ok());
  }

  std::vector<std::string> Files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_.path())) {
      names.push_back(entry.path().filename());
    }
    std::sort(names.begin(), names.end());
    return names;
  }

  StatusOr<CirclePatternsJob> JobOf(const std::vector<std::string>& arguments) const {
    CirclePatternsFlags flags;
    const Status status = flags.Parse(arguments);
    return status.ok() ? flags.Job() : status;
  }

  TemporaryFolder folder_;
  const std::string in_ = folder_.Path("mesh.obj"), out_ = folder_.Path("out.obj");
};

TEST_F(Manners, WhatAMetricHasNotIsNotAskedOfIt) {
  EXPECT_THAT(JobOf({"a.con", "b.obj", "--pins=where.txt"}).status().message(),
              HasSubstr("a metric has no points"));
  EXPECT_THAT(JobOf({"a.obj", "b.obj", "--symmetric", "-oc", "c.con"}).status().message(),
              HasSubstr("solves one half"));
}

TEST_F(Manners, FilesAreNamedByTheirPlaces) {
  const auto two = JobOf({"a.obj", "--domain=disk", "b.obj"});
  ASSERT_TRUE(two.ok()) << two.status().message();
  EXPECT_EQ(two->input, "a.obj");
  EXPECT_EQ(two->output, "b.obj");
  EXPECT_EQ(JobOf({"--io=a.obj", "b.obj"})->output, "b.obj");
  EXPECT_EQ(JobOf({"a.con", "b.obj"})->input_con, "a.con");
  EXPECT_EQ(JobOf({"-", "-"})->input, "/dev/stdin");
  EXPECT_EQ(JobOf({"-", "-"})->output, "/dev/stdout");
  EXPECT_EQ(JobOf({"-io", "-", "-oo", "-"})->output, "/dev/stdout");
  EXPECT_THAT(JobOf({"a.obj", "b.obj", "c.obj"}).status().message(),
              HasSubstr("unexpected argument 'c.obj'"));
  EXPECT_THAT(JobOf({"-io=a.obj"}).status().message(), HasSubstr("no output is given"));
}

TEST_F(Manners, OneMeshAloneIsMappedIntoAFileBesideIt) {
  EXPECT_EQ(JobOf({in_})->output, folder_.Path("mesh_uv.obj"));
  EXPECT_EQ(JobOf({"folder/scan.ply.gz", "--quiet"})->output, "folder/scan_uv.obj");
  EXPECT_EQ(JobOf({"-"})->output, "/dev/stdout");
  ASSERT_EQ(RunProgram("circle_patterns " + in_).exit_status, 0);
  EXPECT_THAT(Files(), ElementsAre("mesh.obj", "mesh_uv.obj"));
  EXPECT_EQ(RunProgram("verify_map " + in_ + " " + folder_.Path("mesh_uv.obj")).exit_status, 0);
}

TEST_F(Manners, AFileOfOptionsIsToldFromAMeshByItsFirstWord) {
  const std::string options = folder_.Write("options", "-io a.obj\n-oo b.obj\n");
  EXPECT_EQ(JobOf({options})->output, "b.obj");
  const std::string places = folder_.Write("places.txt", "--domain=disk a.obj b.obj");
  EXPECT_EQ(JobOf({places})->input, "a.obj");
  // Even if it is called like a mesh.
  EXPECT_EQ(JobOf({folder_.Write("odd.obj", "-io a.obj -oo b.obj")})->input, "a.obj");
  EXPECT_EQ(JobOf({folder_.Write("odd.ply", "-- a.obj -oo b.obj")})->input,
            folder_.Path("odd.ply"));
  const Status mesh = JobOf({folder_.Write("mesh.txt", "v 0 0 0\n")}).status();
  EXPECT_THAT(mesh.message(), HasSubstr("neither a file of options, which begins with one (-io), "
                                        "nor a mesh by its name (obj, off, "));
}

TEST_F(Manners, TheMapDoesNotReplaceItsMeshUnlessThatIsMeant) {
  const std::string before = folder_.Read("mesh.obj");
  fs::create_symlink(in_, folder_.Path("link.obj"));
  for (const std::string& same : {in_, folder_.Path("link.obj")}) {
    const ProgramResult refused = RunProgram("circle_patterns " + in_ + " " + same);
    EXPECT_EQ(refused.exit_status, 2);
    EXPECT_THAT(refused.output, HasSubstr("give --overwrite"));
    EXPECT_EQ(folder_.Read("mesh.obj"), before);
  }
  ASSERT_EQ(RunProgram("circle_patterns --overwrite " + in_ + " " + in_).exit_status, 0);
  EXPECT_FALSE(ReadMesh(in_)->texture.empty());
}

TEST_F(Manners, QuietSaysOnlyWhatWentWrong) {
  const ProgramResult quiet = RunProgram("circle_patterns --quiet " + in_ + " " + out_);
  EXPECT_EQ(quiet.exit_status, 0);
  EXPECT_EQ(quiet.output, "");
  const ProgramResult wrong = RunProgram("circle_patterns --quiet none.obj " + out_);
  EXPECT_EQ(wrong.exit_status, 2);
  EXPECT_THAT(wrong.output, HasSubstr("none.obj"));
}

TEST_F(Manners, ACertificateIsWrittenWhereItIsAskedForOrSomethingIsWrong) {
  ASSERT_EQ(RunProgram("circle_patterns " + in_ + " " + out_).exit_status, 0);
  EXPECT_THAT(Files(), ElementsAre("mesh.obj", "out.obj"));
  ASSERT_EQ(RunProgram("circle_patterns " + in_ + " " + out_ +
                       " --certificate=" + folder_.Path("evidence.json"))
                .exit_status,
            0);
  EXPECT_THAT(Files(), ElementsAre("evidence.json", "mesh.obj", "out.obj"));
  fs::remove(out_);
  ASSERT_EQ(
      RunProgram("circle_patterns --strict --max_iterations=1 " + in_ + " " + out_).exit_status, 1);
  EXPECT_THAT(Files(), ElementsAre("evidence.json", "mesh.obj", "out.certificate.json"));
}

TEST_F(Manners, StandardInputAndOutput) {
  ASSERT_EQ(RunProgram("circle_patterns " + in_ + " " + out_).exit_status, 0);
  const std::string program = ProgramFolder() + "/circle_patterns";
  const std::string stream = folder_.Path("stream.obj");
  EXPECT_EQ(
      RunShell("{ " + program + " - - < " + in_ + " > " + stream + " 2> /dev/null; }").exit_status,
      0);
  EXPECT_EQ(folder_.Read("stream.obj"), folder_.Read("out.obj"));
}

constexpr const char* kPrograms[] = {"circle_patterns",   "verify_map",     "run_experiment",
                                     "experiment_report", "audit_energies", "studies",
                                     "transfer",          "remesh"};

TEST(ManualPages, EveryProgramAnswersTheSameQuestions) {
  for (const std::string program : kPrograms) {
    SCOPED_TRACE(program);
    const ProgramResult version = RunProgram(program + " --version");
    EXPECT_EQ(version.exit_status, 0);
    EXPECT_THAT(version.output, StartsWith(program + " " + Version() + " ("));
    const ProgramResult brief = RunProgram(program + " -h");
    EXPECT_EQ(brief.exit_status, 0);
    EXPECT_EQ(brief.output, RunProgram(program + " --help").output);
    EXPECT_THAT(brief.output, StartsWith(program + " "));
    const ProgramResult wrong = RunProgram(program + " --hepl");
    EXPECT_EQ(wrong.exit_status, 2);
    EXPECT_THAT(wrong.output, HasSubstr("did you mean 'help'?"));
  }
}

/// "--name" at the beginning of a line of the help.
std::vector<std::string> FlagsOfHelp(const std::string& help) {
  std::vector<std::string> flags;
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("  --"))
      flags.push_back(line.substr(4, line.find_first_of("=[ .", 4) - 4));
  }
  return flags;
}

TEST(ManualPages, NameEveryFlagAndPassTheFormatter) {
  const TemporaryFolder folder;
  const bool has_man = RunShell("command -v man && command -v groff").exit_status == 0;
  for (const std::string program : kPrograms) {
    SCOPED_TRACE(program);
    const ProgramResult page = RunProgram(program + " --help=man");
    ASSERT_EQ(page.exit_status, 0);
    EXPECT_THAT(page.output, StartsWith(".TH \""));
    const std::vector<std::string> flags = FlagsOfHelp(RunProgram(program + " --help=all").output);
    EXPECT_GE(flags.size(), 2u);
    for (const std::string& flag : flags) {
      EXPECT_THAT(page.output, HasSubstr("\\fB\\-\\-" + flag + "\\fR"));
    }
    if (!has_man) continue;
    const std::string file = folder.Write(program + ".1", page.output);
    EXPECT_THAT(
        RunShell("man --warnings -E UTF-8 -l -Tutf8 -Z " + file + " 2>&1 > /dev/null").output,
        IsEmpty());
  }
}

}  // namespace
}  // namespace cirque
