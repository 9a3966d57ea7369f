// Audits every registered energy, and shows that the audit sees planted errors.
#include <fstream>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "experiments/audit_energies/audit.h"
#include "tests/audit/planted_errors.h"

namespace cirque::audit_energies {
namespace {

using testing::Contains;
using testing::HasSubstr;

class EveryEnergy : public ::testing::TestWithParam<std::string> {};

TEST_P(EveryEnergy, PassesItsAudit) {
  const auto samples = Samples().Find(GetParam());
  ASSERT_TRUE(samples.ok()) << samples.status().message();
  const std::vector<AuditFinding> findings =
      AuditSampled(*Energies().Find(GetParam()), (*samples)());
  ASSERT_EQ(findings.size(), AuditChecks().size() + 1);
  for (const AuditFinding& f : findings) {
    EXPECT_TRUE(f.ok()) << f.check << ": " << f.figure << " > " << f.bound << " at " << f.where;
    EXPECT_TRUE(!f.applies || !f.where.empty()) << f.check << " looked at nothing";
  }
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryEnergy, ::testing::ValuesIn(Energies().Names()));

/// The names of the checks that fail for an energy with that error planted.
std::vector<std::string> FailedChecks(const std::string& energy, PlantedError error) {
  const EnergyFactory sound = *Energies().Find(energy);
  const auto planted = [&](const EnergyInput& input) -> std::unique_ptr<Energy> {
    return std::make_unique<PlantedEnergy>(sound(input), error);
  };
  AuditSamples samples = (*Samples().Find(energy))();
  // One case at its first points is enough, and quick.
  samples.cases.resize(1);
  if (samples.cases[0].inside.size() > 2) samples.cases[0].inside.resize(2);
  std::vector<std::string> failed;
  for (const AuditFinding& f : AuditSampled(planted, samples)) {
    if (!f.ok()) failed.push_back(f.check);
  }
  return failed;
}

TEST(PlantedErrors, NoneIsSeenWhereThereIsNone) {
  EXPECT_THAT(FailedChecks("circle_pattern", PlantedError::kNothing), testing::IsEmpty());
  EXPECT_THAT(FailedChecks("lorentz", PlantedError::kNothing), testing::IsEmpty());
}

TEST(PlantedErrors, OneWrongSignInTheGradient) {
  for (const char* energy : {"circle_pattern", "coherent_angle_barrier", "quadratic_dual"}) {
    const auto failed = FailedChecks(energy, PlantedError::kGradientSign);
    EXPECT_THAT(failed, Contains("gradient")) << energy;
    EXPECT_THAT(failed, Contains("digits")) << energy;
    EXPECT_THAT(failed, Contains("symmetry")) << energy;
  }
  EXPECT_THAT(FailedChecks("circle_pattern", PlantedError::kGradientSign), Contains("forms"));
}

TEST(PlantedErrors, GradientAloneDiffersFromTheOneWithTheValue) {
  EXPECT_THAT(FailedChecks("barrier_dual", PlantedError::kGradientAlone),
              testing::ElementsAre("forms"));
}

TEST(PlantedErrors, AnOffDiagonalSignInTheHessian) {
  const auto failed = FailedChecks("circle_pattern", PlantedError::kHessianSign);
  EXPECT_THAT(failed, Contains("hessian"));
  EXPECT_THAT(failed, Contains("digits"));
}

TEST(PlantedErrors, AnEntryAboveTheDiagonal) {
  EXPECT_THAT(FailedChecks("circle_pattern", PlantedError::kHessianAsymmetric),
              testing::ElementsAre("symmetry"));
}

TEST(PlantedErrors, AConcaveDirection) {
  EXPECT_THAT(FailedChecks("coherent_angle_barrier", PlantedError::kConcave),
              Contains("convexity"));
}

TEST(PlantedErrors, AMissingTermOfTheValue) {
  const auto failed = FailedChecks("circle_pattern", PlantedError::kValueTerm);
  EXPECT_THAT(failed, Contains("gradient"));
  EXPECT_THAT(failed, Contains("digits"));
  EXPECT_THAT(failed, Contains("forms"));
}

TEST(PlantedErrors, AConstantOffInTheValue) {
  EXPECT_THAT(FailedChecks("coherent_angle_barrier", PlantedError::kValueConstant),
              testing::ElementsAre("digits"));
}

TEST(PlantedErrors, AWrongSignInAResidualsJacobian) {
  for (const char* energy : {"circle_pattern", "coherent_angle_barrier", "lorentz"}) {
    EXPECT_THAT(FailedChecks(energy, PlantedError::kResidualJacobian),
                testing::ElementsAre("forms"))
        << energy;
  }
}

TEST(PlantedErrors, ADomainThatRefusesNothing) {
  EXPECT_THAT(FailedChecks("lorentz", PlantedError::kNoDomain), Contains("domain"));
  EXPECT_THAT(FailedChecks("quadratic_dual", PlantedError::kNoDomain), Contains("domain"));
}

TEST(PlantedErrors, NanInsideTheDomain) {
  const auto failed = FailedChecks("quadratic_dual", PlantedError::kNan);
  EXPECT_THAT(failed, Contains("gradient"));
  EXPECT_THAT(failed, Contains("digits"));
}

TEST(AuditRegistry, AnEnergyWithoutSamplesFailsAndSaysSo) {
  const Registry<EnergyFactory> energies("energy",
                                         {{"unheard_of", *Energies().Find("circle_pattern")}});
  const std::vector<AuditRow> rows = AuditRegistry(energies, Samples());
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_FALSE(rows[0].ok());
  EXPECT_FALSE(AllOk(rows));
  EXPECT_THAT(rows[0].status.message(), HasSubstr("'unheard_of' is registered but has no samples"));
  EXPECT_THAT(ToText(rows), HasSubstr("not audited\nunheard_of: energy 'unheard_of' is"));
}

TEST(AuditRegistry, SamplesWithoutPointsOrReferenceFail) {
  const Registry<EnergyFactory> energies("energy", {{"e", *Energies().Find("circle_pattern")}});
  const Registry<SampleMaker> samples("samples", {{"e", [] { return AuditSamples{}; }}});
  EXPECT_FALSE(AllOk(AuditRegistry(energies, samples)));
  EXPECT_FALSE(AllOk({}));
}

TEST(AuditReport, NamesEveryCheckAndKeepsNanOutOfJson) {
  AuditRow row{"spring", {}, {}};
  AuditFinding finding{"gradient", true, 0, 0.2, ""};
  finding.Note(0.1, "here");
  finding.Note(std::nan(""), "there");
  finding.Note(7, "elsewhere");
  row.findings = {finding};
  EXPECT_FALSE(row.ok());
  const auto json = nlohmann::json::parse(ToJson({row}));
  EXPECT_EQ(json["ok"], false);
  EXPECT_TRUE(json["energies"][0]["checks"][0]["figure"].is_null());
  EXPECT_EQ(json["energies"][0]["checks"][0]["where"], "there");
  EXPECT_THAT(ToText({row}), HasSubstr("gradient"));
  EXPECT_THAT(ToText({row}), HasSubstr("spring: gradient failed: nan > 0.2 at there"));
}

}  // namespace
}  // namespace cirque::audit_energies
