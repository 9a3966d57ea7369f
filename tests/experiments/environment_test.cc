// What the machine does to the programs: no room, no memory, closed streams, signals.
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/generators/generators.h"
#include "cirque/io/io.h"

#include "tests/common/paths.h"
#include "tests/common/run_program.h"
#include "tests/common/temporary_folder.h"

namespace cirque {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

class Environment : public ::testing::Test {
 protected:
  std::string Mesh(Index triangles, const std::string& name = "in.obj") const {
    EXPECT_TRUE(WriteMesh(folder_.Path(name), *GenerateMesh("bumpy_terrain", {triangles, 1})).ok());
    return folder_.Path(name);
  }

  static std::string Program(const std::string& name) { return ProgramFolder() + "/" + name; }

  std::string Map(const std::string& in, const std::string& out = "out.obj") const {
    return fmt::format("{} -io {} -oo {}", Program("circle_patterns"), in, folder_.Path(out));
  }

  int CountFiles() const {
    const fs::recursive_directory_iterator files(folder_.path());
    return static_cast<int>(std::distance(begin(files), end(files)));
  }

  TemporaryFolder folder_;
};

TEST_F(Environment, ALostReportIsNeverExitZero) {
  const std::string in = Mesh(200);
  ASSERT_EQ(RunShell(Map(in)).exit_status, 0);
  const std::string verify =
      fmt::format("{} --json {} {}", Program("verify_map"), in, folder_.Path("out.obj"));
  ASSERT_EQ(RunShell(verify).exit_status, 0);
  for (const std::string& command :
       {verify, Map(in), Program("circle_patterns") + " --help",
        Program("run_experiment") + " --help_config", Program("studies") + " --help"}) {
    const ProgramResult full = RunShell("{ " + command + " > /dev/full; } 2>&1");
    EXPECT_EQ(full.exit_status, 2) << command;
    EXPECT_THAT(full.output, HasSubstr("No space left on device")) << command;
    EXPECT_EQ(RunShell("{ " + command + " >&-; }").exit_status, 2) << command;
  }
}

TEST_F(Environment, AReaderThatWentAwayCostsTheReportAndNotTheMap) {
  const std::string in = Mesh(2000);
  RunShell("{ " + Map(in) + "; echo $? > " + folder_.Path("status") + "; } | true");
  EXPECT_EQ(folder_.Read("status"), "2\n");
  EXPECT_TRUE(ReadMesh(folder_.Path("out.obj")).ok());
}

TEST_F(Environment, AClosedStreamIsNotTakenByAFile) {
  const std::string in = Mesh(200);
  ASSERT_EQ(RunShell(Map(in, "a.obj")).exit_status, 0);
  RunShell("{ " + Map(in, "b.obj") + " >&- 2>&- <&-; }");
  EXPECT_EQ(folder_.Read("a.obj"), folder_.Read("b.obj"));
}

TEST_F(Environment, OutputsThatCannotBeWrittenAreRefusedBeforeTheSolve) {
  const std::string in = Mesh(200);
  const std::string missing = folder_.Path("missing/out.obj");
  const std::string command = Program("circle_patterns") + " -io " + in;
  for (const std::string& flags :
       {" -oo " + missing, " -oo " + folder_.Path("a.obj") + " -certificate " + missing,
        " -oo " + folder_.Path("a.obj") + " -oc " + missing,
        " -oo " + folder_.Path("a.obj") + " --measures " + folder_.Path("missing/a.csv")}) {
    const ProgramResult refused = RunShell(command + flags);
    EXPECT_EQ(refused.exit_status, 2) << flags;
    EXPECT_THAT(refused.output, HasSubstr("/missing: No such file or directory")) << flags;
    EXPECT_THAT(refused.output, Not(HasSubstr("vertices"))) << flags;  // not even read
    EXPECT_EQ(CountFiles(), 1) << flags;
  }
}

TEST_F(Environment, DevicesAndStreamsAreWrittenIntoAndStay) {
  const std::string in = Mesh(200);
  ASSERT_EQ(RunShell(Map(in)).exit_status, 0);
  const std::string pipe = folder_.Path("pipe.obj");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  RunShell(
      fmt::format("cat {} > {} & {}; wait", pipe, folder_.Path("copy.obj"), Map(in, "pipe.obj")));
  EXPECT_EQ(folder_.Read("copy.obj"), folder_.Read("out.obj"));
  EXPECT_TRUE(fs::is_fifo(pipe));
  const std::string stream = fmt::format("{{ {} -io {} -oo /dev/stdout 2> /dev/null > {}; }}",
                                         Program("circle_patterns"), in, folder_.Path("s.obj"));
  EXPECT_EQ(RunShell(stream).exit_status, 0);
  EXPECT_EQ(folder_.Read("s.obj"), folder_.Read("out.obj"));
  EXPECT_EQ(RunShell(fmt::format("{{ cat {} | {} -io /dev/stdin -oo {}; }}", in,
                                 Program("circle_patterns"), folder_.Path("p.obj")))
                .exit_status,
            0);
  EXPECT_EQ(folder_.Read("p.obj"), folder_.Read("out.obj"));
}

TEST_F(Environment, LackOfMemoryIsAMessageAndAStatusSlow) {
  const std::string in = Mesh(20000);
  for (int megabytes = 50; megabytes <= 1000; megabytes += megabytes < 300 ? 10 : 100) {
    // A second KILL of `timeout` would be status 137.
    const ProgramResult result =
        RunShell(fmt::format("ulimit -v {}; exec env -u OPENBLAS_NUM_THREADS timeout -s KILL 60 {}",
                             1000 * megabytes, Map(in)));
    EXPECT_TRUE(result.exit_status == 0 || result.exit_status == 2 || result.exit_status == 127)
        << megabytes << " MB: " << result.exit_status << "\n"
        << result.output;
    if (result.exit_status != 0) {
      EXPECT_THAT(result.output, HasSubstr("circle_patterns: ")) << megabytes;
    }
  }
}

#if defined(CIRQUE_CHOLMOD) && defined(__x86_64__)
// OpenBLAS takes processors that it does not know for one without vectors.
TEST_F(Environment, KernelsOfOpenBlasSuitTheProcessor) {
  for (const char* program : {"circle_patterns", "run_experiment"}) {
    const auto kernels = [&](const std::string& set) {
      return RunShell(set + " OPENBLAS_VERBOSE=2 " + Program(program) + " --version").output;
    };
    const std::string chosen = kernels("env -u OPENBLAS_CORETYPE");
    EXPECT_THAT(chosen, HasSubstr("Core: "));
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
      EXPECT_THAT(chosen, Not(HasSubstr("Core: Prescott")));
    }
    EXPECT_THAT(kernels("OPENBLAS_CORETYPE=Prescott"), HasSubstr("Core: Prescott"));
  }
}
#endif

