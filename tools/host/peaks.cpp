// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/peaks.hpp"

#include <algorithm>
#include <cmath>

#include "host/number.hpp"

namespace tern_host {
namespace {

std::string beside(double peak, double limit, int decimals) {
  return fixed(peak, decimals) + (std::isfinite(limit) ? " of " + fixed(limit, decimals) : " (no limit)");
}

/// One figure where both directions share a limit, else one for each.
std::string axis_text(double least, double most, double lower, double upper, int decimals) {
  const bool symmetric = !std::isfinite(upper) || fixed(-lower, decimals) == fixed(upper, decimals);
  if (symmetric) return beside(std::max(most, -least), upper, decimals);
  return beside(most, upper, decimals) + ", " + beside(least, lower, decimals);
}

}  // namespace

std::vector<LimitedPeak> limited_peaks(const PeakRange& peaks, const LimitRange& limits, int decimals) {
  const tern::Vec3& lo = peaks.least;
  const tern::Vec3& hi = peaks.most;
  std::vector<LimitedPeak> all = {{"x", axis_text(lo.x, hi.x, limits.lower.x, limits.upper.x, decimals)},
                                  {"y", axis_text(lo.y, hi.y, limits.lower.y, limits.upper.y, decimals)},
                                  {"z", axis_text(lo.z, hi.z, limits.lower.z, limits.upper.z, decimals)}};
  if (limits.horizontal > 0.0) all.push_back({"horizontal", beside(peaks.horizontal, limits.horizontal, decimals)});
  return all;
}

}  // namespace tern_host
