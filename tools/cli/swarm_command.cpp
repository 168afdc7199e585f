// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/output_paths.hpp"
#include "host/atomic_file.hpp"
#include "host/nanoseconds.hpp"
#include "host/number.hpp"
#include "host/page/page.hpp"
#include "host/swarm/swarm.hpp"
#include "host/swarm/swarm_intruders.hpp"
#include "host/swarm/swarm_json.hpp"
#include "host/swarm/swarm_processes.hpp"
#include "host/swarm/swarm_run.hpp"
#include "tern/fleet.hpp"

namespace tern_cli {
namespace {

struct SwarmOptions {
  std::string world;
  std::string json;
  std::string record, html;
  bool processes = false;
  int runs = 1;
  std::vector<double> partition;
  double time_limit = 0.0;
  tern_host::SwarmSettings settings;
  tern_host::IntruderSettings intruders;
};

/// The same family with the seed of a later run.
std::string member_of(const std::string& world, int run) {
  const std::size_t colon = world.find(':');
  if (run == 0 || colon == std::string::npos) return world;
  return world.substr(0, colon + 1) +
         std::to_string(std::strtoull(world.c_str() + colon + 1, nullptr, 10) + static_cast<std::uint64_t>(run));
}

void show_progress(const std::string& name, double time, int arrived, std::size_t count) {
  static double shown = -1.0;
  if (isatty(STDERR_FILENO) == 0 || (time > shown && time < shown + 0.5)) return;
  shown = time;
  std::fprintf(stderr, "\r%s: %.1f s, %d of %zu arrived\033[K", name.c_str(), time, arrived, count);
}

void print_contact(const char* what, const tern_host::SwarmContact& contact) {
  const std::string with = contact.intruder >= 0 ? "intruder " + std::to_string(contact.intruder)
                           : contact.second < 0  ? "an obstacle"
                                                 : "vehicle " + std::to_string(contact.second);
  std::printf("  %s at %.3f s: vehicle %d and %s, %.3f m\n", what, tern_host::seconds_of(contact.time), contact.first,
              with.c_str(), contact.distance);
}

void print(const tern_host::SwarmWorld& world, const tern_host::SwarmResult& result) {
  std::printf("%s: %d of %zu arrived, the last after %.2f s, travel %.2f s on average; %zu contacts\n",
              world.name.c_str(), result.arrived(), world.tasks.size(), result.last_arrival(), result.mean_travel(),
              result.contacts.size());
  std::printf("  least distance %.3f m between centres (bodies touch at %.3f), least clearance %.3f m (%.3f)\n",
              result.least_distance, 2.0 * world.body_radius, result.least_clearance, world.body_radius);
  std::printf("  %" PRIu64 " of %" PRIu64
              " packets lost, %.1f kB a vehicle a second; at most %u units of the fleet a tick\n",
              result.lost, result.packets,
              1e-3 * static_cast<double>(result.bytes) / (result.time * static_cast<double>(world.tasks.size())),
              result.most_fleet_units);
  std::printf("  %.1f s flown in %.1f s of processor time; hash %016" PRIx64 "\n", result.time, result.computed,
              result.hash);
  if (result.most_members > 0 && static_cast<std::size_t>(result.most_members) + 1 < world.tasks.size()) {
    std::printf("  up to %d members of a vehicle's fleet, %.1f on average\n", result.most_members,
                static_cast<double>(result.member_ticks) / static_cast<double>(result.ticks));
  }
  if (result.most_untold > 0) {
    std::printf("  up to %d plans of others were too many for a flight, which knew the nearest ones\n",
                result.most_untold);
  }
  for (std::size_t k = 0; k < result.members.size(); ++k) {
    const tern_host::SwarmMember& member = result.members[k];
    if (member.arrived < 0.0) std::printf("  vehicle %zu: %s\n", k, member.state.c_str());
    if (member.unasked > 0) std::printf("  vehicle %zu braked %u times without asking\n", k, member.unasked);
  }
  if (!world.intruders.empty()) {
    const bool met = result.least_gap < 1e9;  // a vehicle moved
    const std::string gap =
        met ? ", no nearer than " + tern_host::fixed(result.least_gap, 3) + " m to a vehicle in motion" : "";
    std::printf("  %zu intruders%s; touched at rest: %zu\n", world.intruders.size(), gap.c_str(),
                result.touched_at_rest.size());
  }
  for (const tern_host::SwarmContact& contact : result.touched_at_rest) print_contact("touched at rest", contact);
  for (const tern_host::SwarmContact& contact : result.contacts) print_contact("contact", contact);
}

/// What the ranges of single options do not say: they let through what is no number, too.
void check_options(const SwarmOptions& options) {
  const tern_host::SwarmSettings& s = options.settings;
  const tern_host::IntruderSettings& i = options.intruders;
  const double numbers[] = {
      s.links.loss,  s.links.burst, s.links.delay_min, s.links.delay_max, s.links.repeated, s.links.silent_from,
      s.clock_error, s.restarts,    s.send_hz,         s.clearance,       s.discover,       s.late,
      s.range,       i.speed,       i.acceleration,    i.bounds};
  for (const double number : numbers) {
    if (!std::isfinite(number)) throw std::runtime_error("all numbers must be finite");
  }
  if (s.links.delay_min > s.links.delay_max) throw std::runtime_error("--delay-min must be at most --delay");
  const std::vector<double>& partition = options.partition;
  if (!partition.empty() && !(partition[0] < partition[1])) {
    throw std::runtime_error("--partition must begin before it ends");
  }
}

/// Members by range rely on beacons: of everyone near, one that is a second old at most.
void check_range(const SwarmOptions& options) {
  const tern_host::SwarmSettings& s = options.settings;
  if (s.range <= 0.0) return;
  const tern_host::LinkSettings& links = s.links;
  if (links.deaf >= 0 || links.silent >= 0 || !options.partition.empty() || links.loss >= 1.0) {
    throw std::runtime_error(
        "--range takes no vehicles that are never heard: no --deaf, --silent, --partition, --loss 1");
  }
  if (links.delay_max + 1.0 / s.send_hz > 1.0) {
    throw std::runtime_error("--range needs beacons that are a second old at most: --delay and 1 / --send-hz are more");
  }
  if (s.packet_bytes < tern::kFleetBeaconRoom) {
    throw std::runtime_error("--range needs a --packet of at least " + std::to_string(tern::kFleetBeaconRoom));
  }
}

void check_vehicles(const tern_host::LinkSettings& links, std::size_t count) {
  for (const int vehicle : {links.deaf, links.silent}) {
    if (vehicle >= -1 && vehicle < static_cast<int>(count)) continue;
    throw std::runtime_error("--deaf and --silent take the number of a vehicle, 0 to " + std::to_string(count - 1));
  }
}

int fly(SwarmOptions& options) {
  check_options(options);
  check_range(options);
  check_output_paths({}, {options.json, options.record, options.html});
  if (!options.record.empty() && options.runs > 1) throw std::runtime_error("--record takes one run");
  if (!options.html.empty()) tern_host::check_page(static_cast<std::size_t>(options.runs));
  std::vector<std::string> pages;
  if (options.partition.size() == 2) options.settings.links.partition = {options.partition[0], options.partition[1]};
  bool all = true;
  std::string json;
  for (int run = 0; run < options.runs; ++run) {
    tern_host::SwarmWorld world = tern_host::swarm_world(member_of(options.world, run));
    if (options.time_limit > 0.0) world.time_limit = options.time_limit;
    check_vehicles(options.settings.links, world.tasks.size());
    tern_host::SwarmSettings settings = options.settings;
    settings.seed += static_cast<std::uint64_t>(run);
    tern_host::add_intruders(world, options.intruders, settings.seed);
    tern_host::SwarmRecord record;
    const auto progress = [&](double time, int arrived) {
      show_progress(world.name, time, arrived, world.tasks.size());
    };
    const tern_host::SwarmResult result =
        options.processes ? tern_host::fly_swarm_in_processes(world, settings, record)
                          : tern_host::fly_swarm(world, settings, progress, options.record.empty() ? nullptr : &record);
    if (isatty(STDERR_FILENO) != 0) std::fprintf(stderr, "\r\033[K");
    print(world, result);
    std::fflush(stdout);
    if (result.disagreed > 0)
      std::printf("  %u ticks at which a vehicle did not fly what its fleet said\n", result.disagreed);
    all = all && result.disagreed == 0 && result.arrived() == static_cast<int>(world.tasks.size()) &&
          result.contacts.empty();
    if (!options.json.empty()) json += tern_host::swarm_json(world, settings, result);
    if (!options.html.empty()) pages.push_back(tern_host::swarm_run(world, settings, result));
    if (!options.record.empty()) tern_host::write_file(options.record, tern_host::write_swarm_record(record));
  }
  if (!options.html.empty()) tern_host::write_file(options.html, tern_host::page_html(pages));
  if (!options.json.empty()) tern_host::write_files({{options.json, json}});
  return all ? kExitOk : kExitNoPlan;
}

void add_link_options(CLI::App* command, SwarmOptions& options) {
  tern_host::SwarmSettings& s = options.settings;
  command->add_option("--seed", s.seed, "Of links, clocks and intruders")->capture_default_str();
  command->add_option("--loss", s.links.loss, "Part of the packets that is lost")->check(CLI::Range(0.0, 1.0));
  command->add_option("--burst", s.links.burst, "Packets in a row that are lost, on average")
      ->check(CLI::Range(1.0, 1000.0));
  command->add_option("--delay-min", s.links.delay_min, "Least delay of a packet, s")->check(CLI::Range(0.0, 10.0));
  command->add_option("--delay", s.links.delay_max, "Largest delay of a packet, s")->check(CLI::Range(0.0, 10.0));
  command->add_option("--repeated", s.links.repeated, "Part of the packets that comes twice")
      ->check(CLI::Range(0.0, 1.0));
  command->add_option("--partition", options.partition, "Even and odd vehicles do not hear each other then, s")
      ->type_name("FROM UNTIL")
      ->expected(2);
  command->add_option("--deaf", s.links.deaf, "This vehicle hears nobody");
  command->add_option("--silent", s.links.silent, "This vehicle is not heard any more");
  command->add_option("--silent-from", s.links.silent_from, "From then on, s");
}

void add_intruder_options(CLI::App* command, tern_host::IntruderSettings& intruders) {
  command->add_option("--intruders", intruders.count, "Aircraft that are no members and cross the area")
      ->check(CLI::Range(0, tern_host::kMostIntruders));
  command->add_option("--intruder-speed", intruders.speed, "Of the fastest one, m/s (default: half of the vehicles')")
      ->check(CLI::Range(0.0, 100.0));
  command->add_option("--intruder-acceleration", intruders.acceleration, "With which they turn, m/s^2")
      ->check(CLI::Range(0.01, 100.0))
      ->capture_default_str();
  command
      ->add_option("--intruder-bounds", intruders.bounds,
                   "What vehicles are told of speed and acceleration, as a part of what is true")
      ->check(CLI::Range(0.01, 100.0));
}

}  // namespace

void add_swarm_command(CLI::App& app, int& exit_status) {
  const auto options = std::make_shared<SwarmOptions>();
  tern_host::SwarmSettings& s = options->settings;
  CLI::App* const command = app.add_subcommand("swarm", "Fly many vehicles that agree over lossy links");
  command->footer("Families:\n" + tern_host::swarm_families());
  command->add_option("WORLD", options->world, "A family, the number of vehicles and a seed, e.g. swap-8:1")
      ->required();
  command->add_option("--runs", options->runs, "Fly so many worlds, with seeds from that one on")
      ->check(CLI::Range(1, 100000));
  add_link_options(command, *options);
  add_intruder_options(command, options->intruders);
  command->add_option("--clock-error", s.clock_error, "By how much two clocks differ at most, s")
      ->check(CLI::Range(0.0, 1.0));
  command->add_option("--time-limit", options->time_limit, "s of flight at most (default: of the scene)")
      ->check(CLI::Range(0.0, 3600.0));
  command
      ->add_option("--range", s.range,
                   "Only who is that near is a member of a vehicle's fleet, m; radios reach three times as far")
      ->check(CLI::Range(0.0, 1000.0));
  command
      ->add_option("--discover", s.discover,
                   "What stands still is not known: each finds it by a lidar of this range, m, and has its own map")
      ->check(CLI::Range(0.0, 100.0));
  command->add_option("--threads", s.threads, "Threads that compute")->check(CLI::Range(1, 256));
  command->add_option("--restarts", s.restarts, "How often each vehicle begins anew in its fleet, per second")
      ->check(CLI::Range(0.0, 10.0));
  command->add_option("--send-hz", s.send_hz, "Rounds of packets a second")
      ->check(CLI::Range(0.1, 1000.0))
      ->capture_default_str();
  command->add_option("--packet", s.packet_bytes, "Bytes of a packet at most")
      ->check(CLI::Range(27, 65507))
      ->capture_default_str();
  command
      ->add_option("--clearance", s.clearance, "How long plans wait for answers at least, s (default: from the links)")
      ->check(CLI::Range(0.0, 10.0));
  command->add_option("--json", options->json, "Write the result, one object a line, with all ways")->type_name("FILE");
  command->add_flag("--processes", options->processes,
                    "In real time: each vehicle in a process of its own, packets over UDP on the loopback interface");
  command->add_option("--late", s.late, "By how much ticks may be late at most, s")->check(CLI::Range(0.0, 1.0));
  command->add_option("--html", options->html, "A page of up to 12 runs, to turn and play")->type_name("FILE");
  command->add_option("--record", options->record, "Record the swarm for `tern replay`")->type_name("FILE");
  command->callback([options, &exit_status] { exit_status = fly(*options); });
}

}  // namespace tern_cli