// The variable is taken back: programs of others choose for themselves.
TEST_F(Environment, ProgramsThatAreStartedAreToldNothingOfKernels) {
  const std::string peer = folder_.Write(
      "peer.sh", "#!/bin/sh\n[ -z \"$OPENBLAS_CORETYPE\" ] || exit 9\ncp \"$1\" \"$2\"\n");
  fs::permissions(peer, fs::perms::owner_all);
  const std::string config = folder_.Write(
      "a.yaml",
      "question: why\nmeshes:\n  - generator: flat_delaunay_patch\n    triangles: 100\n"
      "methods:\n  - name: a\npeer: {name: p, command: \"./peer.sh {in} {out}\"}\n");
  RunShell(fmt::format("env -u OPENBLAS_CORETYPE {} --report=false --output={} {}",
                       Program("run_experiment"), folder_.Path("results"), config));
  const std::string records = folder_.Read("results/results.jsonl");
  EXPECT_THAT(records, HasSubstr("peer.sh"));
  EXPECT_THAT(records, Not(HasSubstr("exit status 9")));
}

TEST_F(Environment, ChildrenAreWaitedForThoughTheParentIgnoredThem) {
  const std::string config =
      folder_.Write("a.yaml",
                    "question: why\nmeshes:\n  - generator: bumpy_terrain\n    triangles: 100\n"
                    "methods:\n  - name: a\n");
  const ProgramResult result =
      RunShell(fmt::format("trap '' CHLD; exec timeout -s KILL 60 {} --report=false --output={} {}",
                           Program("run_experiment"), folder_.Path("results"), config));
  EXPECT_EQ(result.exit_status, 0) << result.output;
  EXPECT_THAT(folder_.Read("results/results.jsonl"), HasSubstr("\"outcome\":\"ok\""));
}

TEST_F(Environment, ASignalEndsAProgramWithinASecondWhateverItDoesSlow) {
  const std::string in = Mesh(400000);
  using Clock = std::chrono::steady_clock;
  for (const int milliseconds : {100, 300, 600, 1000, 1500, 2200, 3000}) {
    const pid_t child = fork();
    if (child == 0) {
      close(STDOUT_FILENO);
      close(STDERR_FILENO);
      const std::string program = Program("circle_patterns");
      execl(program.c_str(), program.c_str(), "-io", in.c_str(), "-oo",
            folder_.Path("out.obj").c_str(), nullptr);
      _exit(99);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    const Clock::time_point sent = Clock::now();
    kill(child, SIGTERM);
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_LT(std::chrono::duration<double>(Clock::now() - sent).count(), 5);  // idle: under 1
    EXPECT_TRUE(WIFEXITED(status) || WIFSIGNALED(status));
    const bool has_map = fs::exists(folder_.Path("out.obj"));
    EXPECT_TRUE(has_map || CountFiles() == 1) << milliseconds;
  }
}

}  // namespace
}  // namespace cirque
