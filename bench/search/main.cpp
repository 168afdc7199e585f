// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// tern_bench_search: Tern's search against the plain A*, in one run, on the paper's six maps, its Monte Carlo
// configurations, a folder of scenarios and the public voxel benchmark.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "host/atomic_file.hpp"
#include "host/scenario.hpp"
#include "search/contest.hpp"
#include "search/families.hpp"
#include "search/report.hpp"

namespace {

using tern_bench::Contest;
using tern_bench::Outcome;
using tern_bench::Query;
using tern_bench::World;

struct Options {
  bool quick = false;
  std::string only;    ///< sets whose name contains this
  std::string csv;     ///< file to write; none where empty
  std::string shared;  ///< folder with "cases/forest" and "voxel"
};

class Run {
 public:
  explicit Run(const Options& options) : options_(options) { std::puts(tern_bench::table_header().c_str()); }

  template <typename Fill>
  void set(const std::string& name, int repetitions, Fill fill) {
    if (name.find(options_.only) == std::string::npos) return;
    Contest contest(name, repetitions);
    fill(contest);
    const Outcome& outcome = contest.outcome();
    std::puts(tern_bench::table_row(outcome).c_str());
    std::fflush(stdout);
    csv_ += tern_bench::csv_row(outcome) + "\n";
    wrong_ += outcome.wrong;
  }

  const Options& options() const { return options_; }
  const std::string& csv() const { return csv_; }
  int wrong() const { return wrong_; }

 private:
  const Options& options_;
  std::string csv_ = tern_bench::csv_header() + "\n";
  int wrong_ = 0;
};

std::string metres(double cell) {
  char text[16];
  std::snprintf(text, sizeof text, "%.2f m", cell);
  return text;
}

void add_scenario(Contest& contest, tern_host::Scenario scenario) {
  World world;
  const Query query = tern_bench::build(scenario, world);
  contest.add(world, {query});
}

void run_maps(Run& run) {
  for (const double cell : {0.1, 0.05}) {
    for (int map = 1; map <= 6; ++map) {
      const std::string name = "map" + std::to_string(map);
      run.set(name + " " + metres(cell), run.options().quick ? 5 : 15, [&](Contest& contest) {
        tern_host::Scenario scenario = tern_host::read_scenario(std::string(TERN_MAPS_DIR) + "/" + name + ".txt");
        scenario.resolution = cell;
        scenario.radius = 0.1;
        add_scenario(contest, scenario);
      });
    }
  }
}

void run_monte_carlo(Run& run) {
  static constexpr tern_bench::ForestKind kKinds[] = {
      {"small low", {10.0, 10.0, 3.0}, 0.1},  {"small high", {10.0, 10.0, 3.0}, 0.3},
      {"medium low", {20.0, 20.0, 4.0}, 0.1}, {"medium high", {20.0, 20.0, 4.0}, 0.3},
      {"large low", {40.0, 40.0, 5.0}, 0.1},  {"large high", {40.0, 40.0, 5.0}, 0.3}};
  const std::uint64_t maps = run.options().quick ? 10 : 50;
  for (const double cell : {0.2, 0.1}) {
    for (const tern_bench::ForestKind& kind : kKinds) {
      run.set(std::string("random ") + kind.name + " " + metres(cell), 5, [&](Contest& contest) {
        for (std::uint64_t seed = 1; seed <= maps; ++seed) {
          World world;
          const Query query = tern_bench::build(kind, seed, cell, world);
          contest.add(world, {query});
        }
      });
    }
  }
}

/// Settings are chosen on seeds 1 to 12 and judged on others: 101 to 112.
void run_families(Run& run) {
  const std::uint64_t worlds = run.options().quick ? 3 : 12;
  for (int family = 0; family < tern_bench::kFamilies; ++family) {
    for (int radius = 0; radius <= 5; ++radius) {
      const auto of = static_cast<tern_bench::Family>(family);
      run.set(std::string("family ") + family_name(of) + " " + std::to_string(radius), 3, [&](Contest& contest) {
        for (std::uint64_t seed = 101; seed < 101 + worlds; ++seed) {
          World world;
          const Query query = tern_bench::build(of, radius, seed, world);
          contest.add(world, {query});
        }
      });
    }
  }
}

/// Scenario files of a folder whose names begin with a prefix, in order.
std::vector<std::string> files_of(const std::string& folder, const std::string& prefix) {
  std::vector<std::string> files;
  if (!std::filesystem::is_directory(folder)) return files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().filename().string().rfind(prefix, 0) == 0) files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

void run_forests(Run& run) {
  for (const char* density : {"10", "30"}) {
    const std::string folder = run.options().shared + "/cases/forest";
    const std::vector<std::string> files = files_of(folder, std::string("forest_") + density + "_");
    if (files.empty()) {
      std::printf("(no forests in %s)\n", folder.c_str());
      continue;
    }
    run.set(std::string("forest ") + density, 3, [&](Contest& contest) {
      const std::size_t stride = run.options().quick ? 5 : 1;
      for (std::size_t k = 0; k < files.size(); k += stride) add_scenario(contest, tern_host::read_scenario(files[k]));
    });
  }
}

void run_voxel_benchmark(Run& run) {
  for (const char* name : {"Simple", "Complex"}) {
    const std::string file = run.options().shared + "/voxel/" + name + ".3dmap";
    if (!std::filesystem::exists(file)) {
      std::printf("(no %s)\n", file.c_str());
      continue;
    }
    run.set(std::string("voxel ") + name, run.options().quick ? 2 : 3, [&](Contest& contest) {
      World world;
      std::vector<Query> queries = tern_bench::build_voxel_benchmark(file, world);
      if (run.options().quick) {
        for (std::size_t k = 0; 20 * k < queries.size(); ++k) queries[k] = queries[20 * k];
        queries.resize(queries.size() / 20);
      }
      contest.add(world, queries);
    });
  }
}

int run_all(const Options& options) {
  Run run(options);
  run_maps(run);
  run_monte_carlo(run);
  run_forests(run);
  run_families(run);
  run_voxel_benchmark(run);
  if (!options.csv.empty()) tern_host::write_file(options.csv, run.csv());
  if (run.wrong() > 0) std::fprintf(stderr, "%d queries with another cost than A*\n", run.wrong());
  return run.wrong() > 0 ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  options.shared = TERN_SHARED_DIR;
  CLI::App app("Tern's search against a plain A* on the same grids, side by side");
  app.add_flag("--quick", options.quick, "fewer maps, queries and repetitions");
  app.add_option("--only", options.only, "run the sets whose name contains this");
  app.add_option("--csv", options.csv, "write the table to this file as well");
  app.add_option("--shared", options.shared, "folder with cases/forest and voxel");
  CLI11_PARSE(app, argc, argv);
  try {
    return run_all(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
