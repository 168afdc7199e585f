// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What tracking margin plans need under simulated flight stacks: plans of five of the paper's maps, there and back,
// over speeds, wind, drag and headroom. tools/bench margins runs it, and prints the tables of docs/simulator.md and of
// the stacks' pages.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "margins/flown.hpp"

namespace {

using tern_bench::Plans;

const double kSpeeds[] = {1.0, 2.0, 3.0, 5.0};
const double kHeadrooms[] = {1.0, 1.25, 1.43};
constexpr int kSeeds = 3;

/// One condition of the table that the simulator is held against: a steady wind along x.
struct Condition {
  double drag, wind;
  bool has_headroom;
};
const Condition kConditions[] = {{0.1, 0, true}, {0.1, 0, false}, {0.1, 5, true}, {0.3, 5, true}, {0.3, 5, false}};

void print_measured(Plans& plans) {
  std::printf(
      "| v | 0.1, 0, 12 | 0.1, 0, v | 0.1, 5, 12 | 0.3, 5, 12 | 0.3, 5, v |\n| --- | --- | --- | --- | --- | --- |\n");
  for (int row = 0; row < 5; ++row) {
    const double v = kSpeeds[std::min(row, 3)];
    std::printf(row < 4 ? "| %g |" : "| %g, jerk 5 |", v);
    const std::vector<tern::Trajectory> flown = plans.of(tern_bench::equal_limits(v, row < 4 ? 0.0 : 5.0));
    for (const Condition& c : kConditions) {
      tern_host::FlightSettings s = tern_bench::stack_settings("px4", c.has_headroom ? 12.0 : v, c.drag, c.wind);
      s.air.has_angle = s.air.has_gusts = true;
      std::printf(" %.2f |", tern_bench::largest_error(flown, s, 1));
      std::fflush(stdout);
    }
    std::printf("\n");
  }
}

/// One row for each speed, drag and wind, one column for each headroom.
void print_stack(Plans& plans, const std::string& stack, std::ofstream& csv) {
  std::printf("\n%s\n\n| v m/s | drag 1/s | wind m/s |", stack.c_str());
  for (const double headroom : kHeadrooms) std::printf(" %.2f |", headroom);
  std::printf("\n| --- | --- | --- | --- | --- | --- |\n");
  for (const double v : kSpeeds) {
    const std::vector<tern::Trajectory> flown = plans.of(tern_bench::preset_limits(stack, v));
    for (const double drag : {0.1, 0.3}) {
      for (const double wind : {0.0, 5.0}) {
        std::printf("| %g | %g | %g |", v, drag, wind);
        for (const double headroom : kHeadrooms) {
          const double error = tern_bench::largest_error(
              flown, tern_bench::stack_settings(stack, headroom * v, drag, wind), wind > 0.0 ? kSeeds : 1);
          std::printf(" %.2f |", error);
          std::fflush(stdout);
          csv << stack << ',' << v << ',' << drag << ',' << wind << ',' << headroom << ',' << error << '\n';
        }
        std::printf("\n");
      }
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Tracking margins of simulated flight stacks"};
  std::string path = "margins.csv";
  app.add_option("--csv", path, "Where the table goes")->type_name("FILE");
  CLI11_PARSE(app, argc, argv);
  std::ofstream csv(path);
  csv << "stack,v,drag,wind,headroom,error\n";
  Plans plans;
  print_measured(plans);
  for (const char* const stack : {"px4", "ardupilot"}) print_stack(plans, stack, csv);
  return csv ? 0 : 1;
}
