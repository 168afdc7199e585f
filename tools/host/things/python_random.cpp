// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/things/python_random.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace tern_host {
namespace {

constexpr std::size_t kWords = 624;

/// Matsumoto's init_by_array for a key of one word.
std::array<std::uint32_t, kWords> state_of(std::uint32_t key) {
  std::array<std::uint32_t, kWords> state;
  state[0] = 19650218u;
  const auto mixed = [&state](std::size_t k) { return state[k - 1] ^ (state[k - 1] >> 30); };
  for (std::size_t k = 1; k < kWords; ++k) state[k] = 1812433253u * mixed(k) + static_cast<std::uint32_t>(k);
  std::size_t k = 1;
  const auto step = [&] {
    if (++k < kWords) return;
    state[0] = state[kWords - 1];
    k = 1;
  };
  for (std::size_t turn = 0; turn < kWords; ++turn, step()) state[k] = (state[k] ^ (mixed(k) * 1664525u)) + key;
  for (std::size_t turn = 1; turn < kWords; ++turn, step()) {
    state[k] = (state[k] ^ (mixed(k) * 1566083941u)) - static_cast<std::uint32_t>(k);
  }
  state[0] = 0x80000000u;
  return state;
}

}  // namespace

PythonRandom::PythonRandom(std::uint32_t seed) {
  const std::array<std::uint32_t, kWords> state = state_of(seed);
  auto first = state.begin();
  engine_.seed(first, state.end());
}

double PythonRandom::unit() {
  const std::uint32_t high = engine_() >> 5;
  const std::uint32_t low = engine_() >> 6;
  return (high * 67108864.0 + low) * (1.0 / 9007199254740992.0);
}

}  // namespace tern_host
