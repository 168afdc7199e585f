// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Whole first plans on families of random worlds. Every world is new to the planner, and its memory has been touched.
// Times are processor time of the thread, the least of some repetitions.
#include "search/families.hpp"

#include <time.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "host/atomic_file.hpp"
#include "quantile.hpp"
#include "tern/tern.hpp"

namespace {

using tern_bench::quantile;
using tern_bench::Query;
using tern_bench::World;

/// Processor time of this thread, nanoseconds.
std::uint64_t now(void*) {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<std::uint64_t>(t.tv_sec) * 1000000000u + static_cast<std::uint64_t>(t.tv_nsec);
}

constexpr double kMicroseconds = 1e-3;

/// Row 0 is inflation, the others are the planner's stages; and the whole plan.
struct Sample {
  double stage[tern::kStageCount] = {};
  double total = 0.0;
  tern::Status status = tern::Status::kOk;
};

/// Least times of both.
void lower(Sample& least, const Sample& sample) {
  for (int s = 0; s < tern::kStageCount; ++s) least.stage[s] = std::min(least.stage[s], sample.stage[s]);
  least.total = std::min(least.total, sample.total);
}

class Planning {
 public:
  Planning() : memory_(tern::kWorkspaceBytes + tern::kWorkspaceAlignment), planner_(memory_.data(), memory_.size()) {
    planner_.set_clock(now, nullptr);
  }

  /// The world's first plan, several times.
  Sample first_plan(const World& world, const Query& query, int repetitions) {
    Sample least = once(world.grid, query);
    for (int k = 1; k < repetitions; ++k) lower(least, once(world.grid, query));
    return least;
  }

 private:
  /// Marks what the world has in a grid of its own.
  void copy_obstacles(const tern::Grid& from) {
    const tern::Voxel& dims = from.spec().dims;
    words_.resize(tern::grid_words(dims));
    grid_.bind(from.spec(), words_.data(), words_.size());
    for (std::int32_t z = 0; z < dims.z; ++z) {
      for (std::int32_t y = 0; y < dims.y; ++y) {
        const std::uint64_t* row = from.obstacle_row(y, z);
        for (std::int32_t x = 0; x < dims.x; ++x) {
          if ((row[x >> 6] >> (x & 63) & 1u) != 0) grid_.mark_voxel({x, y, z});
        }
      }
    }
  }

  Sample once(const tern::Grid& world, const Query& query) {
    copy_obstacles(world);
    Sample sample;
    const std::uint64_t begin = now(nullptr);
    grid_.inflate();
    const std::uint64_t inflated = now(nullptr);
    tern::Request request{};
    request.start.position = grid_.center(query.start);
    request.goal.position = grid_.center(query.goal);
    request.limits.v_max = request.limits.a_max = {2.0, 2.0, 2.0};
    tern::Report report;
    sample.status = planner_.plan(grid_, request, trajectory_, report);
    for (int s = 0; s < tern::kStageCount; ++s) {
      sample.stage[s] = static_cast<double>(report.diagnostics.stages[s].ticks) * kMicroseconds;
    }
    sample.stage[0] = static_cast<double>(inflated - begin) * kMicroseconds;
    for (const double time : sample.stage) sample.total += time;
    return sample;
  }

  std::vector<unsigned char> memory_;
  tern::Planner planner_;
  std::vector<std::uint64_t> words_;
  tern::Grid grid_;
  tern::Trajectory trajectory_;
};

std::vector<double> times_of(const std::vector<Sample>& samples, int stage) {
  std::vector<double> times;
  for (const Sample& sample : samples) times.push_back(stage < 0 ? sample.total : sample.stage[stage]);
  return times;
}

/// Why there is no plan, and how often: "no_path 3 segments_full 2", or "-".
std::string refusals_of(const std::vector<Sample>& samples) {
  std::map<std::string, int> counts;
  for (const Sample& sample : samples) {
    if (sample.status != tern::Status::kOk) ++counts[tern::status_name(sample.status)];
  }
  std::string text;
  for (const auto& [name, count] : counts) text += (text.empty() ? "" : " ") + name + " " + std::to_string(count);
  return text.empty() ? "-" : text;
}

/// "queries,plans,median,p99,max" of the whole plan, the longest answer without a plan, the stages' medians, and
/// the refusals.
std::string row_of(const std::string& family, const std::vector<Sample>& all) {
  std::vector<Sample> plans;
  double refused = 0.0;
  for (const Sample& sample : all) {
    if (sample.status == tern::Status::kOk) plans.push_back(sample);
    if (sample.status != tern::Status::kOk) refused = std::max(refused, sample.total);
  }
  const std::vector<double> totals = times_of(plans, -1);
  char text[256];
  std::snprintf(text, sizeof text, "%s,%zu,%zu,%.0f,%.0f,%.0f,%.0f", family.c_str(), all.size(), plans.size(),
                quantile(totals, 0.5), quantile(totals, 0.99), quantile(totals, 1.0), refused);
  std::string row = text;
  for (const tern::Stage stage : {tern::Stage::kRequest, tern::Stage::kSearch, tern::Stage::kShortcut,
                                  tern::Stage::kCorridor, tern::Stage::kTrajectory, tern::Stage::kCheck}) {
    std::snprintf(text, sizeof text, ",%.0f", quantile(times_of(plans, static_cast<int>(stage)), 0.5));
    row += text;
  }
  return row + "," + refusals_of(all) + "\n";
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Whole first plans on families of random worlds."};
  std::uint64_t first = 201;
  int worlds = 12;
  int repetitions = 5;
  std::string csv_file;
  app.add_option("--first", first, "The first seed");
  app.add_option("--worlds", worlds, "Worlds of each family and radius")->check(CLI::PositiveNumber);
  app.add_option("--repetitions", repetitions, "Plans of each world")->check(CLI::PositiveNumber);
  app.add_option("--csv", csv_file, "Write the table as CSV as well")->type_name("OUT");
  CLI11_PARSE(app, argc, argv);
  try {
    std::string csv =
        "family,queries,plans,median,p99,max,longest_refusal,inflate,search,shortcut,corridor,trajectory,check,"
        "refusals\n";
    std::fputs(csv.c_str(), stdout);
    const auto planning = std::make_unique<Planning>();
    for (int family = 0; family < tern_bench::kFamilies; ++family) {
      const auto of = static_cast<tern_bench::Family>(family);
      std::vector<Sample> samples;
      for (int k = 0; k < 6 * worlds; ++k) {
        World world;
        const Query query = tern_bench::build(of, k % 6, first + static_cast<std::uint64_t>(k / 6), world);
        samples.push_back(planning->first_plan(world, query, repetitions));
      }
      const std::string row = row_of(tern_bench::family_name(of), samples);
      std::fputs(row.c_str(), stdout);
      std::fflush(stdout);
      csv += row;
    }
    if (!csv_file.empty()) tern_host::write_file(csv_file, csv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
