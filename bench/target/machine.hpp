// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_BENCH_TARGET_MACHINE_HPP
#define TERN_BENCH_TARGET_MACHINE_HPP

#include <string>
#include <vector>

namespace tern_target {

/// What a figure depends on, as the system tells it; "unknown" where it does not.
struct Machine {
  std::string board;     ///< the device tree's model, or the vendor's and product's name
  std::string cpu;       ///< model, or implementer and part
  int processors;        ///< online
  std::string kernel;    ///< system, release, architecture
  std::string governor;  ///< of clock scaling, with the frequencies in use and at most
  std::string timer;     ///< resolution of the clock that times are taken with
  std::string build;     ///< compiler, capacity profile, configuration hash
  bool emulated;         ///< qemu-user or the like: no time means anything
  bool virtualised;      ///< under a hypervisor: other guests' work is in the maxima
};

/// `processor`: whose clock is described; below 0: the first one's.
Machine describe_machine(int processor);

/// One line a property, "board: ...", warnings last; no line ends.
std::vector<std::string> lines_of(const Machine& machine);

}  // namespace tern_target

#endif
