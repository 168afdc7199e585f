// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/speckle_filter.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tern_host {
namespace {

constexpr float kAgree = 0.1f;
constexpr double kAgreePart = 0.02;
constexpr int kSupport = 2;

/// Calls `visit` with the index of each neighbour of a pixel.
template <typename Visit>
void visit_neighbours(int u, int v, int width, int height, Visit visit) {
  for (int y = std::max(0, v - 1); y <= std::min(height - 1, v + 1); ++y) {
    for (int x = std::max(0, u - 1); x <= std::min(width - 1, u + 1); ++x) {
      if (x != u || y != v) visit(static_cast<std::size_t>(y * width + x));
    }
  }
}

}  // namespace

void filter_speckle(std::vector<float>& depths, int width, int height, double noise) {
  const float part = static_cast<float>(kAgreePart + 2.0 * noise);
  std::vector<char> wrong(depths.size());
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      const std::size_t at = static_cast<std::size_t>(v * width + u);
      int agree = 0;
      visit_neighbours(u, v, width, height, [&](std::size_t other) {
        const float off = kAgree + part * std::min(depths[at], depths[other]);
        agree += std::abs(depths[at] - depths[other]) <= off ? 1 : 0;
      });
      wrong[at] = agree < kSupport ? 1 : 0;
    }
  }
  std::vector<float> filtered = depths;
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      const std::size_t at = static_cast<std::size_t>(v * width + u);
      if (wrong[at] == 0) continue;
      float least = 0.0f;
      visit_neighbours(u, v, width, height, [&](std::size_t other) {
        if (wrong[other] == 0 && (least <= 0.0f || depths[other] < least)) least = depths[other];
      });
      filtered[at] = least;
    }
  }
  std::copy(filtered.begin(), filtered.end(), depths.begin());  // in place: views point into it
}

}  // namespace tern_host
