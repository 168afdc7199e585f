// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the corridor benchmark measures of one family of cases.
#ifndef TERN_BENCH_CORRIDOR_MEASURE_HPP
#define TERN_BENCH_CORRIDOR_MEASURE_HPP

#include <vector>

#include "support/corridor_case.hpp"

namespace tern_bench {

/// One figure a segment each; lengths in metres, volumes in cubic metres.
struct Samples {
  std::vector<double> microseconds, planes;             ///< of all segments
  std::vector<double> volume, line_volume;              ///< of `segment` records, of the legs of `polyline` records
  std::vector<double> paper_volume, paper_line_volume;  ///< the same by the paper's method
  std::vector<double> voxels, voxels_without;           ///< surface voxels in the local box, in the map
  std::vector<double> overlap;  ///< a joint of a polyline each: radius of the ball that both polyhedra hold
  double unsafe = 0.0;          ///< inside obstacle voxels, all polyhedra together
  int failed = 0;
  int legs = 0;       ///< of polylines
  int polyhedra = 0;  ///< that the corridor stage makes for them
};

/// Adds a case's segments and polylines. Each segment is grown alone, the least time of several counts; then each
/// polyline goes through the corridor stage as a path.
void measure_case(const tern_test::CorridorCase& c, Samples& samples);

}  // namespace tern_bench

#endif
