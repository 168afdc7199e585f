// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The corridor stage on random maps of cuboids, a family a row: microseconds a segment, half-spaces, volumes, what the
// polyhedra share and what of them is not free; and what the local box saves. Cases: TERN_SHARED_DIR/cases/corridor.
//
// tern_bench_corridor [--csv FILE]: prints the tables, and writes them to the file where one is given.
#include <cstdio>
#include <fstream>
#include <string>

#include "measure.hpp"
#include "report.hpp"

namespace {

using tern_bench::Samples;

constexpr int kMapsOfFamily = 3;

Samples measure_family(const std::string& family) {
  Samples samples;
  for (int m = 0; m < kMapsOfFamily; ++m) {
    tern_test::CorridorCase c;
    const std::string file = std::string(TERN_SHARED_DIR) + "/cases/corridor/" + family + "_m" + std::to_string(m);
    if (read_corridor_case(file + ".txt", c)) measure_case(c, samples);
  }
  return samples;
}

}  // namespace

int main(int argc, char** argv) {
  const bool to_file = argc == 3 && std::string(argv[1]) == "--csv";
  if (argc != 1 && !to_file) {
    std::fprintf(stderr, "usage: tern_bench_corridor [--csv FILE]\n");
    return 2;
  }
  std::ofstream csv;
  if (to_file) csv.open(argv[2]);
  csv << tern_bench::csv_header();
  std::fputs(tern_bench::table_header().c_str(), stdout);
  Samples all;
  for (const char* family : {"small_10", "small_30", "medium_10", "medium_30", "large_10", "large_30"}) {
    const Samples samples = measure_family(family);
    if (samples.microseconds.empty()) {
      std::fprintf(stderr, "no cases of %s under %s/cases/corridor\n", family, TERN_SHARED_DIR);
      return 2;
    }
    std::fputs(tern_bench::table_row(family, samples).c_str(), stdout);
    csv << tern_bench::csv_row(family, samples);
    append_voxels(all, samples);
  }
  std::fputs(tern_bench::savings(all).c_str(), stdout);
  return 0;
}
