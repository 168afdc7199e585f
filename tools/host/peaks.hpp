// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_PEAKS_HPP
#define TERN_HOST_PEAKS_HPP

#include <string>
#include <vector>

#include "host/figures.hpp"

namespace tern_host {

/// What a limit holds for, and how much of it a plan uses.
struct LimitedPeak {
  std::string name;  ///< "x", "y", "z" or "horizontal"
  std::string text;  ///< "1.98 of 2.00", or "0.80 of 3.00, -0.41 of -1.00" where down differs from up
};

/// The peak of each axis beside its limit, and of the horizontal norm where that is limited.
std::vector<LimitedPeak> limited_peaks(const PeakRange& peaks, const LimitRange& limits, int decimals);

}  // namespace tern_host

#endif
