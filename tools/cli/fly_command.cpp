// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/output_paths.hpp"
#include "host/atomic_file.hpp"
#include "host/flight/simulated_flight.hpp"

namespace tern_cli {
namespace {

struct FlyOptions {
  std::string world;
  std::vector<std::string> overrides;
  std::string json;
  std::string csv;
};

void print(const tern_host::FlightResult& result) {
  const double mean = result.time > 0.0 ? result.length / result.time : 0.0;
  std::printf("%s after %.2f s, %.2f m, %.2f m/s on average\n", result.status.c_str(), result.time, result.length,
              mean);
  std::printf("least clearance %.3f m\n", result.min_clearance);
  std::printf("plans: %u asked, %u committed, %u dropped, %u failed\n", result.asked, result.committed, result.dropped,
              result.failed);
}

int fly(const FlyOptions& options) {
  std::vector<std::string> paths;
  for (const std::string& path : {options.json, options.csv}) {
    if (!path.empty()) paths.push_back(path);
  }
  check_output_paths({options.world}, paths);
  const tern_host::FlightWorld world = tern_host::read_flight_world(options.world, options.overrides);
  const tern_host::FlightResult result = tern_host::simulate_flight(world);
  std::vector<tern_host::Output> outputs;
  if (!options.json.empty()) outputs.push_back({options.json, tern_host::flight_json(world, result)});
  if (!options.csv.empty()) outputs.push_back({options.csv, result.samples});
  tern_host::write_files(outputs);
  print(result);
  return result.reached() ? kExitOk : kExitNoPlan;
}

}  // namespace

void add_fly_command(CLI::App& app, int& exit_status) {
  const auto options = std::make_shared<FlyOptions>();
  CLI::App* const command = app.add_subcommand("fly", "Fly through a world that is discovered on the way");
  command->add_option("WORLD", options->world, "World file (docs/formats.md)")->required();
  command->add_option("--set", options->overrides, "Replace a setting of the world")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command->add_option("--json", options->json, "Write the log of the flight")->type_name("FILE");
  command->add_option("--csv", options->csv, "Write one row for each tick")->type_name("FILE");
  command->footer("Exit status 3 where the goal is not reached.");
  command->callback([options, &exit_status] { exit_status = fly(*options); });
}

}  // namespace tern_cli
