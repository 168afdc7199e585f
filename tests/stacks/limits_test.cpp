// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Limits of plans from the parameters of autopilots.
#include <gtest/gtest.h>

#include <cmath>
#include <tuple>
#include <vector>

#include "tern/flatness.hpp"
#include "tern_stacks/stacks.hpp"

namespace {

using namespace tern;

TEST(ExportLimits, AreBelowTheParameters) {
  Limits px4{};
  Field field = Field::kVias;
  ASSERT_EQ(limits_from_px4(px4_limits(), px4, &field), Status::kOk);
  EXPECT_EQ(field, Field::kNone);
  EXPECT_EQ(px4.v_max.z, kPx4SpeedShare * 3.0);
  EXPECT_EQ(px4.v_min.z, -(kPx4SpeedShare * 1.5));
  EXPECT_EQ(px4.v_horizontal, kPx4SpeedShare * 12.0);
  EXPECT_EQ(px4.a_min.z, -3.0);
  EXPECT_EQ(px4.a_max.z, 4.0);
  EXPECT_EQ(px4.j_horizontal, 4.0);
  EXPECT_NEAR(px4.tilt_tangent, 1.0, 1e-12);
  EXPECT_DOUBLE_EQ(px4.thrust_max, 2.0 * kGravity);
  EXPECT_DOUBLE_EQ(px4.thrust_min, 0.24 * kGravity);
  EXPECT_NEAR(px4.rate_max, 3.8397, 1e-4);
  Limits ardupilot{};
  ASSERT_EQ(limits_from_ardupilot(ardupilot_limits(), ardupilot), Status::kOk);
  EXPECT_EQ(ardupilot.v_horizontal, 10.0);
  EXPECT_EQ(ardupilot.v_min.z, -1.5);
  EXPECT_EQ(ardupilot.a_max.z, 1.0);
  EXPECT_EQ(ardupilot.j_max.z, kArdupilotJerkShare * 5.0);
  EXPECT_LT(ardupilot.j_horizontal, 5.0);
  EXPECT_NEAR(ardupilot.tilt_tangent, 0.57735, 1e-5);
  EXPECT_DOUBLE_EQ(ardupilot.thrust_max, kGravity / 0.35);
  EXPECT_EQ(ardupilot.rate_max, 0.0);
  ArdupilotLimits slow = ardupilot_limits();
  slow.atc_rate_p_max_deg = 90.0;
  ASSERT_EQ(limits_from_ardupilot(slow, ardupilot), Status::kOk);
  EXPECT_NEAR(ardupilot.rate_max, 1.5708, 1e-4);
  EXPECT_EQ(ardupilot.thrust_min, kGravity - 1.0) << "a rate needs a least thrust";
}

TEST(ExportLimits, OfACrazyflieComeFromThrustAndTilt) {
  Limits limits{};
  Field field = Field::kVias;
  ASSERT_EQ(limits_from_crazyflie(crazyflie_limits(), limits, &field), Status::kOk);
  EXPECT_EQ(field, Field::kNone);
  EXPECT_EQ(limits.v_horizontal, 1.0);
  EXPECT_NEAR(limits.tilt_tangent, 0.36397, 1e-5);
  EXPECT_NEAR(limits.thrust_max, 1.8204 * kGravity, 1e-3);
  EXPECT_NEAR(limits.a_max.z, 0.8204 * kGravity, 1e-3);
  EXPECT_NEAR(limits.a_min.z, (20.0 / 36.0 - 1.0) * kGravity, 1e-9);
  CrazyflieLimits loaded = crazyflie_limits();
  loaded.thrust_base = 48000.0;
  loaded.p_limit = 10.0;
  ASSERT_EQ(limits_from_crazyflie(loaded, limits), Status::kOk);
  EXPECT_NEAR(limits.thrust_max, 1.3653 * kGravity, 1e-3);
  EXPECT_NEAR(limits.tilt_tangent, 0.17633, 1e-5);
}

TEST(ExportLimits, NeedThrustBeyondTheHovers) {
  Limits limits{};
  Field field = Field::kNone;
  Px4Limits px4 = px4_limits();
  px4.mpc_thr_max = 0.5;
  EXPECT_EQ(limits_from_px4(px4, limits, &field), Status::kLimitsInvalid);
  EXPECT_EQ(field, Field::kThrustMax);
  CrazyflieLimits crazyflie = crazyflie_limits();
  crazyflie.thrust_base = 65000.0;
  EXPECT_EQ(limits_from_crazyflie(crazyflie, limits, &field), Status::kLimitsInvalid);
  EXPECT_EQ(field, Field::kThrustMax);
  crazyflie = crazyflie_limits();
  crazyflie.thrust_min = 36000.0;
  EXPECT_EQ(limits_from_crazyflie(crazyflie, limits, &field), Status::kLimitsInvalid);
  EXPECT_EQ(field, Field::kThrustMin);
}

/// Nonsense and the least of each parameter in centimetres; the field names the limit, and the limits stay.
template <typename Parameters>
void expect_refusals(Status (*convert)(const Parameters&, Limits&, Field*), const Parameters& good,
                     const std::vector<std::tuple<double Parameters::*, double, Field>>& cases) {
  for (const auto& [parameter, other_unit, expected] : cases) {
    for (const double value : {other_unit, 0.0, -1.0, 1e-9, 1e9, std::nan(""), HUGE_VAL, -HUGE_VAL}) {
      Parameters bad = good;
      bad.*parameter = value;
      Limits limits{};
      limits.v_horizontal = 7.0;
      Field field = Field::kNone;
      const Status status = convert(bad, limits, &field);
      EXPECT_EQ(status, std::isfinite(value) ? Status::kLimitsInvalid : Status::kNonFiniteInput) << value;
      EXPECT_EQ(field, expected) << value;
      EXPECT_EQ(limits.v_horizontal, 7.0);
      EXPECT_EQ(convert(bad, limits, nullptr), status);
    }
  }
}

TEST(ExportLimits, RefuseNonsenseAndCentimetres) {
  using A = ArdupilotLimits;
  expect_refusals<A>(limits_from_ardupilot, ardupilot_limits(),
                     {{&A::wpnav_speed_m_s, 20.5, Field::kVHorizontal},
                      {&A::wpnav_speed_up_m_s, 10.5, Field::kVMax},
                      {&A::wpnav_speed_dn_m_s, 10.0, Field::kVMin},
                      {&A::wpnav_accel_m_s2, 50.0, Field::kAHorizontal},
                      {&A::wpnav_accel_z_m_s2, 50.0, Field::kAMax},
                      {&A::psc_jerk_xy_m_s3, 100.0, Field::kJHorizontal},
                      {&A::psc_jerk_z_m_s3, 500.0, Field::kJMax},
                      {&A::angle_max_deg, 3000.0, Field::kTiltTangent},
                      {&A::mot_thst_hover, 35.0, Field::kThrustMax}});
  using P = Px4Limits;
  expect_refusals<P>(limits_from_px4, px4_limits(),
                     {{&P::mpc_xy_vel_max, 50.0, Field::kVHorizontal},
                      {&P::mpc_z_vel_max_up, 50.0, Field::kVMax},
                      {&P::mpc_z_vel_max_dn, 50.0, Field::kVMin},
                      {&P::mpc_acc_hor, 200.0, Field::kAHorizontal},
                      {&P::mpc_acc_up_max, 200.0, Field::kAMax},
                      {&P::mpc_acc_down_max, 200.0, Field::kAMin},
                      {&P::mpc_jerk_auto, 100.0, Field::kJMax},
                      {&P::mpc_tiltmax_air, 120.0, Field::kTiltTangent},
                      {&P::mpc_thr_hover, 50.0, Field::kThrustMax},
                      {&P::mpc_thr_min, 12.0, Field::kThrustMin},
                      {&P::mpc_thr_max, 100.0, Field::kThrustMax},
                      {&P::mc_rollrate_max, 2000.0, Field::kRateMax},
                      {&P::mc_pitchrate_max, 2000.0, Field::kRateMax}});
  using C = CrazyflieLimits;
  expect_refusals<C>(limits_from_crazyflie, crazyflie_limits(),
                     {{&C::x_vel_max, 100.0, Field::kVHorizontal},
                      {&C::y_vel_max, 100.0, Field::kVHorizontal},
                      {&C::z_vel_max, 100.0, Field::kVMax},
                      {&C::r_limit, 2000.0, Field::kTiltTangent},
                      {&C::p_limit, 2000.0, Field::kTiltTangent},
                      {&C::thrust_base, 0.55, Field::kThrustMax},
                      {&C::thrust_min, 0.3, Field::kThrustMin}});
  ArdupilotLimits bad = ardupilot_limits();
  Limits limits{};
  Field field = Field::kNone;
  for (const double value : {-1.0, 1e-9, 2000.0}) {
    bad.atc_rate_r_max_deg = value;
    EXPECT_EQ(limits_from_ardupilot(bad, limits, &field), Status::kLimitsInvalid) << value;
    EXPECT_EQ(field, Field::kRateMax);
  }
  bad.atc_rate_r_max_deg = std::nan("");
  EXPECT_EQ(limits_from_ardupilot(bad, limits, &field), Status::kNonFiniteInput);
}

}  // namespace
