// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_BENCH_PAPER_STATISTICS_HPP
#define TERN_BENCH_PAPER_STATISTICS_HPP

#include <time.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "quantile.hpp"

namespace tern_bench {

/// 0 for no values.
inline double mean(const std::vector<double>& values) {
  return values.empty() ? 0.0 : std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Of the sample (n - 1); 0 for fewer than two values.
inline double standard_deviation(const std::vector<double>& values) {
  if (values.size() < 2) return 0.0;
  const double middle = mean(values);
  double sum = 0.0;
  for (const double v : values) sum += (v - middle) * (v - middle);
  return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

/// Slope of the least-squares line through (x, y).
inline double slope(const std::vector<double>& x, const std::vector<double>& y) {
  const double mx = mean(x);
  const double my = mean(y);
  double xy = 0.0;
  double xx = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xy += (x[i] - mx) * (y[i] - my);
    xx += (x[i] - mx) * (x[i] - mx);
  }
  return xy / xx;
}

/// Processor time of this thread, milliseconds: other work on the machine counts only by what it does to the caches.
inline double thread_time() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) * 1e3 + static_cast<double>(t.tv_nsec) * 1e-6;
}

/// The least of several runs, milliseconds. What takes longer than 0.2 s is run once.
template <typename Work>
double least_time(int repetitions, Work work) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < repetitions && (i == 0 || least < 200.0); ++i) {
    const double begin = thread_time();
    work();
    least = std::min(least, thread_time() - begin);
  }
  return least;
}

}  // namespace tern_bench

#endif
