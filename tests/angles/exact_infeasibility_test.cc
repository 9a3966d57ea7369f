#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "cirque/angles/infeasibility.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

/// Vertex 1 of a fan of 6 has two corners and must reach `sum` pi: multiplier 1 there is a certificate
/// from 2 on, for margin eps from 2 (1 - 2 eps) on (both opposite edges are inner ones).
InfeasibilityCertificate TwoCorners(double sum, double epsilon_over_pi = 0) {
  InfeasibilityCertificate certificate;
  certificate.epsilon_over_pi = epsilon_over_pi;
  certificate.face_multiplier.assign(6, 0.0);
  certificate.constrained_vertex = {0, 1};
  certificate.lower_over_pi = certificate.upper_over_pi = {2, sum};
  certificate.vertex_multiplier = {0, 1};
  return certificate;
}

class ExactInfeasibilityCertificate : public ::testing::Test {
 protected:
  bool Holds(const InfeasibilityCertificate& certificate) const {
    return HoldsExactly(t_, certificate);
  }
  const Triangulation t_ = Fan(6, 0.5).triangulation;
};

TEST_F(ExactInfeasibilityCertificate, DecidesTheLastBit) {
  EXPECT_TRUE(Holds(TwoCorners(2)));  // equality is enough at margin 0
  EXPECT_FALSE(Holds(TwoCorners(std::nextafter(2, 0))));
  EXPECT_FALSE(Holds(TwoCorners(2 * (1 - 2 * 0.125), 0.125)));  // at a margin it is not
  EXPECT_TRUE(Holds(TwoCorners(std::nextafter(1.5, 2), 0.125)));
}

TEST_F(ExactInfeasibilityCertificate, HoldsForMultipliersOfAnyMagnitude) {
  for (const double scale : {5e-324, 1e-200, 3.0, 1e300}) {
    InfeasibilityCertificate certificate = TwoCorners(2);
    certificate.vertex_multiplier[1] = scale;
    EXPECT_TRUE(Holds(certificate)) << scale;
    certificate.lower_over_pi[1] = std::nextafter(2, 0);
    EXPECT_FALSE(Holds(certificate)) << scale;
  }
}

TEST_F(ExactInfeasibilityCertificate, PlantedErrorsAreSeen) {
  InfeasibilityCertificate negative = TwoCorners(2.5);
  negative.vertex_multiplier[1] = -1;
  EXPECT_FALSE(Holds(negative));
  InfeasibilityCertificate nothing = TwoCorners(2.5);
  nothing.vertex_multiplier[1] = 0;
  EXPECT_FALSE(Holds(nothing));
  InfeasibilityCertificate on_face = TwoCorners(2);
  on_face.face_multiplier[3] = 1e-300;  // a face's three corners add more on the right
  EXPECT_FALSE(Holds(on_face));
  InfeasibilityCertificate short_one = TwoCorners(2.5);
  short_one.face_multiplier.pop_back();
  EXPECT_FALSE(Holds(short_one));
  InfeasibilityCertificate undefined = TwoCorners(2.5);
  undefined.vertex_multiplier[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(Holds(undefined));
  EXPECT_FALSE(Holds(TwoCorners(2.5, 0.4)));
}

TEST_F(ExactInfeasibilityCertificate, RoundingOfTheTargetDecidesWhatIsCertified) {
  // 2 pi less one ulp leaves room, if little: nothing may be certified at margin 0.
  ConeTargets targets = FreeBoundaryTargets(t_);
  targets.lower[1] = targets.upper[1] = std::nextafter(2 * kPi, 0);
  const AngleConstraints constraints(t_, targets);
  Eigen::VectorXd y = Eigen::VectorXd::Zero(constraints.num_rows());
  y[t_.num_faces() + 1] = 1;
  EXPECT_TRUE(InfeasibilityCertificateFrom(constraints, y).empty());
  EXPECT_GT(FindInfeasibilityCertificate(constraints, 1e-3, y).epsilon_over_pi, 0);
}

}  // namespace
}  // namespace cirque
