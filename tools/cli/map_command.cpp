// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cinttypes>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/output_paths.hpp"
#include "cli/warnings.hpp"
#include "host/atomic_file.hpp"
#include "host/flight/family_scenario.hpp"
#include "host/map/map_files.hpp"
#include "host/map/scenario_grid.hpp"
#include "host/number.hpp"
#include "host/picture/map_picture.hpp"

namespace tern_cli {
namespace {

using tern_host::brief;
using tern_host::GridMap;

struct MapOptions {
  std::string scenario;
  std::string svg;
  std::vector<std::string> overrides;
};

std::string point(const tern::Vec3& p) {
  return "(" + brief(p.x) + ", " + brief(p.y) + ", " + brief(p.z) + ")";
}

void print_count(const char* name, std::int64_t count, const GridMap& map, const char* what) {
  const double part = static_cast<double>(count) / static_cast<double>(map.voxels);
  std::printf("  %-10s  %" PRId64 " voxels, %s %%%s\n", name, count, tern_host::fixed(100.0 * part, 1).c_str(), what);
}

void print_file(const tern_host::MapFile& file) {
  const tern_host::MapContent& content = file.content;
  const bool cloud = file.kind == tern_host::MapFileKind::kCloud;
  const std::string dropped = cloud ? ", " + std::to_string(content.dropped) + " not finite" : "";
  std::printf("  %-10s  %s: %zu %s%s, %zu outside the boundary\n", cloud ? "cloud" : "octomap", file.name.c_str(),
              content.read, cloud ? "points" : "occupied leaves", dropped.c_str(), content.outside);
}

void print(const tern_host::Scenario& scenario, const GridMap& map) {
  const tern::GridSpec& spec = map.grid.spec();
  std::printf("%s\n", scenario.name.c_str());
  std::printf("  boundary    %s to %s\n", point(scenario.boundary.lower).c_str(),
              point(scenario.boundary.upper).c_str());
  std::printf("  grid        %d x %d x %d voxels of %s m from %s, %s MB\n", spec.dims.x, spec.dims.y, spec.dims.z,
              brief(spec.cell).c_str(), point(spec.origin).c_str(),
              tern_host::fixed(8e-6 * static_cast<double>(tern::grid_words(spec.dims)), 2).c_str());
  for (const tern_host::MapFile& file : scenario.map_files) print_file(file);
  print_count("occupied", map.occupied_count, map, "");
  const bool solid = scenario.unknown == tern_host::Unknown::kSolid;
  print_count("unknown", map.unknown_count, map, solid ? ", taken for solid" : ", taken for free");
  print_count("free", map.voxels - map.occupied_count - map.unknown_count, map, "");
  print_count("blocked", map.blocked_count, map, " where the robot's centre may not be");
}

int show_map(const MapOptions& options) {
  const tern_host::Scenario scenario =
      tern_host::named_scenario(options.scenario, options.overrides, tern_host::Ends::kOptional);
  print_warnings(scenario.warnings);
  check_output_paths(tern_host::input_paths(scenario), {options.svg});
  const GridMap map(scenario);
  if (map.status != tern::Status::kOk) {
    std::fprintf(stderr, "%s: no grid: %s; field: %s\n", scenario.name.c_str(), tern::status_meaning(map.status),
                 tern::field_name(map.field));
    return kExitBadInput;
  }
  if (!options.svg.empty()) tern_host::write_files({{options.svg, tern_host::map_svg(scenario, map)}});
  print(scenario, map);
  return kExitOk;
}

}  // namespace

void add_map_command(CLI::App& app, int& exit_status) {
  const auto options = std::make_shared<MapOptions>();
  CLI::App* const command = app.add_subcommand("map", "Print and draw the map of a scenario, without a plan");
  command->add_option("SCENARIO", options->scenario, "Scenario file, with its map files (docs/formats.md)")->required();
  command->add_option("--svg", options->svg, "Draw the map: an oblique view and four slices")->type_name("FILE");
  command
      ->add_option("--set", options->overrides,
                   "Replace a setting of the scenario, e.g. --set resolution=0.2 --set unknown=solid")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command->callback([options, &exit_status] { exit_status = show_map(*options); });
}

}  // namespace tern_cli
