// CHOLMOD calls OpenBLAS, not the ATLAS that Debian's libceres brings in: measured a third slower.
#include <dlfcn.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <regex>
#include <string>
#include <vector>

#include <cholmod.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/paths.h"

namespace cirque {
namespace {

// What a shell command prints on both streams.
std::string OutputOf(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen((command + " 2>&1").c_str(), "r"), pclose);
  std::string output;
  std::array<char, 4096> buffer;
  while (pipe && fgets(buffer.data(), buffer.size(), pipe.get()) != nullptr)
    output += buffer.data();
  return output;
}

// Where libcholmod's calls of these functions (a regular expression) bind to in a program. The
// dynamic linker says so itself, without running the program.
std::vector<std::string> BindingsOfCholmod(const std::string& program,
                                           const std::string& functions) {
  const std::regex kBinding(
      R"re(binding file \S*libcholmod\S* \[0\] to (\S+) \[0\]: normal symbol `()re" + functions +
      ")'");
  const std::string bindings = OutputOf("LD_DEBUG=bindings ldd -r '" + program + "'");
  std::vector<std::string> libraries;
  for (std::sregex_iterator match(bindings.begin(), bindings.end(), kBinding), end; match != end;
       ++match) {
    libraries.push_back((*match)[1]);
  }
  return libraries;
}

std::vector<std::string> Programs() {
  std::vector<std::string> programs;
  for (const auto& entry : std::filesystem::directory_iterator(ProgramFolder())) {
    if (entry.is_regular_file()) programs.push_back(entry.path());
  }
  return programs;
}

TEST(Blas, OfThisProcessIsOpenBlas) {
  // The call makes this program need CHOLMOD, so that the test below has a case for certain.
  EXPECT_EQ(cholmod_version(nullptr), CHOLMOD_VERSION);
  const void* dgemm = dlsym(RTLD_DEFAULT, "dgemm_");
  ASSERT_NE(dgemm, nullptr);
  Dl_info info;
  ASSERT_NE(dladdr(dgemm, &info), 0);
  EXPECT_THAT(info.dli_fname, testing::HasSubstr("openblas"));
}

TEST(Blas, OfCholmodIsOpenBlasInEveryProgram) {
  bool has_cholmod = false;
  for (const std::string& program : Programs()) {
    const std::vector<std::string> libraries = BindingsOfCholmod(program, "dgemm_|dsyrk_");
    has_cholmod = has_cholmod || libraries.size() == 2;
    EXPECT_THAT(libraries, testing::Each(testing::HasSubstr("openblas"))) << program;
  }
  EXPECT_TRUE(has_cholmod);
}

// Or every supernode costs several teams of one thread.
TEST(Blas, ParallelRegionsOfCholmodEnterTheProgramsOwnWay) {
  int with_library = 0;
  for (const char* name : {"circle_patterns", "run_experiment", "studies"}) {
    const std::string program = std::filesystem::path(ProgramFolder()) / name;
    // One that holds CHOLMOD's archive is linked so once and for all.
    if (OutputOf("ldd '" + program + "'").find("libcholmod") == std::string::npos) continue;
    ++with_library;
    EXPECT_THAT(BindingsOfCholmod(program, "GOMP_parallel"), testing::ElementsAre(program));
  }
  EXPECT_GE(with_library, 2);  // circle_patterns alone holds archives
}

}  // namespace
}  // namespace cirque
