// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_THINGS_PYTHON_RANDOM_HPP
#define TERN_HOST_THINGS_PYTHON_RANDOM_HPP

#include <boost/random/mersenne_twister.hpp>
#include <cstdint>

namespace tern_host {

/// The numbers of Python's `random`, for scenes that are published as scripts.
class PythonRandom {
 public:
  /// random.seed(seed)
  explicit PythonRandom(std::uint32_t seed);
  /// random.random()
  double unit();
  /// random.uniform(lower, upper)
  double uniform(double lower, double upper) { return lower + (upper - lower) * unit(); }

 private:
  boost::random::mt19937 engine_;
};

}  // namespace tern_host

#endif
