// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "attack/obstacle_file.hpp"
#include "attack/runner.hpp"

namespace {

struct OneCase {
  std::uint64_t number = 0;
  bool verbose = false;
  std::string only;
  std::string write;
};

struct Arguments {
  tern_attack::Options options;
  std::string family;
  double share = 1.0;
  std::uint64_t needed_of = 0;
  OneCase alone;
};

/// One case in this process, so that a debugger sees it.
int run_one(const tern_attack::Options& options, const OneCase& one) {
  const auto bench = std::make_unique<tern_attack::Bench>();
  std::vector<tern_attack::SolidRun> only;
  std::vector<tern_attack::SolidRun> obstacles;
  if (!one.only.empty()) {
    only = tern_attack::read_runs(one.only);
    bench->only = &only;
  }
  bench->write = &obstacles;
  bench->things = options.things;
  const std::uint64_t number = one.number;
  tern_attack::Tallies tallies{};
  tern_attack::Findings findings;
  tern_attack::run_case(*bench, options.seed, number, one.verbose, tallies.data(), findings);
  for (const tern_attack::Finding& f : findings) {
    std::printf("%s\n", violation_line(options, {number, f.kind, f.detail}).c_str());
  }
  if (!one.write.empty()) tern_attack::write_runs(one.write, obstacles);
  if (findings.empty()) std::printf("case %llu: no violation\n", static_cast<unsigned long long>(number));
  return findings.empty() ? 0 : 1;
}

/// True without a violation, and with at most one replan in `needed_of` that needed the previous plan.
bool passes(const tern_attack::Progress& progress, std::uint64_t needed_of) {
  std::uint64_t replans = 0;
  std::uint64_t needed = 0;
  for (const tern_attack::Tally& tally : progress.tallies) {
    replans += tally.replans;
    needed += tally.needed;
  }
  return progress.violations.empty() && needed * needed_of <= replans;
}

void add_options(CLI::App& app, Arguments& a) {
  tern_attack::Options& options = a.options;
  app.add_option("--seed", options.seed, "Seed of all cases")->capture_default_str();
  app.add_option("--first", options.first, "Cases to leave out before the first one")->capture_default_str();
  app.add_option("--cases", options.cases, "How many cases to run")->capture_default_str();
  app.add_option("--share", a.share, "Part of the cases to run, 0 < share <= 1");
  app.add_option("--family", a.family, "Only cases of this family");
  app.add_flag("--things", options.things,
               "Every request is asked four times among things that move, and nothing else is done");
  app.add_option("--jobs", options.jobs, "Processes at a time; 0: one a core")->capture_default_str();
  app.add_option("--folder", options.folder, "Where state and tables go; without it a run cannot be resumed");
  app.add_option("--seconds-a-case", options.seconds_a_case, "A case that takes longer is a violation")
      ->capture_default_str();
  app.add_option("--needed-of", a.needed_of,
                 "Fail where more than one replan in so many needs the previous plan; 0: no matter")
      ->capture_default_str();
  app.add_flag("--quiet", options.quiet, "No progress line");
  app.add_option("--case", a.alone.number, "Run this case alone");
  app.add_flag("--verbose", a.alone.verbose, "With --case: print the world, every request and every answer");
  app.add_option("--write-obstacles", a.alone.write,
                 "With --case: write the obstacles of its first world, a run a line")
      ->type_name("FILE");
  app.add_option("--only-obstacles", a.alone.only, "With --case: leave out obstacles that are not in this file")
      ->type_name("FILE");
}

int run_many(Arguments& a) {
  tern_attack::Options& options = a.options;
  if (!a.family.empty()) options.family = tern_attack::family_by_name(a.family.c_str());
  if (!a.family.empty() && options.family < 0) throw std::runtime_error(a.family + " is no family");
  options.cases = std::max<std::uint64_t>(1, static_cast<std::uint64_t>(static_cast<double>(options.cases) * a.share));
  std::error_code why;
  if (!options.folder.empty() && !std::filesystem::is_directory(options.folder) &&
      !std::filesystem::create_directories(options.folder, why)) {
    throw std::runtime_error(options.folder + " cannot be made a folder for the state: " + why.message());
  }
  // State is kept by whole blocks.
  constexpr std::uint64_t kBlock = tern_attack::kBlock;
  if (!options.folder.empty()) options.cases = (options.cases + kBlock - 1) / kBlock * kBlock;
  tern_attack::Progress progress;
  load_state(options, progress);
  for (const tern_attack::Violation& v : progress.violations) std::printf("%s\n", violation_line(options, v).c_str());
  run_all(options, progress);
  print_table(options, progress);
  write_tables(options, progress);
  return passes(progress, a.needed_of) ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Attacks the planner with random worlds and requests and checks every answer.", "tern_attack");
  app.footer("Exit status: 0 without a violation, 1 with one, 2 for wrong usage. docs/attack.md has the rules.");
  Arguments arguments;
  add_options(app, arguments);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  try {
    return app.count("--case") > 0 ? run_one(arguments.options, arguments.alone) : run_many(arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tern_attack: %s\n", error.what());
    return 2;
  }
}
