// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/flight_progress.hpp"
#include "cli/output_paths.hpp"
#include "cli/warnings.hpp"
#include "host/atomic_file.hpp"
#include "host/flight/flown_plan.hpp"
#include "host/flight/full_knowledge.hpp"
#include "host/flight/simulated_flight.hpp"
#include "host/flight/stack_margin.hpp"
#include "host/number.hpp"
#include "host/page/flight_film.hpp"
#include "host/page/page.hpp"
#include "host/picture/flight_picture.hpp"

namespace tern_cli {
namespace {

struct FlyOptions {
  std::string world;
  std::string plan;
  std::vector<std::string> overrides;
  std::string json;
  std::string csv;
  std::string svg;
  std::string html;
  std::string record;
  bool compare = false;
  bool commits = false;
  std::string stack;
  std::vector<std::string> air;  // overrides that --wind, --drag and --vel-max are short for
  int seeds = 10;
};

/// The settings that options stand for, then those of --set.
std::vector<std::string> overrides_of(const FlyOptions& options) {
  std::vector<std::string> all = options.air;
  if (!options.stack.empty()) all.push_back("tracking=" + options.stack);
  all.insert(all.end(), options.overrides.begin(), options.overrides.end());
  return all;
}

bool keeps(const tern_host::FlightResult& result, double margin) {
  return result.tracking_max <= margin * (1.0 + 1e-9);
}

/// What to do where a margin is exceeded.
std::string verdict(bool kept, double needed) {
  if (kept) return "kept";
  char text[128];
  std::snprintf(text, sizeof text, "EXCEEDED: raise tracking_margin to at least %.2f, or lower v_max, a_max or j_max",
                needed);
  return text;
}

void print_tracking(const tern_host::FlightResult& result, double margin) {
  std::printf("tracking error %.3f m at most, %.3f m rms; margin %.3f m: %s\n", result.tracking_max,
              result.tracking_rms, margin,
              verdict(keeps(result, margin), tern_host::up_to_centimetres(result.tracking_max)).c_str());
}

/// What flew, and in what.
std::string conditions(const tern_host::FlightSettings& s) {
  char text[200];
  std::snprintf(text, sizeof text, "wind %.3g m/s with gusts of %.2g m/s, drag %.3g 1/s, %s %.3g m/s", s.air.wind,
                s.air.deviation(), s.air.drag, s.tracking == "px4" ? "MPC_XY_VEL_MAX" : "WPNAV_SPEED", s.stack_speed);
  return text;
}

/// The margin that a plan needs with a flight stack. Returns the exit status.
int print_margin(const tern_host::FinishedPlan& plan, const tern_host::FlightSettings& settings,
                 const FlyOptions& options) {
  const tern_host::StackMargin margin = tern_host::measure_margin(plan.trajectory, settings, options.seeds);
  if (!options.csv.empty()) tern_host::write_files({{options.csv, margin.samples}});
  const bool kept = margin.controller + margin.estimate <= settings.tracking_margin * (1.0 + 1e-9);
  const unsigned long long first = settings.seed;
  std::printf("%s flew the plan with seeds %llu to %llu: %s\n", settings.tracking.c_str(), first,
              first + static_cast<unsigned long long>(margin.flights) - 1, conditions(settings).c_str());
  std::printf("tracking error %.3f m at most, %.3f m rms (seed %llu); margin %.3f m: %s\n", margin.controller,
              margin.rms, static_cast<unsigned long long>(margin.worst_seed), settings.tracking_margin,
              verdict(kept, margin.needed()).c_str());
  std::printf(
      "set tracking_margin %.2f: it holds %.3f m of the controller and %.3f m of the estimate, for these limits, "
      "this air and the stack's default gains\n",
      margin.needed(), margin.controller, margin.estimate);
  return kept ? kExitOk : kExitNoPlan;
}

void print_mission(const tern_host::FlightResult& result) {
  for (std::size_t i = 0; i < result.mission.size(); ++i) {
    const tern_host::MissionPoint& point = result.mission[i];
    std::printf("point %zu %s", i + 1, point.state.c_str());
    if (point.state == "passed")
      std::printf(" at %.2f s, %.3f m away, %.2f m/s", point.time, point.distance, point.speed);
    std::printf("\n");
  }
}

/// How many voxels were looked at and not seen, and the one that was looked at most often.
void print_in_vain(const std::vector<tern::UnseenVoxel>& voxels) {
  if (voxels.empty()) return;
  const auto less = [](const tern::UnseenVoxel& a, const tern::UnseenVoxel& b) { return a.views < b.views; };
  const tern::UnseenVoxel& most = *std::max_element(voxels.begin(), voxels.end(), less);
  std::printf("looked in vain at %zu voxel%s, most often (%d time%s) at %.2f %.2f %.2f\n", voxels.size(),
              voxels.size() == 1 ? "" : "s", most.views, most.views == 1 ? "" : "s", most.center.x, most.center.y,
              most.center.z);
}

/// How often the body touched a thing that moves, and the first one that it touched while it moved itself.
void print_things(const tern_host::FlightWorld& world, const tern_host::ThingTotals& totals) {
  if (world.things.empty()) return;
  std::printf("things: %zu, %zu known at once at most; touched %d in motion, %d at rest\n", world.things.size(),
              totals.detector.most_known, totals.in_motion(), totals.at_rest());
  for (const tern_host::ThingContact& contact : totals.contacts) {
    if (!contact.in_motion) continue;
    std::printf("touched %s at %.3f s, at %.2f m/s; it was %s the tube that the plan was proven with\n",
                world.things[contact.thing].name.c_str(), contact.time, contact.speed,
                contact.in_tube ? "in" : "not in");
    return;
  }
}

void print(const tern_host::FlightWorld& world, const tern_host::FlightResult& result) {
  const double mean = result.time > 0.0 ? result.length / result.time : 0.0;
  std::printf("%s after %.2f s, %.2f m, %.2f m/s on average\n", result.status.c_str(), result.time, result.length,
              mean);
  if (!result.reached()) std::printf("why: %s\n", result.reason.c_str());
  if (result.blocked_by != tern::BlockedBy::kNothing) std::printf("in the way: %s\n", result.blocked().c_str());
  if (result.narrow.found) std::printf("too narrow: %s\n", result.narrow.text().c_str());
  if (!result.reached()) print_in_vain(result.looked_in_vain);
  if (!world.vias.empty()) print_mission(result);
  print_things(world, result.things);
  if (result.far.searches > 0) {
    std::printf("far way: %d sought, %d cells marked\n", result.far.searches, result.far.marked);
  }
  if (result.view_wait > 0.0) std::printf("the field of view slowed the flight for %.2f s\n", result.view_wait);
  std::printf("least clearance %.3f m\n", result.min_clearance);
  print_tracking(result, world.settings.tracking_margin);
  if (result.full_knowledge > 0.0) {
    std::printf("one plan with full knowledge takes %.2f s: the flight took %.3f times that\n", result.full_knowledge,
                result.time / result.full_knowledge);
  }
  std::printf("plans: %u asked, %u committed, %u dropped, %u failed\n", result.asked, result.committed, result.dropped,
              result.failed);
}

/// A finished plan in place of a world.
int fly_finished_plan(const FlyOptions& options) {
  if (!options.world.empty() || !options.json.empty() || !options.svg.empty() || !options.html.empty() ||
      !options.record.empty() || options.compare) {
    throw std::runtime_error("--plan goes with --set, --stack, --wind, --drag, --vel-max, --seeds and --csv alone");
  }
  check_output_paths({options.plan}, {options.csv});
  const tern_host::FinishedPlan plan = tern_host::read_finished_plan(options.plan);
  tern_host::FlightSettings settings;
  if (plan.tracking_margin > 0.0) settings.tracking_margin = plan.tracking_margin;
  settings = tern_host::flight_settings(overrides_of(options), settings);
  if (tern_host::is_stack(settings.tracking)) return print_margin(plan, settings, options);
  const tern_host::FlightResult result = tern_host::fly_plan(plan.trajectory, settings);
  if (!options.csv.empty()) tern_host::write_files({{options.csv, result.samples}});
  std::printf("%s flew the plan in %.2f s\n", settings.tracking.c_str(), result.time);
  print_tracking(result, settings.tracking_margin);
  return keeps(result, settings.tracking_margin) ? kExitOk : kExitNoPlan;
}

/// Nobody looks on where there is neither a film nor a terminal.
tern_host::FlightOnlooker onlooker_of(tern_host::FlightFilm* film, FlightProgress& progress) {
  if (film == nullptr && !progress.is_shown()) return {};
  return [film, &progress](const tern_host::FlightMoment& moment) {
    if (film != nullptr) film->note(moment);
    progress.note(moment);
  };
}

int fly(const FlyOptions& options) {
  if (!options.plan.empty()) return fly_finished_plan(options);
  if (options.world.empty()) throw std::runtime_error("fly needs a WORLD, or --plan");
  if (options.commits && options.json.empty()) throw std::runtime_error("--commits goes with --json");
  if (!options.html.empty()) tern_host::check_page(1);
  std::vector<std::string> paths;
  for (const std::string& path : {options.json, options.csv, options.svg, options.html, options.record}) {
    if (!path.empty()) paths.push_back(path);
  }
  check_output_paths({options.world}, paths);
  const tern_host::FlightWorld world = tern_host::read_flight_world(options.world, overrides_of(options));
  print_warnings(world.warnings);
  std::unique_ptr<tern_host::FlightFilm> film;
  if (!options.html.empty()) film = std::make_unique<tern_host::FlightFilm>(world);
  std::string record;
  FlightProgress progress(world);
  tern_host::FlightResult result =
      tern_host::simulate_flight(world, onlooker_of(film.get(), progress), options.record.empty() ? nullptr : &record);
  progress.finish();
  if (options.compare) result.full_knowledge = tern_host::full_knowledge_time(world);
  std::vector<tern_host::Output> outputs;
  if (!options.json.empty()) outputs.push_back({options.json, tern_host::flight_json(world, result, options.commits)});
  if (!options.csv.empty()) outputs.push_back({options.csv, result.samples});
  if (!options.svg.empty()) {
    outputs.push_back({options.svg, tern_host::flight_svg(with_appeared(world, result.appeared), result)});
  }
  if (film != nullptr) outputs.push_back({options.html, tern_host::page_html({film->run(result)})});
  if (!options.record.empty()) outputs.push_back({options.record, record});
  tern_host::write_files(outputs);
  print(world, result);
  return result.reached() && keeps(result, world.settings.tracking_margin) ? kExitOk : kExitNoPlan;
}

}  // namespace

namespace {

void add_air_option(CLI::App& command, FlyOptions& options, const char* name, const std::string& key,
                    const char* text) {
  command
      .add_option_function<double>(
          name, [&options, key](const double& value) { options.air.push_back(key + "=" + tern_host::exact(value)); },
          text)
      ->type_name("NUMBER");
}

}  // namespace

void add_fly_command(CLI::App& app, int& exit_status) {
  const auto options = std::make_shared<FlyOptions>();
  CLI::App* const command = app.add_subcommand("fly", "Fly through a world that is discovered on the way");
  command->add_option("WORLD", options->world,
                      "World file (docs/formats.md), or FAMILY:SEED, e.g. P25:7, or P25@8:7 at 8 m/s");
  command->add_option("--plan", options->plan, "Fly a finished plan of `tern plan --json` instead, and say how far off")
      ->type_name("FILE");
  command->add_option("--stack", options->stack, "The flight stack that flies: px4 or ardupilot, as tracking of --set")
      ->check(CLI::IsMember({"px4", "ardupilot"}))
      ->type_name("STACK");
  add_air_option(*command, *options, "--wind", "wind", "Mean speed of the wind, m/s");
  add_air_option(*command, *options, "--drag", "drag", "Level deceleration for each m/s through the air, 1/s");
  add_air_option(*command, *options, "--vel-max", "stack_speed",
                 "MPC_XY_VEL_MAX of px4, WPNAV_SPEED of ardupilot, m/s");
  command->add_option("--seeds", options->seeds, "With --plan and a stack: flights of the plan, each with its own wind")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000), "")
      ->type_name("N");
  command->add_option("--set", options->overrides, "Replace a setting of the world")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command->add_option("--json", options->json, "Write the log of the flight")->type_name("FILE");
  command->add_flag("--commits", options->commits, "Add all committed plans to the log, for `tern verify`");
  command->add_option("--csv", options->csv, "Write one row for each tick")->type_name("FILE");
  command->add_option("--svg", options->svg, "Draw the world and the way flown, from above and from the side")
      ->type_name("FILE");
  command
      ->add_option(
          "--html", options->html,
          "Write a page to look at the flight in 3D, over time, with what it knew and meant to do (docs/page.md)")
      ->type_name("FILE");
  command->add_option("--record", options->record, "Write the flight with its frames, for `tern replay`")
      ->type_name("FILE");
  command->add_flag("--compare", options->compare, "Also plan the flight with full knowledge of the world");
  command->footer(
      "Families: P49, P36, P25, P12 (forests of thin trees), S05, S10, S20 (thick cylinders), C (hidden corner),\n"
      "B (bug trap), O (storey with doors), M (maze); missions: L (survey lines), G (lap through ten gates),\n"
      "I (inspection), D (delivery); with a camera fixed to the body: V (up and down), F (open field),\n"
      "K (from the ground to the ground), H (hills), T30 (slope), E (power lines), R (leaning trunks),\n"
      "W (warehouse), N (nets), Q (lap round a room), X (window), U (stairs); where things move: T1-50 to T1-250,\n"
      "T4 and T5-50 to T5-200 (published with MADER, DYNUS and SANDO), B50, B100 (boxes on knots), CW (crowd in\n"
      "offices), RX (road crossing), MF (forest with people, carts and birds), HU (hunters).\n"
      "Exit status 3 where the goal is not reached, or the tracking error exceeds its margin.");
  command->callback([options, &exit_status] { exit_status = fly(*options); });
}

}  // namespace tern_cli
