// The validation cases: each at its defaults and elsewhere, and what they refuse.
#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "sim/validation/elastica.h"
#include "sim/validation/turned_wire.h"
#include "sim/validation/twisted_rod.h"
#include "sim/validation/validation_case.h"

namespace sim::validation {
namespace {

using Parameters = std::map<std::string, double>;

void expect_pass(const std::string& id, const Parameters& parameters) {
  const auto result = run(id, parameters);
  ASSERT_TRUE(result.has_value()) << result.error().message;
  EXPECT_FALSE(result->simulated.empty());
  EXPECT_FALSE(result->expected.empty());
  for (const Check& check : result->checks) {
    EXPECT_TRUE(check.passed) << id << " " << check.name << ": " << check.deviation << " "
                              << check.unit << ", bound " << check.bound;
  }
  EXPECT_TRUE(result->passed());
}

void expect_refused(const std::string& id, const Parameters& parameters,
                    const std::string& mentioned) {
  const auto result = run(id, parameters);
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().code, base::ErrorCode::invalid_input);
  EXPECT_NE(result.error().message.find(mentioned), std::string::npos) << result.error().message;
}

TEST(Elastica, AgreesWithThePublishedTable) {
  // load P L^2 / EI; deflection / L, shortening / L, angle in degrees
  const double table[][4] = {{0.5, 0.162144, 0.015919, 14.0107},
                             {1.0, 0.301721, 0.056433, 26.4335},
                             {2.0, 0.493457, 0.160642, 44.7910},
                             {5.0, 0.713792, 0.387628, 69.6355},
                             {10.0, 0.810609, 0.554996, 81.9493}};
  for (const auto& row : table) {
    const Elastica exact = loaded_cantilever(1.0, 1.0, row[0]);
    EXPECT_NEAR(exact.y, row[1], 6e-7);  // the table's last digit
    EXPECT_NEAR(1.0 - exact.x, row[2], 6e-7);
    EXPECT_NEAR(exact.angle * 180.0 / std::acos(-1.0), row[3], 6e-5);
  }
}

TEST(Elastica, BentCantileverAgreesWithTheLinearBeam) {
  // small angles: height kappa b^2 / 2, lowered by F L^3 / (3 EI)
  const double force = -1e-4;
  const Elastica exact = bent_cantilever(100.0, 1000.0, 20.0, 1e-4, force);
  EXPECT_NEAR(exact.y, 0.5 * 1e-4 * 400.0 + force * 1e6 / 3000.0, 1e-5);
}

TEST(Elastica, BuckledRodStartsAtEulersLoad) {
  // P / P_Euler = 1 + shortening / 2 to first order
  EXPECT_NEAR(buckled_rod(0.01).load_ratio, 1.0050, 5e-5);
}

TEST(Elastica, ObliqueLoadTurnsTheRodOver) {
  // just beyond Euler's load from straight ahead it bends a little; four times that folds it:
  // elliptic integrals for a force straight back, P / P_Euler = (2 K(k) / pi)^2
  const double euler = std::pow(std::acos(-1.0) / 2.0, 2);
  const double k = std::sin(std::acos(-1.0) / 4.0);  // tip at 90 degrees
  const double load = euler * std::pow(2.0 * std::comp_ellint_1(k) / std::acos(-1.0), 2);
  const Elastica exact = loaded_cantilever(1.0, 1.0, load, std::acos(-1.0) * (1.0 - 1e-9));
  EXPECT_NEAR(exact.angle, std::acos(-1.0) / 2.0, 1e-5);
  EXPECT_NEAR(exact.x, 2.0 * std::comp_ellint_2(k) / std::comp_ellint_1(k) - 1.0, 1e-5);
}

TEST(TwistedRod, YieldsLikeABeamAndWrithesAtGreenhillsTorque) {
  EXPECT_NEAR(std::abs(twisted_rod_deflection(1e-3)), 1.0, 1e-6);
  EXPECT_NEAR(std::tan(kCriticalTorque / 2.0), kCriticalTorque / 2.0, 1e-9);
  EXPECT_GT(std::abs(twisted_rod_deflection(kCriticalTorque * (1.0 - 1e-6))), 1e5);
}

TEST(TurnedWire, FollowsWhereItIsStiffAndWhipsWhereItIsNot) {
  EXPECT_NEAR(base_angle(1.3, 1e-6), 1e-6 * std::cosh(std::sqrt(1.3)), 1e-12);
  EXPECT_FALSE(whip_angle(2.4).has_value());
  // a quarter of a pendulum's period: the tip stands still at pi / 2, the base moves with
  // psi' = sqrt(2 a cos(tip))
  const double quarter = std::comp_ellint_1(std::sin(std::acos(-1.0) / 4.0));
  EXPECT_NEAR(base_angle(quarter * quarter, std::acos(-1.0) / 2.0), std::acos(-1.0), 1e-6);
  EXPECT_GT(*whip_angle(4.0), std::acos(-1.0));
}

TEST(Validation, ListsTheCases) {
  std::string ids;
  for (const CaseDefinition& definition : cases()) {
    ids += definition.id + " ";
    EXPECT_FALSE(definition.source.empty());
    for (const ParameterDefinition& parameter : definition.parameters) {
      EXPECT_GE(parameter.default_value, parameter.minimum) << parameter.id;
      EXPECT_LE(parameter.default_value, parameter.maximum) << parameter.id;
    }
  }
  EXPECT_EQ(ids,
            "cantilever elastica buckling twist capstan pre-curved-tip whip stiction feed-ripple "
            "handle-force ");
}

TEST(Validation, Cantilever) {
  expect_pass("cantilever", {});
  expect_pass("cantilever", {{"load", 2.0}});
  expect_pass("cantilever", {{"length", 900.0}, {"ei", 2300.0}, {"load", 1e-3}, {"elements", 90}});
  expect_pass("cantilever", {{"load", 1e-4}, {"elements", 20}});
}

TEST(Validation, Buckling) {
  expect_pass("buckling", {});
  expect_pass("buckling", {{"elements", 10}});
  expect_pass("buckling", {{"length", 700.0}, {"ei", 40.0}, {"shortening", 15.0}});
}

TEST(Validation, Elastica) {
  expect_pass("elastica", {});
  expect_pass("elastica", {{"direction", 160.0}, {"load", 1.2}});
  expect_pass("elastica", {{"direction", 40.0}, {"length", 300.0}, {"ei", 20.0}, {"load", 1e-3}});
}

TEST(Validation, Twist) {
  expect_pass("twist", {});
  expect_pass("twist", {{"share", 30.0}, {"gj", 2000.0}, {"elements", 30}});
  expect_pass("twist", {{"length", 400.0}, {"ei", 30.0}, {"gj", 15.0}, {"share", 95.0}});
}

TEST(Validation, Whip) {
  expect_pass("whip", {});
  expect_pass("whip", {{"rest_radius", 150.0}});  // follows all the way
  expect_pass("whip", {{"ei", 300.0}, {"gj", 250.0}, {"radius", 50.0}, {"elements", 40}});
}

TEST(Validation, HandleForce) {
  expect_pass("handle-force", {});
  expect_pass("handle-force", {{"element_length", 2.0}, {"mu", 0.1}});
}

TEST(Validation, Capstan) {
  expect_pass("capstan", {});
  expect_pass("capstan", {{"mu", 0.3}});
  expect_pass("capstan", {{"mu", 0.2}, {"angle", 90.0}, {"radius", 60.0}, {"elements", 24}});
  expect_pass("capstan", {{"mu", 0.0}});
}

TEST(Validation, PreCurvedTip) {
  expect_pass("pre-curved-tip", {});
  expect_pass("pre-curved-tip", {{"angle", 75.0}, {"height", 35.0}, {"ei", 1500.0}});
}

TEST(Validation, Stiction) {
  expect_pass("stiction", {});
  expect_pass("stiction", {{"mu", 0.3}, {"ei", 2000.0}, {"hold_time", 1.0}});
}

TEST(Validation, FeedRipple) {
  expect_pass("feed-ripple", {});
  expect_pass("feed-ripple", {{"ei", 2000.0}, {"element_length", 2.0}});
}

TEST(Validation, RefusesWhatTheComparisonDoesNotCover) {
  EXPECT_EQ(run("pendulum").error().code, base::ErrorCode::not_found);
  expect_refused("cantilever", {{"lenght", 100.0}}, "lenght");
  expect_refused("cantilever", {{"length", -1.0}}, "from 10 to 1000 mm");
  expect_refused("cantilever", {{"length", std::nan("")}}, "length");
  expect_refused("cantilever", {{"elements", 50.5}}, "whole number");
  expect_refused("cantilever", {{"load", 100.0}}, "load");
  expect_refused("buckling", {{"elements", 51}}, "even");
  expect_refused("capstan", {{"ei", 2300.0}}, "ei");
  expect_refused("capstan", {{"ei", 2.0}, {"radius", 10.0}}, "limp");
  expect_refused("pre-curved-tip", {{"bend_length", 60.0}}, "bend_length");
}

TEST(Validation, NothingSimulatedIsBorrowed) {
  // a friction coefficient the theory knows and the simulation gets: ratios differ in the digits
  const auto result = run("capstan", {{"mu", 0.25}, {"elements", 16}});
  ASSERT_TRUE(result.has_value());
  for (const Quantity& quantity : result->simulated) {
    for (const Expectation& expectation : result->expected) {
      EXPECT_NE(quantity.value, expectation.value) << quantity.name;
    }
  }
}

}  // namespace
}  // namespace sim::validation
