// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/speckle_filter.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tern_host {
namespace {

constexpr double kAgree = 0.1;
constexpr double kAgreePart = 0.02;
constexpr int kSupport = 2;

/// Of an image or a scan.
struct Shape {
  int width, height;
  Sides sides;
};

/// Calls `visit` with the index of each neighbour of a pixel.
template <typename Visit>
void visit_neighbours(int u, int v, const Shape& shape, Visit visit) {
  const int width = shape.width;
  const bool joined = shape.sides == Sides::kJoined;
  const int first = joined ? u - 1 : std::max(0, u - 1);
  const int last = joined ? u + 1 : std::min(width - 1, u + 1);
  for (int y = std::max(0, v - 1); y <= std::min(shape.height - 1, v + 1); ++y) {
    for (int x = first; x <= last; ++x) {
      const int column = x < 0 ? width - 1 : (x == width ? 0 : x);
      if (x != u || y != v) visit(static_cast<std::size_t>(y * width + column));
    }
  }
}

}  // namespace

template <typename Depth>
void filter_speckle(std::vector<Depth>& depths, int width, int height, double noise, Sides sides) {
  const Shape shape{width, height, sides};
  const Depth least_off = static_cast<Depth>(kAgree);
  const Depth part = static_cast<Depth>(kAgreePart + 2.0 * noise);
  std::vector<char> wrong(depths.size());
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      const std::size_t at = static_cast<std::size_t>(v * width + u);
      int agree = 0;
      visit_neighbours(u, v, shape, [&](std::size_t other) {
        const Depth off = least_off + part * std::min(depths[at], depths[other]);
        agree += std::abs(depths[at] - depths[other]) <= off ? 1 : 0;
      });
      wrong[at] = agree < kSupport ? 1 : 0;
    }
  }
  std::vector<Depth> filtered = depths;
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      const std::size_t at = static_cast<std::size_t>(v * width + u);
      if (wrong[at] == 0) continue;
      Depth least = 0;
      visit_neighbours(u, v, shape, [&](std::size_t other) {
        if (wrong[other] == 0 && (least <= 0 || depths[other] < least)) least = depths[other];
      });
      filtered[at] = least;
    }
  }
  std::copy(filtered.begin(), filtered.end(), depths.begin());  // in place: views point into it
}

template void filter_speckle(std::vector<float>&, int, int, double, Sides);
template void filter_speckle(std::vector<double>&, int, int, double, Sides);

}  // namespace tern_host
