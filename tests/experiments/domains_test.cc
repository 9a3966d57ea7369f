// circle_patterns --domain as a user runs it.
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/generators/generators.h"
#include "cirque/io/io.h"

#include "tests/common/run_program.h"

namespace cirque {
namespace {

using ::testing::HasSubstr;

class DomainsTest : public ::testing::Test {
 protected:
  DomainsTest() : in_(folder_.Path("in.obj")), out_(folder_.Path("out.obj")) {
    EXPECT_TRUE(WriteMesh(in_, *GenerateMesh("hemisphere", {400, 1})).ok());
  }

  ProgramResult Map(const std::string& flags) const {
    return RunProgram("circle_patterns -io " + in_ + " -oo " + out_ + " " + flags);
  }

  TemporaryFolder folder_;
  const std::string in_, out_;
};

TEST_F(DomainsTest, EveryDomainGivesAMapThatVerifyMapAccepts) {
  for (const std::string flags :
       {"--domain=disk", "--domain=disk --normalization=boundary", "--domain=half_plane",
        "--domain=rectangle", "--domain=polygon --sides=5", "--domain=triangle"}) {
    const ProgramResult mapped = Map(flags);
    EXPECT_EQ(mapped.exit_status, 0) << flags << mapped.output;
    const bool disk = flags.find("disk") != std::string::npos;
    const ProgramResult verified =
        RunProgram("verify_map --require_injective " + std::string(disk ? "--domain=disk " : "") +
                   in_ + " " + out_);
    EXPECT_EQ(verified.exit_status, 0) << flags << verified.output;
  }
}

TEST_F(DomainsTest, AFlatMapIsNoDisk) {
  ASSERT_EQ(Map("").exit_status, 0);
  const ProgramResult verified = RunProgram("verify_map --domain=disk " + in_ + " " + out_);
  EXPECT_EQ(verified.exit_status, 1);
  EXPECT_THAT(verified.output, HasSubstr("off the unit circle"));
}

TEST_F(DomainsTest, RectangleReportsItsModulus) {
  EXPECT_THAT(Map("--domain=rectangle").output, HasSubstr("conformal modulus"));
}

TEST_F(DomainsTest, WrongCombinationsAreRefusedByName) {
  const std::pair<std::string, std::string> cases[] = {
      {"--domain=disc", "did you mean 'disk'"},
      {"--centre=3", "--domain=plane takes no --centre"},
      {"--curve=ellipse", "takes no --curve, which is for --domain=curve;"},
      {"--domain=disk --corners=1,2,3", "--domain=disk takes no --corners"},
      {"--domain=rectangle --sides=4", "--domain=rectangle takes no --sides"},
      {"--domain=polygon --sides=5 --corners=1,2,3", "not both"},
      {"--domain=disk --centre=x", "'x' is no vertex"},
      {"--domain=disk --centre=100000", "no face has vertex 100000"},
      {"--domain=rectangle --corners=1,2,3", "a rectangle has 4 corners"},
      {"--domain=disk --normalization=mass", "--normalization = 'mass' is not one of"},
      {"--domain=disk -ie cuts", "takes no --ie"}};
  for (const auto& [flags, message] : cases) {
    const ProgramResult refused = Map(flags);
    EXPECT_EQ(refused.exit_status, 2) << flags;
    EXPECT_THAT(refused.output, HasSubstr(message)) << flags;
    EXPECT_FALSE(std::ifstream(out_).good()) << flags;
  }
}

TEST_F(DomainsTest, HolesAreFilledForTheDiskOnRequest) {
  ASSERT_TRUE(WriteMesh(in_, *GenerateMesh("annulus", {300, 1})).ok());
  const ProgramResult refused = Map("--domain=disk");
  EXPECT_EQ(refused.exit_status, 2);
  EXPECT_THAT(refused.output, HasSubstr("--fill_holes"));
  EXPECT_EQ(Map("--domain=disk --fill_holes").exit_status, 0);
  const ProgramResult verified = RunProgram("verify_map --domain=disk " + in_ + " " + out_);
  EXPECT_EQ(verified.exit_status, 0) << verified.output;
}

}  // namespace
}  // namespace cirque
