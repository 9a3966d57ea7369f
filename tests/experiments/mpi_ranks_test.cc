// circle_patterns started by mpirun: one map, whatever the number of ranks, and no rank waits for
// ever.
#include <complex>
#include <filesystem>
#include <fstream>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cirque/generators/generators.h"
#include "cirque/io/io.h"
#include "cirque/linear/multigrid.h"

#include "tests/common/paths.h"
#include "tests/common/run_program.h"

namespace cirque {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr char kMpirun[] =
    "OPENBLAS_NUM_THREADS=1 OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 timeout 120 "
    "mpirun --bind-to none --mca btl self,vader --mca oob_tcp_if_include lo ";

using Points = Eigen::VectorXcd;

Points ReadUv(const std::string& path) {
  const auto mesh = ReadMesh(path);
  EXPECT_TRUE(mesh.ok()) << mesh.status().message();
  Points points(static_cast<Eigen::Index>(mesh->texture.size()));
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    points[i] = {mesh->texture[i].x(), mesh->texture[i].y()};
  }
  return points;
}

/// The largest distance of two maps after the best similarity, relative to the extent.
double Distance(Points a, Points b) {
  EXPECT_EQ(a.size(), b.size());
  a.array() -= a.mean();
  b.array() -= b.mean();
  const std::complex<double> similarity = a.dot(b) / a.squaredNorm();
  return (similarity * a - b).lpNorm<Eigen::Infinity>() / b.lpNorm<Eigen::Infinity>();
}

class MpiRanks : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!BuiltWithMultigrid()) GTEST_SKIP() << "built without PETSc";
    if (RunShell("command -v mpirun").exit_status != 0) GTEST_SKIP() << "there is no mpirun";
    ASSERT_TRUE(WriteMesh(folder_.Path("in.obj"), *GenerateMesh("bumpy_terrain", {800, 1})).ok());
  }

  std::string Program(const std::string& output, const std::string& flags) const {
    return ProgramFolder() + "/circle_patterns -io " + folder_.Path("in.obj") + " -oo " +
           folder_.Path(output) + " --certificate=" +
           std::filesystem::path(folder_.Path(output))
               .replace_extension(".certificate.json")
               .string() +
           " " + flags;
  }

  const TemporaryFolder folder_;
};

std::string StrategyOf(const std::string& stage, const std::string& certificate) {
  std::ifstream file(certificate);
  return nlohmann::json::parse(file)["solvers"][stage];
}

TEST_F(MpiRanks, OneTwoAndFourGiveTheMapOfFactorizations) {
  const std::string amg = "--radii_solver=newton_amg --angle_solver=newton_amg";
  const auto on_ranks = [&](int ranks) {
    return RunShell(kMpirun + ("--oversubscribe -n " + std::to_string(ranks) + " " +
                               Program(std::to_string(ranks) + ".obj", amg)));
  };
  const ProgramResult factored =
      RunShell(Program("factored.obj", "--radii_solver=newton_cg --angle_solver=newton"));
  const ProgramResult alone = RunShell(Program("alone.obj", amg));
  for (const ProgramResult& run : {factored, alone, on_ranks(1), on_ranks(2), on_ranks(4)}) {
    ASSERT_EQ(run.exit_status, 0) << run.output;
    // Only the first rank speaks, and no library does.
    EXPECT_EQ(run.output.find("triangles)"), run.output.rfind("triangles)")) << run.output;
    for (const char* word : {"PETSC", "PETSc", "MPI", "mpi", "hypre", "HYPRE"}) {
      EXPECT_EQ(run.output.find(word), std::string::npos) << run.output;
    }
  }
  const Points wanted = ReadUv(folder_.Path("factored.obj"));
  EXPECT_GT(wanted.lpNorm<Eigen::Infinity>(), 0);
  const std::map<std::string, std::string> strategies = {{"alone", "newton_amg"},
                                                         {"1", "newton_amg"},
                                                         {"2", "newton_amg on 2 ranks"},
                                                         {"4", "newton_amg on 4 ranks"}};
  for (const auto& [name, strategy] : strategies) {
    EXPECT_LT(Distance(wanted, ReadUv(folder_.Path(name + ".obj"))), 1e-9) << name;
    // Nothing was factored in secret, and nothing done by the first rank alone.
    for (const char* stage : {"angles", "radii"}) {
      EXPECT_EQ(StrategyOf(stage, folder_.Path(name + ".certificate.json")), strategy);
    }
  }
}

