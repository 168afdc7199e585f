// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "search/report.hpp"

#include <cstdio>
#include <numeric>

#include "quantile.hpp"

namespace tern_bench {
namespace {

/// Microseconds; totals in milliseconds.
struct Summary {
  double median, p99, worst, total, first_total;
};

double total(const std::vector<double>& times) {
  return 1e-3 * std::accumulate(times.begin(), times.end(), 0.0);
}

Summary summary(const Tally& tally) {
  return {quantile(tally.times, 0.5), quantile(tally.times, 0.99), quantile(tally.times, 1.0), total(tally.times),
          total(tally.first_times)};
}

template <typename... Values>
std::string format(const char* pattern, Values... values) {
  char line[512];
  std::snprintf(line, sizeof line, pattern, values...);
  return line;
}

std::string row(const char* pattern, const Outcome& o) {
  const Summary a = summary(o.astar);
  const Summary t = summary(o.tern);
  const Summary f = summary(o.fast);
  const double queries = o.fast.times.empty() ? 1.0 : static_cast<double>(o.fast.times.size());
  return format(pattern, o.set.c_str(), static_cast<int>(o.astar.times.size()), o.unsolved, o.wrong, a.median, a.p99,
                a.worst, a.total, t.median, t.p99, t.worst, t.total, a.median / t.median, a.p99 / t.p99,
                a.worst / t.worst, a.total / t.total, o.least_ratio, a.total / t.first_total,
                static_cast<unsigned long long>(o.astar.expanded), static_cast<unsigned long long>(o.tern.expanded),
                o.nodes, o.heap, f.median, f.p99, f.worst, f.total, 1.0 + o.excess / queries, 1.0 + o.most_excess);
}

}  // namespace

std::string table_header() {
  return format(
      "%-24s %5s %4s %5s |%9s %9s %9s %9s |%9s %9s %9s %9s |%6s %6s %6s %6s %6s %6s | %s", "set", "n", "none", "wrong",
      "A* med us", "p99 us", "worst us", "total ms", "Tern med", "p99 us", "worst us", "total ms", "med", "p99",
      "worst", "total", "least", "first",
      "expanded A*, Tern; most nodes, heap | fast: med us, p99, worst, total ms; cost / optimum: mean, worst");
}

std::string table_row(const Outcome& outcome) {
  return row(
      "%-24s %5d %4d %5d |%9.1f %9.0f %9.0f %9.1f |%9.1f %9.0f %9.0f %9.1f |%6.1f %6.1f %6.1f %6.1f %6.2f %6.1f | "
      "%llu %llu %u %d | %.1f %.0f %.0f %.1f; %.3f %.3f",
      outcome);
}

std::string csv_header() {
  return "set,queries,unsolved,wrong,astar_median_us,astar_p99_us,astar_worst_us,astar_total_ms,tern_median_us,"
         "tern_p99_us,tern_worst_us,tern_total_ms,median_ratio,p99_ratio,worst_ratio,total_ratio,least_ratio,"
         "first_total_ratio,"
         "astar_expanded,tern_expanded,tern_most_nodes,tern_most_open,fast_median_us,fast_p99_us,fast_worst_us,"
         "fast_total_ms,fast_cost_mean,fast_cost_worst";
}

std::string csv_row(const Outcome& outcome) {
  return row(
      "%s,%d,%d,%d,%.1f,%.1f,%.1f,%.3f,%.1f,%.1f,%.1f,%.3f,%.2f,%.2f,%.2f,%.2f,%.2f,%.2f,%llu,%llu,%u,%d,%.1f,%.1f,%."
      "1f,%.3f,"
      "%.4f,%.4f",
      outcome);
}

}  // namespace tern_bench
