// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "companion/options.hpp"

#include <CLI/CLI.hpp>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <vector>

#include "companion/mission_file.hpp"
#include "tern_onboard/parameters.hpp"

namespace tern_companion {
namespace {

void set(tern_onboard::Settings& settings, const std::string& assignment, const std::string& where) {
  const std::size_t sign = assignment.find('=');
  const auto trimmed = [](const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t\r");
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
  };
  if (sign == std::string::npos) throw std::runtime_error(where + "'" + assignment + "' is not NAME=VALUE");
  const std::string fault = tern_onboard::set_parameter_text(settings, trimmed(assignment.substr(0, sign)),
                                                             trimmed(assignment.substr(sign + 1)));
  if (!fault.empty()) throw std::runtime_error(where + fault);
}

void read_parameters(tern_onboard::Settings& settings, const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + ": cannot be read");
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    line = line.substr(0, line.find('#'));
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    set(settings, line, path + ":" + std::to_string(number) + ": ");
  }
}

std::vector<tern::Via> mission_of(const std::string& goal, const std::string& path) {
  if (!path.empty()) {
    std::ifstream file(path);
    if (!file) throw std::runtime_error(path + ": cannot be read");
    return read_mission(file, path);
  }
  if (goal.empty()) return {};
  tern::Via via{};
  if (!read_point(goal, via.position)) throw std::runtime_error("--goal " + goal + ": write EAST,NORTH,UP in metres");
  return {via};
}

}  // namespace

bool read_options(int argc, char** argv, Options& options, int& status) {
  CLI::App app{"Flies a PX4 or ArduPilot vehicle through unknown space: depth in, MAVLink setpoints out."};
  std::string goal, mission, parameters;
  std::vector<std::string> settings;
  bool lists = false;
  TrafficSettings& traffic = options.companion.traffic;
  app.add_option("--link", options.link, "udp:PORT, udp:HOST:PORT or serial:DEVICE:BAUD")->capture_default_str();
  app.add_option("--depth", options.depth, "path of the socket for frames of depth")->capture_default_str();
  app.add_option("--goal", goal, "EAST,NORTH,UP from the local origin, metres");
  app.add_option("--mission", mission, "a file of points")->excludes("--goal");
  app.add_option("--parameters", parameters, "a file of NAME = VALUE lines");
  app.add_option("--set", settings, "NAME=VALUE, after the file; may be repeated");
  app.add_option("--record", options.companion.record,
                 "a folder, for a record of each flight: tern replay flies it again");
  app.add_option("--system", options.companion.system, "of the autopilot; 0: the first one that is heard");
  app.add_option("--own-id", traffic.own_ids,
                 "an id under which the vehicle itself is reported: ICAO address, serial number; may be repeated");
  app.add_option("--geoid", traffic.geoid, "metres of the sea's surface above the ellipsoid, for heights of aircraft")
      ->check(CLI::Range(-120.0, 120.0));
  app.add_option("--own-error", traffic.own_error, "metres by which the vehicle's position on the globe may be off")
      ->check(CLI::Range(0.0, 1000.0))
      ->capture_default_str();
  app.add_flag("--switch-mode", options.companion.asks_for_mode, "ask for offboard or guided, once all is ready");
  app.add_flag("--end-at-goal", options.companion.ends_at_goal, "end a second after the arrival");
  app.add_flag("--lockstep", options.lockstep, "for simulation: take the time from the autopilot's TIMESYNC requests");
  app.add_flag("--list-parameters", lists, "print the parameters and end");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    status = app.exit(error) == 0 ? 0 : 2;
    return false;
  }
  if (lists) {
    std::cout << tern_onboard::parameter_table();
    status = 0;
    return false;
  }
  if (!parameters.empty()) read_parameters(options.companion.onboard, parameters);
  for (const std::string& setting : settings) set(options.companion.onboard, setting, "--set ");
  options.companion.mission = mission_of(goal, mission);
  return true;
}

}  // namespace tern_companion
