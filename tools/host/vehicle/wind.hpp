// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_VEHICLE_WIND_HPP
#define TERN_HOST_VEHICLE_WIND_HPP

#include <Eigen/Core>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <cstdint>

#include "host/vehicle/air.hpp"

namespace tern_host {

/// A horizontal wind of constant mean, with gusts: on each axis an Ornstein-Uhlenbeck process, which is Dryden
/// turbulence of the first order.
class Wind {
 public:
  Wind(const Air& air, std::uint64_t seed);
  /// The wind after a further `step` seconds, m/s, world frame.
  Eigen::Vector3d advance(double step);

 private:
  boost::random::mt19937_64 engine_;
  boost::random::normal_distribution<double> normal_;
  Eigen::Vector3d mean_;
  Eigen::Vector3d deviation_;
  Eigen::Vector3d gust_ = Eigen::Vector3d::Zero();
};

}  // namespace tern_host

#endif
