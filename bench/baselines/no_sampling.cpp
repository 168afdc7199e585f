// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Stands in where the Open Motion Planning Library is not installed.
#include "baselines/sampling.hpp"

namespace tern_bench {

bool has_sampling() {
  return false;
}

std::vector<Snapshot> run_sampler(Sampler, const tern::Grid&, const tern_host::Scenario&, std::uint32_t,
                                  const std::vector<double>&) {
  return {};
}

}  // namespace tern_bench
