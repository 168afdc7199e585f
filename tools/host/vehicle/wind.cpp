// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/vehicle/wind.hpp"

#include <boost/random/uniform_real_distribution.hpp>
#include <cmath>

#include "host/yaw/yaw_units.hpp"

namespace tern_host {
namespace {

constexpr double kGustTime = 1.5;  // seconds over which gusts are alike

}  // namespace

Wind::Wind(const Air& air, std::uint64_t seed) : engine_(seed) {
  const double seeded = boost::random::uniform_real_distribution<double>(0.0, kTurn)(engine_);
  const double angle = air.has_angle ? air.angle : seeded;
  mean_ = air.wind * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0);
  deviation_ = air.deviation() * Eigen::Vector3d(1.0, 1.0, 0.5);
}

Eigen::Vector3d Wind::advance(double step) {
  const double keep = std::exp(-step / kGustTime);
  const double fresh = std::sqrt(1.0 - keep * keep);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    gust_[axis] = keep * gust_[axis] + fresh * deviation_[axis] * normal_(engine_);
  }
  return mean_ + gust_;
}

}  // namespace tern_host
