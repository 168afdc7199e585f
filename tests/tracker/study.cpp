// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// tracker_study [SEEDS]: the table of port/tracker/README.md, over so many seeds, 20 by default.
#include <cstdio>
#include <cstdlib>
#include <tuple>

#include "tracker/crowd.hpp"

int main(int argc, char** argv) {
  const int seeds = argc > 1 ? std::atoi(argv[1]) : 20;
  const auto percent = [](double part, double whole) { return whole > 0.0 ? 100.0 * part / whole : 0.0; };
  for (const auto& [people, missed, clutter] :
       {std::tuple{1, 0.1, 0.2}, {5, 0.0, 0.0}, {5, 0.1, 0.2}, {20, 0.1, 0.2}, {50, 0.1, 0.2}, {20, 0.3, 0.5}}) {
    tern_test::CrowdFigures sum;
    for (int seed = 1; seed <= seeds; ++seed) {
      tern_test::CrowdSettings settings;
      settings.people = people;
      settings.missed = missed;
      settings.clutter = clutter;
      settings.seed = static_cast<std::uint64_t>(seed);
      tern_tracker::Tracker tracker;
      sum.add(tern_test::Crowd(settings).watch(tracker));
    }
    std::printf("| %d | %.0f %% | %.1f | %.1f %% of %d | %.2f %%, %.2f %% | %.2f | %.2f %% | %.3f %% |\n", people,
                100.0 * missed, clutter, percent(sum.born_late, sum.born), sum.born,
                percent(static_cast<double>(sum.unknown), static_cast<double>(sum.instants)),
                percent(static_cast<double>(sum.unseen), static_cast<double>(sum.instants)),
                sum.switches / sum.minutes(), percent(sum.ghosts, sum.reports),
                percent(static_cast<double>(sum.outside), static_cast<double>(sum.held)));
  }
  return 0;
}
