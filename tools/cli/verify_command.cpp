// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>
#include <cstdio>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/output_paths.hpp"
#include "host/atomic_file.hpp"
#include "host/flight/world_family.hpp"
#include "host/presence.hpp"
#include "verify/fence_records.hpp"
#include "verify/flight.hpp"
#include "verify/proofs.hpp"

namespace tern_cli {
namespace {

using Json = nlohmann::ordered_json;
using tern_verify::Claims;
using tern_verify::Verdict;

struct VerifyOptions {
  std::vector<std::string> files;
  std::vector<std::string> settings;
  std::string json;
  bool brief = false;
};

Json claims_json(const Claims& claims) {
  Json all = Json::array();
  for (const tern_verify::Claim& claim : claims) {
    all.push_back({{"claim", claim.what},
                   {"verdict", tern_verify::verdict_word(claim.verdict())},
                   {"unit", claim.unit},
                   {"margin_at_least", tern_verify::text_below(claim.least)},
                   {"margin_at_most", tern_verify::text_above(claim.most)},
                   {"tolerance", tern_verify::text_below(claim.tolerance)},
                   {"place", claim.place}});
  }
  return all;
}

/// What is proven of one file, what is not but would be taken for it, and what is most likely a mistake.
struct Proof {
  Claims claims;
  std::vector<std::string> assumed;
  std::string note{};
};

void print(const std::string& plan, const Proof& proof, bool brief) {
  const Claims& claims = proof.claims;
  std::size_t proven = 0;
  for (const tern_verify::Claim& claim : claims) {
    const bool holds = claim.verdict() == Verdict::kProven;
    proven += holds ? 1 : 0;
    if (!brief || !holds) std::printf("%s\n", tern_verify::line_of(claim).c_str());
  }
  for (const std::string& assumed : proof.assumed) std::printf("ASSUMED  %s\n", assumed.c_str());
  if (!proof.note.empty()) std::printf("NOTE     %s\n", proof.note.c_str());
  std::printf("%s: %s: %zu of %zu claims are proven\n", plan.c_str(),
              tern_verify::verdict_word(tern_verify::verdict_of(claims)), proven, claims.size());
}

bool is_json(const std::string& text) {
  return text.find_first_not_of(" \t\r\n") == text.find('{');
}

/// A world's file, or the world that a family's member names: that is made here, as for `tern fly`.
std::string read_world(const std::string& name) {
  tern_host::FamilyMember member;
  return tern_host::is_member(name, member) ? tern_host::world_text(member) : tern_verify::read_file(name);
}

/// A flight's log, and the world after it, if there is one.
Proof prove_flight(const std::string& text, const VerifyOptions& options, std::size_t& next) {
  tern_verify::Flight flight = tern_verify::parse_flight(text, options.files[next - 1]);
  if (next < options.files.size()) {
    const std::string& name = options.files[next];
    const std::string world = read_world(name);
    if (!is_json(world)) {
      tern_verify::compare(tern_verify::parse_world(world, name, options.settings), name, flight);
      ++next;
    }
  }
  return {tern_verify::prove(flight), tern_verify::assumed_of(flight)};
}

/// What is there at other times than the plan, in the words of `tern plan`.
std::string absent_from(const tern_verify::Problem& problem, const tern_verify::Plan& plan) {
  std::vector<tern_host::Presence> presences;
  for (const tern_verify::Thing& thing : problem.things) {
    const bool leaves = thing.end == tern_verify::ThingEnd::kGone;
    presences.push_back({thing.name, tern_verify::guess(thing.from),
                         leaves ? tern_verify::guess(thing.until) : std::numeric_limits<double>::infinity()});
  }
  for (std::size_t f = 0; f < problem.fences.size(); ++f) {
    const tern_verify::Fence& fence = problem.fences[f];
    if (!fence.window) continue;
    const double wider = tern_verify::guess(fence.window->clock_error) * (fence.keep_in ? -1.0 : 1.0);
    presences.push_back({tern_verify::title_of(problem.fences, f), tern_verify::guess(fence.window->from) - wider,
                         tern_verify::guess(fence.window->until) + wider});
  }
  tern_verify::Rational end = problem.start_time + problem.rest_clear;
  for (const tern_verify::Segment& segment : plan.segments) end += segment.duration;
  return tern_host::absence_text(presences, tern_verify::guess(problem.start_time), tern_verify::guess(end));
}

/// What one file claims, proven: a flight's log, or a plan with the scenario after it.
Proof prove_file(const VerifyOptions& options, std::size_t& next) {
  const std::vector<std::string>& files = options.files;
  const std::string& name = files[next++];
  const std::string text = tern_verify::read_file(name);
  if (!is_json(text)) {
    throw std::runtime_error(
        name + ": not a plan file, nor the log of a flight: both are JSON. A scenario comes after its plan");
  }
  if (tern_verify::is_flight(text)) return prove_flight(text, options, next);
  if (!options.settings.empty()) {
    throw std::runtime_error(name + ": --set is for flights. Write into the scenario what the plan was made with");
  }
  if (next == files.size()) throw std::runtime_error("verify needs a SCENARIO after the plan " + name);
  const tern_verify::Plan plan = tern_verify::parse_plan(text, name);
  const tern_verify::Problem problem = tern_verify::read_problem(files[next++]);
  tern_verify::require_same_request(problem, plan);
  return {tern_verify::prove(problem, plan), tern_verify::assumed_of(problem, plan), absent_from(problem, plan)};
}

Json file_json(const std::string& name, const Proof& proof) {
  const Verdict verdict = tern_verify::verdict_of(proof.claims);
  Json file{{"file", name}, {"verdict", tern_verify::verdict_word(verdict)}};
  if (!proof.assumed.empty()) file["assumed"] = proof.assumed;
  if (!proof.note.empty()) file["note"] = proof.note;
  file["claims"] = claims_json(proof.claims);
  return file;
}

int verify(const VerifyOptions& options) {
  check_output_paths(options.files, {options.json});
  Json verdicts = Json::array();
  int exit_status = kExitOk;
  for (std::size_t next = 0; next < options.files.size();) {
    const std::string& name = options.files[next];
    const Proof proof = prove_file(options, next);
    print(name, proof, options.brief);
    if (tern_verify::verdict_of(proof.claims) != Verdict::kProven) exit_status = kExitRefuted;
    verdicts.push_back(file_json(name, proof));
  }
  if (!options.json.empty()) {
    tern_host::write_file(options.json, Json({{"format", "tern-verify/1"}, {"files", verdicts}}).dump(1) + "\n");
  }
  return exit_status;
}

}  // namespace

void add_verify_command(CLI::App& app, int& exit_status) {
  const auto options = std::make_shared<VerifyOptions>();
  CLI::App* const command =
      app.add_subcommand("verify", "Prove plans and flights again, in exact arithmetic, without the core");
  command
      ->add_option("FILES", options->files,
                   "PLAN SCENARIO: a plan file of `tern plan --json` and the scenario that it was made for; or FLIGHT "
                   "[WORLD]: a log of `tern fly --json FILE --commits` and the world that it was flown in, a file or "
                   "FAMILY:SEED. Any number of them")
      ->required()
      ->type_name("");
  command->add_option("--set", options->settings, "A setting that the flights were flown with, in place of the worlds'")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command->add_flag("--brief", options->brief, "Print only what is not proven or is assumed, notes, and a line a plan");
  command->add_option("--json", options->json, "Write all claims with their margins")->type_name("FILE");
  command->footer(
      "Proves of a plan, for all t: joints, both ends, vias, boundary, corridor, obstacles, fences and limits; of a\n"
      "flight's committed plans: joints, takeovers, rest at the end, limits, fences, and the distance from the true\n"
      "world; and that the simulated vehicle followed them within its margin (docs/verify.md).\n"
      "Exit status 0 where all is proven, 1 where a claim is refuted or not proven, 2 for a bad file.");
  command->callback([options, &exit_status] { exit_status = verify(*options); });
}

}  // namespace tern_cli
