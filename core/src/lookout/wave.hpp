// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A wave over octets, 64 at a time. A step leads over a face, every second one also over edges and corners: the way
// that a step counts is then off by a fifth at most. An open octet takes two steps, because what was not seen yet costs
// time, and may hold anything. Of the number of steps to each octet the wave keeps three bits. Those of neighbours
// differ by three at most, so that a way can be found back.
#ifndef TERN_LOOKOUT_WAVE_HPP
#define TERN_LOOKOUT_WAVE_HPP

#include <cstdint>

#include "base/work.hpp"
#include "lookout/octets.hpp"

namespace tern {

/// Layers of a wave, besides the two of the octets.
constexpr int kWaveLayers = 7;
/// Steps of a wave, and octets of a way, at most.
constexpr std::int32_t kMaxWave = 256;
/// How many steps an open octet takes; a known one takes 1.
constexpr std::int32_t kOpenSteps = 2;

struct Wave {
  std::uint64_t* reached;
  std::uint64_t* front;     ///< reached with the last step
  std::uint64_t* next;      ///< scratch
  std::uint64_t* late;      ///< open octets that the next step reaches
  std::uint64_t* steps[3];  ///< bits 0 to 2 of the number of steps
  std::int32_t step;        ///< steps so far
  bool is_over;             ///< nothing is left to reach
  Voxel began;              ///< the last seed
  IndexRange rows;          ///< where the front is: y, and z
  IndexRange planes;

  /// Nothing is reached yet. `words`: kWaveLayers layers of `layer` words.
  void begin(const Octets& octets, std::uint64_t* words, std::size_t layer, Work& work) noexcept;
  /// The wave begins here, too.
  void seed(const Octets& octets, const Voxel& octet) noexcept;
  /// One step. `everywhere`: through open octets as well.
  void advance(const Octets& octets, bool everywhere, Work& work) noexcept;
  bool has(const Octets& octets, const Voxel& octet) const noexcept { return octets.bit(reached, octet); }
  /// The way from where the wave began to an octet that it has reached, as indices of octets in `way`, which has room
  /// for kMaxWave. Returns how many.
  std::int32_t way_to(const Octets& octets, const Voxel& octet, std::int32_t* way, Work& work) const noexcept;

 private:
  void note_front(const Octets& octets) noexcept;
  std::uint64_t spread(const Octets& octets, std::int32_t y, std::int32_t z, bool wide) const noexcept;
  std::int32_t steps_to(const Octets& octets, const Voxel& octet) const noexcept;
};

}  // namespace tern

#endif
