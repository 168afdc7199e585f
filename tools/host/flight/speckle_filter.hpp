// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_FLIGHT_SPECKLE_FILTER_HPP
#define TERN_HOST_FLIGHT_SPECKLE_FILTER_HPP

#include <vector>

namespace tern_host {

/// What is beside an image's first and last columns: nothing, or each other, as in a scan all around.
enum class Sides { kApart, kJoined };

/// What a sensor's driver does about wrong pixels. A pixel that fewer than two of its eight neighbours agree with is
/// taken for wrong, and replaced by the least depth among the neighbours that are not; without one, by 0: no depth. Two
/// depths agree within 0.1 m, a fiftieth of the depth, and twice the noise. So things one pixel wide stay as long as
/// they are three pixels long. `noise`: largest error, metres a metre of depth. For a scan, a pixel is a beam.
template <typename Depth>
void filter_speckle(std::vector<Depth>& depths, int width, int height, double noise, Sides sides = Sides::kApart);

extern template void filter_speckle(std::vector<float>&, int, int, double, Sides);
extern template void filter_speckle(std::vector<double>&, int, int, double, Sides);

}  // namespace tern_host

#endif
