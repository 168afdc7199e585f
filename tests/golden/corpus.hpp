// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The golden corpus: the paper's six maps and seeded random scenarios, with no file, no heap and no libm behind them,
// so that the same source runs on a host, under an emulator and on bare metal.
#ifndef TERN_TESTS_GOLDEN_CORPUS_HPP
#define TERN_TESTS_GOLDEN_CORPUS_HPP

#include <cstddef>
#include <cstdint>

#include "tern/tern.hpp"

namespace tern_golden {

constexpr int kMaxStrips = 32;
constexpr int kMapCount = 6;
constexpr int kRandomCount = 240;
constexpr int kUnevenCount = 40;  ///< random ones with different limits up and down, and on the horizontal norm
constexpr int kScenarioCount = kMapCount + kRandomCount + kUnevenCount;

/// A scenario as its file would say it. World frame, SI units.
struct Scenario {
  tern::Box boundary;
  double resolution;
  double radius;
  int block_count;
  tern::Box blocks[kMaxStrips];
  tern::Request request;
};

/// Words of grid storage that every scenario of the corpus fits in.
constexpr std::size_t kGridWords = 2 * 200 * 256;

/// Scenario `index` of [0, kScenarioCount): the maps first. Returns false for another index.
bool scenario(int index, Scenario& out);

/// Binds `grid` over `words`, marks the blocks and inflates.
tern::Status build_grid(const Scenario& scenario, std::uint64_t* words, std::size_t word_count, tern::Grid& grid);

/// FNV-1a over 64-bit words, from the bits of everything that a plan promises.
constexpr std::uint64_t kHashSeed = 0xCBF29CE484222325u;
std::uint64_t hash_plan(std::uint64_t hash, tern::Status status, const tern::Trajectory& trajectory);

}  // namespace tern_golden

#endif
