#include "cirque/layout/stretch_energy.h"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cirque/layout/map_objective.h"

namespace cirque {
namespace {

struct SingularValues {
  double s, t;
  double p() const { return (s + t) * (s + t) / 4; }
  double r() const { return (s - t) * (s - t) / 4; }
};

const std::vector<SingularValues> kSamples = {{1, 1},       {1 + 1e-5, 1},  {1.3, 0.8},
                                              {0.2, 0.1},   {7, 5},         {3, 1e-3},
                                              {4e-3, 3e-3}, {1e3, 1 / 1e3}, {2, 2}};

/// All with three weights where they read one.
void ForEachEnergy(const std::function<void(const std::string&, const StretchEnergy&)>& check) {
  for (const std::string& name : StretchEnergies().Names()) {
    StretchEnergy energy = *StretchEnergies().Find(name);
    for (const double weight : {0.0, 0.3, 1.0}) {
      if (weight > 0 && !energy.blends) continue;
      energy.weight = weight;
      check(name + " weight " + std::to_string(weight), energy);
    }
  }
}

StretchTerms At(const StretchEnergy& energy, double p, double r) {
  return energy.terms(p, r, energy.weight);
}

/// The scale: what rounding and third derivatives leave of differences near an isometry.
void ExpectSlope(double derivative, double above, double below, double step, double scale) {
  EXPECT_NEAR(derivative, (above - below) / (2 * step), 1e-6 * std::abs(derivative) + 1e-7 * scale);
}

TEST(EveryStretchEnergy, DerivativesAreThoseOfTheValue) {
  ForEachEnergy([](const std::string& name, const StretchEnergy& energy) {
    for (const SingularValues& at : kSamples) {
      SCOPED_TRACE(name + " at " + std::to_string(at.s) + ", " + std::to_string(at.t));
      const double p = at.p(), r = at.r(), step = 1e-5 * (p - r);
      const StretchTerms e = At(energy, p, r);
      const StretchTerms more_p = At(energy, p + step, r), less_p = At(energy, p - step, r);
      const StretchTerms more_r = At(energy, p, r + step), less_r = At(energy, p, r - step);
      const double size2 = std::abs(e.pp) + std::abs(e.rr);
      const double size = std::abs(e.p) + std::abs(e.r) + 1e-2 * size2 * (p - r);
      ExpectSlope(e.p, more_p.value, less_p.value, step, size);
      ExpectSlope(e.r, more_r.value, less_r.value, step, size);
      ExpectSlope(e.pp, more_p.p, less_p.p, step, size2);
      ExpectSlope(e.pr, more_p.r, less_p.r, step, size2);
      ExpectSlope(e.pr, more_r.p, less_r.p, step, size2);
      ExpectSlope(e.rr, more_r.r, less_r.r, step, size2);
    }
  });
}

TEST(EveryStretchEnergy, IsLeastAndNothingAtAnIsometry) {
  ForEachEnergy([](const std::string& name, const StretchEnergy& energy) {
    SCOPED_TRACE(name);
    const StretchTerms isometry = At(energy, 1, 0);
    EXPECT_EQ(isometry.value, 0);
    EXPECT_EQ(isometry.p, 0);
    EXPECT_GE(isometry.r, 0);
    for (const SingularValues& at : kSamples) EXPECT_GE(At(energy, at.p(), at.r()).value, 0);
    // What is 1 % off both in angle and in area costs, whatever the weight.
    EXPECT_GT(At(energy, SingularValues{1.02, 1}.p(), SingularValues{1.02, 1}.r()).value, 9e-5);
  });
}

TEST(StretchEnergy, ValuesAreThoseOfTheSingularValues) {
  StretchEnergy blend = *StretchEnergies().Find("area");
  for (const SingularValues& at : kSamples) {
    const auto [s, t] = at;
    const auto value = [&](const char* name) {
      return At(*StretchEnergies().Find(name), at.p(), at.r()).value;
    };
    const double dirichlet = 0.5 * (s * s + t * t + 1 / (s * s) + 1 / (t * t)) - 2;
    EXPECT_NEAR(value("symmetric_dirichlet"), dirichlet, 1e-9 * dirichlet + 1e-15);
    const double rigid = (s - 1) * (s - 1) + (t - 1) * (t - 1) + 0.01 * dirichlet;
    EXPECT_NEAR(value("arap"), rigid, 1e-9 * rigid + 1e-15);
    blend.weight = 0.25;
    const double mixed = 0.75 * (s / t + t / s - 2) + 0.25 * (s * t + 1 / (s * t) - 2);
    EXPECT_NEAR(At(blend, at.p(), at.r()).value, mixed, 1e-9 * mixed + 1e-15);
  }
}

TEST(StretchEnergy, TheBlendGoesFromAnglesToAreas) {
  StretchEnergy blend = *StretchEnergies().Find("area");
  const SingularValues at = {1.7, 0.9}, same_area = {2, 0.5}, conformal = {3, 3};
  blend.weight = 0;
  const double m = (at.s - at.t) / (at.s + at.t);
  EXPECT_NEAR(At(blend, at.p(), at.r()).value, MapObjectives().Find("mips")->value(m * m), 1e-14);
  EXPECT_EQ(At(blend, conformal.p(), conformal.r()).value, 0);
  blend.weight = 1;
  EXPECT_NEAR(At(blend, same_area.p(), same_area.r()).value, 0, 1e-15);
  EXPECT_GT(At(blend, conformal.p(), conformal.r()).value, 7);
  // Half of symmetric Dirichlet to second order, in the middle.
  blend.weight = 0.5;
  const SingularValues near = {1 + 2e-4, 1 - 3e-4};
  const double dirichlet =
      At(*StretchEnergies().Find("symmetric_dirichlet"), near.p(), near.r()).value;
  EXPECT_NEAR(At(blend, near.p(), near.r()).value, dirichlet / 2, 1e-3 * dirichlet);
}

}  // namespace
}  // namespace cirque
