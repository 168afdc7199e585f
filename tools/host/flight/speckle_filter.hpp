// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_FLIGHT_SPECKLE_FILTER_HPP
#define TERN_HOST_FLIGHT_SPECKLE_FILTER_HPP

#include <vector>

namespace tern_host {

/// What a depth camera's driver does about wrong pixels. A pixel that fewer than two of its eight neighbours agree with
/// is taken for wrong, and replaced by the least depth among the neighbours that are not. Two depths agree within 0.1
/// m, a fiftieth of the depth, and twice the noise. So things one pixel wide stay as long as they are three pixels
/// long. `noise`: largest error, metres a metre of depth.
void filter_speckle(std::vector<float>& depths, int width, int height, double noise);

}  // namespace tern_host

#endif