/// A ranged angle sum has a kink: the first rank fits those angles.
TEST_F(MpiRanks, AnglesOfRangedSumsAreFittedWhole) {
  std::ofstream(folder_.Path("cones.txt")) << "200 1.5 2.5\n";
  const std::string flags =
      "--radii_solver=newton_amg --angle_solver=newton_amg -iv " + folder_.Path("cones.txt");
  ASSERT_EQ(RunShell(Program("one.obj", flags)).exit_status, 0);
  const ProgramResult two = RunShell(kMpirun + ("-n 2 " + Program("two.obj", flags)));
  ASSERT_EQ(two.exit_status, 0) << two.output;
  EXPECT_LT(Distance(ReadUv(folder_.Path("one.obj")), ReadUv(folder_.Path("two.obj"))), 1e-9);
  EXPECT_EQ(StrategyOf("angles", folder_.Path("two.certificate.json")), "newton_amg");
  EXPECT_EQ(StrategyOf("radii", folder_.Path("two.certificate.json")), "newton_amg on 2 ranks");
}

/// Where multigrid does not converge, the first rank factors what it has whole.
TEST_F(MpiRanks, WhatMultigridDoesNotSolveIsFactored) {
  const std::string amg = "newton_amg:max_cg_iterations=1";
  const std::string flags = "--radii_solver=" + amg + " --angle_solver=" + amg;
  ASSERT_EQ(RunShell(Program("factored.obj", "--radii_solver=newton_cg --angle_solver=newton"))
                .exit_status,
            0);
  const Points wanted = ReadUv(folder_.Path("factored.obj"));
  for (const std::string ranks : {"2", "4"}) {
    const ProgramResult run =
        RunShell(kMpirun + ("--oversubscribe -n " + ranks + " " + Program(ranks + ".obj", flags)));
    ASSERT_EQ(run.exit_status, 0) << run.output;
    EXPECT_LT(Distance(wanted, ReadUv(folder_.Path(ranks + ".obj"))), 1e-9);
    for (const char* stage : {"angles", "radii"}) {
      const std::string strategy = StrategyOf(stage, folder_.Path(ranks + ".certificate.json"));
      EXPECT_THAT(strategy, StartsWith("newton_amg, "));
      EXPECT_THAT(strategy, HasSubstr("factored"));
    }
  }
}

/// Two network namespaces: nothing but TCP joins the ranks.
TEST_F(MpiRanks, TwoHostsGiveTheMapOfOne) {
  const std::string hosts = "timeout 120 " + ProjectPath("tests/mpi/two_hosts") + " ";
  const ProgramResult names = RunShell(hosts + "hostname");
  if (names.exit_status != 0) GTEST_SKIP() << "no namespaces here: " << names.output;
  EXPECT_THAT(names.output, HasSubstr("here"));
  EXPECT_THAT(names.output, HasSubstr("there"));
  const std::string amg = "--radii_solver=newton_amg --angle_solver=newton_amg";
  ASSERT_EQ(RunShell(Program("one.obj", amg)).exit_status, 0);
  const ProgramResult two = RunShell(hosts + Program("two.obj", amg));
  ASSERT_EQ(two.exit_status, 0) << two.output;
  const Points one = ReadUv(folder_.Path("one.obj"));
  EXPECT_GT(one.lpNorm<Eigen::Infinity>(), 0);
  EXPECT_LT(Distance(one, ReadUv(folder_.Path("two.obj"))), 1e-9);
}

/// Processes by themselves, which may run at the same time, share no folder of MPI's.
TEST_F(MpiRanks, OneByItselfNeedsNoFolderForOthers) {
  const ProgramResult run =
      RunShell("TMPDIR=/dev/null " + Program("alone.obj", "--radii_solver=newton_amg"));
  EXPECT_EQ(run.exit_status, 0) << run.output;
  EXPECT_EQ(StrategyOf("radii", folder_.Path("alone.certificate.json")), "newton_amg");
  EXPECT_GT(ReadUv(folder_.Path("alone.obj")).lpNorm<Eigen::Infinity>(), 0);
}

TEST_F(MpiRanks, AnErrorOfTheFirstEndsAll) {
  const ProgramResult run = RunShell(
      kMpirun + ("-n 2 " + Program("no/such/folder/out.obj", "--radii_solver=newton_amg")));
  EXPECT_EQ(run.exit_status, 2) << run.output;
}

TEST_F(MpiRanks, TheDeathOfOneEndsAll) {
  const ProgramResult run =
      RunShell(kMpirun + ("-n 1 " + Program("out.obj", "") + " : -n 1 false"));
  EXPECT_NE(run.exit_status, 0);
  EXPECT_NE(run.exit_status, 124) << "timeout had to end it: " << run.output;
}

TEST_F(MpiRanks, PetscIsLoadedOnlyWhereItIsUsed) {
  const auto libraries = [&](const std::string& strategy) {
    return RunShell("LD_DEBUG=libs " + Program("out.obj", "--radii_solver=" + strategy)).output;
  };
  EXPECT_THAT(libraries("newton_amg"), HasSubstr("libpetsc"));
  const std::string without = libraries("newton_cg");
  EXPECT_THAT(without, HasSubstr("libstdc++"));
  for (const char* library : {"libpetsc", "libmpi", "libHYPRE"}) {
    EXPECT_EQ(without.find(library), std::string::npos) << library;
  }
}

}  // namespace
}  // namespace cirque
