// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// tern_companion_flights: flies the companion program through a family of worlds, over UDP, with a simulated autopilot.
// A line a flight; exit status 1 if one touched anything or did not reach its goal.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "autopilot/companion_flight.hpp"

namespace {

using namespace tern_autopilot;

struct Totals {
  int flights = 0, reached = 0, touched = 0;
  double clearance = 1e9;
};

std::string latency_of(const std::string& said) {
  const std::size_t at = said.rfind("from an image's stamp");
  return at == std::string::npos ? "" : said.substr(at, said.find('\n', at) - at);
}

void tell(const std::string& name, const FlightOutcome& outcome, bool verbose, Totals& totals) {
  const bool reached = outcome.exit_status == 0 && !outcome.touched;
  ++totals.flights;
  totals.reached += reached ? 1 : 0;
  totals.touched += outcome.touched ? 1 : 0;
  totals.clearance = std::min(totals.clearance, outcome.clearance);
  std::printf("%-12s %-8s %6.1f s %6.1f m, clearance %.3f m, %llu setpoints, longest gap %.3f s, failsafes %llu\n",
              name.c_str(), outcome.touched ? "CONTACT" : (reached ? "reached" : "stopped"), outcome.time,
              outcome.length, outcome.clearance, static_cast<unsigned long long>(outcome.counts.followed),
              outcome.counts.longest_gap, static_cast<unsigned long long>(outcome.counts.failsafes));
  if (verbose || !reached) std::printf("%s\n", outcome.said.c_str());
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Flies tern_companion through random worlds with a simulated autopilot."};
  CompanionFlight flight;
  std::string family = "P49@2", autopilot = "px4";
  std::vector<std::string> settings;
  int flights = 1, seed = 1;
  bool verbose = false;
  app.add_option("--program", flight.program, "path of tern_companion")->required();
  app.add_option("--family", family, "of worlds, with a speed: P49@2")->capture_default_str();
  app.add_option("--flights", flights, "how many")->capture_default_str();
  app.add_option("--seed", seed, "of the first world")->capture_default_str();
  app.add_option("--autopilot", autopilot, "px4 or ardupilot")->check(CLI::IsMember({"px4", "ardupilot"}));
  app.add_option("--sensors", flight.sensors, "camera, cameras (to both sides), lidar, or both (camera and lidar)")
      ->check(CLI::IsMember({"camera", "cameras", "lidar", "both"}));
  app.add_option("--set", settings, "a setting of the world: wind=5");
  app.add_option("--argument", flight.arguments, "one more word for the program; may be repeated");
  app.add_flag("--real-time", flight.real_time, "by the clock, instead of in lockstep");
  app.add_flag("--verbose", verbose, "print what the program says");
  CLI11_PARSE(app, argc, argv);
  flight.autopilot.is_px4 = autopilot == "px4";
  std::vector<std::string> all = companion_world_settings();
  all.insert(all.end(), settings.begin(), settings.end());
  Totals totals;
  try {
    for (int k = 0; k < flights; ++k) {
      const std::string name = family + ":" + std::to_string(seed + k);
      const FlightOutcome outcome = fly(tern_host::read_flight_world(name, all), flight);
      tell(name, outcome, verbose, totals);
      if (k + 1 == flights) std::printf("the last one: %s\n", latency_of(outcome.said).c_str());
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
  std::printf("%d flights: %d reached, %d contacts, least clearance %.3f m\n", totals.flights, totals.reached,
              totals.touched, totals.clearance);
  return totals.reached == totals.flights ? 0 : 1;
}
