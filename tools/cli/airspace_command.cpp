// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/output_paths.hpp"
#include "host/airspace/airspace.hpp"
#include "host/atomic_file.hpp"

namespace tern_cli {
namespace {

struct AirspaceOptions {
  std::vector<std::string> files;
  std::vector<double> origin;
  double height = NAN;
  double height_amsl = NAN;
  double undulation = NAN;
  std::vector<double> boundary{-1000.0, -1000.0, 0.0, 1000.0, 1000.0, 120.0};
  std::vector<double> ground;
  std::string epoch;
  std::vector<std::string> events;
  std::string fences;
  std::string svg;
  tern_host::AirspaceSettings settings;
};

/// `NAME=TIME`, such as SR=05:31Z.
void add_event(const std::string& text, tern_host::DayEvents& events) {
  const std::size_t equals = text.find('=');
  const auto time = equals == std::string::npos ? std::nullopt : tern_host::parse_day_time(text.substr(equals + 1));
  if (!time || equals == 0) throw std::runtime_error("--event " + text + ": it must be like SR=05:31Z");
  events[text.substr(0, equals)] = *time;
}

tern_host::AirspaceSettings settings_of(const AirspaceOptions& options) {
  tern_host::AirspaceSettings settings = options.settings;
  const std::vector<double>& b = options.boundary;
  settings.fit.boundary = {{b[0], b[1], b[2]}, {b[3], b[4], b[5]}};
  for (const double value : b) {
    if (!std::isfinite(value)) throw std::runtime_error("--boundary must be six finite numbers");
  }
  if (!options.origin.empty()) settings.origin = tern_host::GeoPoint{options.origin[0], options.origin[1]};
  if (!std::isnan(options.height)) settings.height = options.height;
  if (!std::isnan(options.height_amsl)) settings.heights.origin_sea_level = options.height_amsl;
  if (!std::isnan(options.undulation)) settings.heights.undulation = options.undulation;
  if (!options.ground.empty()) settings.heights.ground = tern_host::HeightRange{options.ground[0], options.ground[1]};
  if (!options.ground.empty() && !(options.ground[0] <= options.ground[1])) {
    throw std::runtime_error("--ground takes the lower height first");
  }
  if (!options.epoch.empty()) {
    settings.epoch = tern_host::parse_instant(options.epoch);
    if (!settings.epoch) throw std::runtime_error("--epoch must be like 2026-03-01T09:30:00Z, with a time zone");
  }
  for (const std::string& event : options.events) add_event(event, settings.events);
  return settings;
}

int show_airspace(const AirspaceOptions& options) {
  std::vector<std::string> inputs = options.files;
  for (const std::string& file : {options.settings.heights.geoid_file, options.settings.heights.terrain_file}) {
    if (!file.empty()) inputs.push_back(file);
  }
  check_output_paths(inputs, {options.fences, options.svg});
  tern_host::AirspaceSettings settings = settings_of(options);
  settings.note = [](const std::string& what) { std::fprintf(stderr, "tern: %s\n", what.c_str()); };
  std::vector<tern_host::AirspaceFile> files;
  for (const std::string& path : options.files) files.push_back(tern_host::read_airspace(path));
  const tern_host::Airspace airspace = tern_host::make_airspace(files, settings);
  std::vector<tern_host::Output> outputs;
  if (!options.fences.empty()) outputs.push_back({options.fences, tern_host::fences_text(airspace)});
  if (!options.svg.empty()) outputs.push_back({options.svg, tern_host::airspace_svg(airspace)});
  tern_host::write_files(outputs);
  std::fputs(tern_host::airspace_table(airspace).c_str(), stdout);
  return kExitOk;
}

void add_height_options(CLI::App& command, AirspaceOptions& options) {
  tern_host::HeightSources& heights = options.settings.heights;
  CLI::Option* const height =
      command.add_option("--height", options.height, "Of the origin above the WGS84 ellipsoid, m");
  command.add_option("--height-amsl", options.height_amsl, "Of the origin above mean sea level, m")->excludes(height);
  CLI::Option* const undulation = command.add_option("--undulation", options.undulation,
                                                     "Mean sea level above the WGS84 ellipsoid, m: the same all over");
  command.add_option("--geoid", heights.geoid_file, "A geoid of GeographicLib, such as egm96-5.pgm")
      ->type_name("FILE")
      ->excludes(undulation);
  CLI::Option* const ground =
      command.add_option("--ground", options.ground, "No ground is lower or higher than this, m above mean sea level")
          ->type_name("LOW HIGH")
          ->expected(2);
  command.add_option("--terrain", heights.terrain_file, "A tile of SRTM, such as N47E008.hgt")
      ->type_name("FILE")
      ->excludes(ground);
}

void add_zone_options(CLI::App& command, AirspaceOptions& options) {
  tern_host::AirspaceSettings& settings = options.settings;
  command.add_option("--epoch", options.epoch, "When the flight's clock is 0, e.g. 2026-03-01T09:30:00Z")
      ->type_name("TIME");
  command.add_option("--hours", settings.hours, "Leave out what does not hold so many hours after the epoch")
      ->capture_default_str();
  command.add_option("--clock-error", settings.clock_error, "By how many seconds the flight's clock may be off");
  const auto many = [&command](const char* name, std::vector<std::string>& values, const char* what) {
    return command.add_option(name, values, what)->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  };
  many("--event", options.events, "When sunrise or the like is, e.g. --event SR=05:31Z")->type_name("NAME=TIME");
  many("--leave-out", settings.leave_out, "Leave out a zone, e.g. because you have leave to fly there")
      ->type_name("NAME");
  many("--keep-in", settings.keep_in, "Stay in a zone instead of out of it")->type_name("NAME");
}

}  // namespace

void add_airspace_command(CLI::App& app, int& exit_status) {
  const auto options = std::make_shared<AirspaceOptions>();
  tern_host::FitSettings& fit = options->settings.fit;
  CLI::App* const command = app.add_subcommand("airspace", "Make fences of the zones of GeoJSON, KML and other files");
  command->add_option("FILE", options->files, "GeoJSON, KML, KMZ, ED-269, ED-318, F3548 or a plan of QGroundControl")
      ->required();
  command->add_option("--origin", options->origin, "Of the frame, degrees (default: the home of a mission)")
      ->type_name("LATITUDE LONGITUDE")
      ->expected(2);
  command
      ->add_option("--boundary", options->boundary,
                   "Where the flight is, m in the frame; default 1 km around, up to 120 m")
      ->type_name("X0 Y0 Z0 X1 Y1 Z1")
      ->expected(6);
  command->add_option("--clearance", fit.clearance, "Radius and tracking margin of the flight, m")
      ->capture_default_str();
  command->add_option("--looseness", fit.looseness, "How far fences may be from outlines, m")->capture_default_str();
  add_height_options(*command, *options);
  add_zone_options(*command, *options);
  command->add_option("--fences", options->fences, "Write the fences as records of a scenario")->type_name("FILE");
  command->add_option("--svg", options->svg, "Draw the zones")->type_name("FILE");
  command->callback([options, &exit_status] { exit_status = show_airspace(*options); });
}

}  // namespace tern_cli
