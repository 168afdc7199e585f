// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Plans among things that move, beside the plans of the same worlds without them, and the proof alone. Times are
// processor time of the thread. Every plan is sampled: a plan that is too near ends the run. tools/bench time runs it.
#include <time.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <map>
#include <memory>
#include <string>

#include "host/atomic_file.hpp"
#include "quantile.hpp"
#include "time/cases.hpp"

namespace {

using tern_bench::quantile;
using tern_bench::TimeCase;
using tern_bench::TimeFamily;

constexpr TimeFamily kFamilies[] = {{"empty", 0, 0.0, false},
                                    {"forest", 41, 0.0, false},
                                    {"forest from motion", 41, 2.0, false},
                                    {"forest through vias", 41, 0.0, true}};
constexpr int kThings[] = {1, 10, 50, 200};
constexpr int kProofThings = 32;
/// m; more than a plan is granted.
constexpr double kTooNear = 1e-7;

/// Processor time of this thread, ms.
double now() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
}

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

/// What a row counts.
struct Tally {
  int cases = 0;
  int too_near = 0;
  std::vector<double> over_alone, ms, units, alone_ms, proof_us, proof_units;
  std::map<std::string, int> refusals;
};

double units_of(const tern::Report& report) {
  double sum = 0.0;
  for (const tern::StageReport& stage : report.diagnostics.stages) sum += static_cast<double>(stage.work);
  return sum;
}

class Planning {
 public:
  Planning() : memory_(new tern::Workspace), planner_(memory_.get(), sizeof *memory_) {}

  void run(const TimeFamily& family, int things, std::uint64_t seed, Tally& tally) {
    tern_bench::Reals reals(seed);
    tern_bench::build(family, reals, case_);
    double begin = now();
    if (planner_.plan(case_.grid, case_.request, alone_, report_) != tern::Status::kOk) return;
    tally.alone_ms.push_back(now() - begin);
    tern_bench::add_things(things, alone_, reals, case_);
    begin = now();
    const tern::Status status = planner_.plan(case_.grid, case_.request, plan_, report_);
    tally.ms.push_back(now() - begin);
    tally.units.push_back(units_of(report_));
    ++tally.cases;
    prove(alone_, tally);
    if (status != tern::Status::kOk) {
      ++tally.refusals[tern::status_name(status)];
      return;
    }
    tally.over_alone.push_back(tern::duration(plan_) / tern::duration(alone_));
    tally.too_near += tern_bench::too_near_by(case_, plan_) > kTooNear ? 1 : 0;
  }

 private:
  /// The proof alone, against some of the things: of the plan without them, up to its first conflict; and of the plan.
  void prove(const tern::Trajectory& trajectory, Tally& tally) {
    if (case_.request.track_count < kProofThings) return;
    tern::TrackGrounds grounds;
    grounds.tracks = case_.tracks.data();
    grounds.count = kProofThings;
    grounds.radius = case_.grid.spec().radius;
    tern::ProofReport found;
    const double begin = now();
    tern::clear_until(trajectory, 0.0, grounds, &found);
    tally.proof_us.push_back(1e3 * (now() - begin));
    tally.proof_units.push_back(found.work);
  }

  std::unique_ptr<tern::Workspace> memory_;
  tern::Planner planner_;
  TimeCase case_;
  tern::Trajectory alone_, plan_;
  tern::Report report_;
};

std::string row_of(const TimeFamily& family, int things, const Tally& tally) {
  char text[256];
  std::snprintf(text, sizeof text, "%s,%d,%d,%zu,%.3f,%.2f,%.2f,%.2f,%.0f,%.0f,%.1f,%.1f,%.0f", family.name, things,
                tally.cases, tally.over_alone.size(), mean(tally.over_alone), mean(tally.alone_ms), mean(tally.ms),
                quantile(tally.ms, 1.0), mean(tally.units), quantile(tally.units, 1.0), mean(tally.proof_us),
                quantile(tally.proof_us, 1.0), mean(tally.proof_units));
  std::string row = text;
  std::string refusals;
  for (const auto& [name, count] : tally.refusals) {
    refusals += (refusals.empty() ? "" : " ") + name + " " + std::to_string(count);
  }
  return row + "," + (refusals.empty() ? "-" : refusals) + "\n";
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Plans among things that move."};
  std::uint64_t first = 77;
  int cases = 40;
  std::string csv_file;
  app.add_option("--first", first, "The first seed");
  app.add_option("--cases", cases, "Cases of each row")->check(CLI::PositiveNumber);
  app.add_option("--csv", csv_file, "Write the table as CSV as well")->type_name("OUT");
  CLI11_PARSE(app, argc, argv);
  try {
    std::string csv =
        "family,things,cases,found,over_alone,alone_ms,ms_mean,ms_max,units_mean,units_max,proof_us_mean,proof_us_max,"
        "proof_units_mean,refusals\n";
    std::fputs(csv.c_str(), stdout);
    const auto planning = std::make_unique<Planning>();
    int too_near = 0;
    for (const TimeFamily& family : kFamilies) {
      for (const int things : kThings) {
        if (things > tern::kMaxTracks) {
          std::printf("# %d things: more than TERN_MAX_TRACKS, %d\n", things, int{tern::kMaxTracks});
          continue;
        }
        Tally tally;
        for (int k = 0; k < cases; ++k) {
          planning->run(family, things, first + 1000 * static_cast<std::uint64_t>(things) + static_cast<unsigned>(k),
                        tally);
        }
        const std::string row = row_of(family, things, tally);
        std::fputs(row.c_str(), stdout);
        std::fflush(stdout);
        csv += row;
        too_near += tally.too_near;
      }
    }
    if (!csv_file.empty()) tern_host::write_file(csv_file, csv);
    if (too_near > 0) std::fprintf(stderr, "%d plans are too near to a thing\n", too_near);
    return too_near > 0 ? 1 : 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
