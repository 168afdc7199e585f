// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// tern_paper: runs the experiments that tools/paper asks for.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <string>

#include "paper/experiments.hpp"

namespace {

struct Part {
  const char* name;
  void (*run)(const tern_bench::Run&);
};
constexpr Part kParts[] = {
    {"front_end", tern_bench::front_end_experiment}, {"monte_carlo", tern_bench::monte_carlo_experiment},
    {"corridors", tern_bench::corridors_experiment}, {"back_end", tern_bench::back_end_experiment},
    {"profiles", tern_bench::profiles_experiment},   {"planners", tern_bench::planners_experiment},
    {"theory", tern_bench::theory_experiment}};

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("The experiments of the paper's Section 4");
  tern_bench::Run run;
  std::string part;
  bool list = false;
  app.add_option("part", part, "experiment to run");
  app.add_option("--out", run.folder, "folder for tables and pictures")->check(CLI::ExistingDirectory);
  app.add_flag("--quick", run.quick, "few seeds and short times");
  app.add_flag("--list", list, "print the experiments' names");
  CLI11_PARSE(app, argc, argv);
  for (const Part& known : kParts) {
    if (list) std::puts(known.name);
    if (list || part != known.name) continue;
    try {
      known.run(run);
      return 0;
    } catch (const std::exception& error) {
      std::fprintf(stderr, "tern_paper: %s: %s\n", known.name, error.what());
      return 1;
    }
  }
  if (list) return 0;
  std::fprintf(stderr, "tern_paper: no experiment of the name '%s'; --list prints them\n", part.c_str());
  return 2;
}
