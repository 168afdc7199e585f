// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The timing gate's corpus: scenario files, turned into constant tables when the image is built.
#ifndef TERN_BENCH_TIMING_CASES_HPP
#define TERN_BENCH_TIMING_CASES_HPP

#include "tern/tern.hpp"

namespace tern_timing {

/// One scenario. World frame, SI units.
struct Case {
  const char* name;
  tern::Box boundary;
  double resolution;
  double radius;
  const tern::Box* blocks;
  int block_count;
  tern::Request request;
};

extern const Case kCases[];
extern const int kCaseCount;

}  // namespace tern_timing

#endif
