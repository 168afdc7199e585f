// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report.hpp"

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <sstream>

#include "quantile.hpp"

namespace tern_bench {
namespace {

double median(const std::vector<double>& values) {
  return quantile(values, 0.5);
}

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

double least(const std::vector<double>& values) {
  return values.empty() ? 0.0 : *std::min_element(values.begin(), values.end());
}

template <typename... Values>
std::string print(const char* format, Values... values) {
  char line[256];
  std::snprintf(line, sizeof line, format, values...);
  return line;
}

std::string saving(const char* what, const std::vector<double>& with, const std::vector<double>& without) {
  const double count = static_cast<double>(with.size());
  return print("%s: %.0f a segment with the local box, %.0f without: %.1f %% fewer (the paper: 53.2 %%)\n", what,
               sum(with) / count, sum(without) / count, 100.0 * (1.0 - sum(with) / sum(without)));
}

void append(std::vector<double>& all, const std::vector<double>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

std::string table_header() {
  return "family      us a segment       half-spaces     volume m3 (paper's method)   least    unsafe   failed  "
         "polyhedra"
         "\n            median p99 max     median (mean)   segments      polylines    overlap  m3               of "
         "legs\n";
}

std::string table_row(const std::string& family, const Samples& s) {
  return print("%-10s %6.1f %5.1f %5.1f", family.c_str(), median(s.microseconds), quantile(s.microseconds, 0.99),
               quantile(s.microseconds, 1.0)) +
         print("  %3.0f (%.2f)", median(s.planes), sum(s.planes) / static_cast<double>(s.planes.size())) +
         print("  %5.2f (%5.2f) %5.2f (%5.2f)", median(s.volume), median(s.paper_volume), median(s.line_volume),
               median(s.paper_line_volume)) +
         print("  %.4f  %.1e  %d   %3d of %3d\n", least(s.overlap), s.unsafe, s.failed, s.polyhedra, s.legs);
}

std::string csv_header() {
  return "family,median_us,p99_us,max_us,planes,all_planes,segment_volume_m3,"
         "polyline_volume_m3,paper_segment_volume_m3,paper_polyline_volume_m3,least_overlap_m,unsafe_m3,"
         "voxels,voxels_without_box,polyhedra,legs,failed\n";
}

std::string csv_row(const std::string& family, const Samples& s) {
  std::ostringstream row;
  row << family;
  for (const double figure :
       {median(s.microseconds), quantile(s.microseconds, 0.99), quantile(s.microseconds, 1.0), median(s.planes),
        sum(s.planes), median(s.volume), median(s.line_volume), median(s.paper_volume), median(s.paper_line_volume),
        least(s.overlap), s.unsafe, median(s.voxels), median(s.voxels_without)}) {
    row << ',' << figure;
  }
  row << ',' << s.polyhedra << ',' << s.legs << ',' << s.failed << '\n';
  return row.str();
}

std::string savings(const Samples& all) {
  return saving("surface voxels a search", all.voxels, all.voxels_without);
}

void append_voxels(Samples& all, const Samples& more) {
  append(all.voxels, more.voxels);
  append(all.voxels_without, more.voxels_without);
}

}  // namespace tern_bench
