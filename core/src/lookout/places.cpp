// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lookout/places.hpp"

namespace tern {
namespace {

/// Of the coarsest lattice there is room for all places.
constexpr std::int32_t kLastLevel = 12;
/// Within so many steps, places are thinned so many levels later: a vehicle in a shaft, around which much is in reach,
/// needs places beside it.
constexpr std::int32_t kNearSteps = 5;
constexpr std::int32_t kNearLevels = 4;

/// The bits of a row whose index is a multiple of `stride`.
std::uint64_t every(std::int32_t stride) {
  std::uint64_t mask = 0;
  for (std::int32_t x = 0; x < kOctetsX; x += stride) mask |= std::uint64_t{1} << x;
  return mask;
}

}  // namespace

Lattice Places::lattice(std::int32_t steps) const noexcept {
  const std::int32_t later = steps > kNearSteps ? 0 : kNearLevels;
  const std::int32_t at = level > later ? level - later : 0;
  return {std::int32_t{1} << (at + 1) / 2, std::int32_t{1} << at / 2};
}

void Places::begin(std::int32_t octet) noexcept {
  place[0] = {octet, 0};
  count = 1;
  level = 0;
}

/// The place where the vehicle is stays.
void Places::thin(const Octets& octets) noexcept {
  ++level;
  std::int32_t kept = 1;
  for (std::int32_t k = 1; k < count; ++k) {
    if (lattice(place[k].steps).has(octets.octet(place[k].octet))) place[kept++] = place[k];
  }
  count = kept;
}

void Places::take_front(const Octets& octets, const Wave& wave, bool everywhere, Work& work) noexcept {
  std::int32_t taken = 0;
  Lattice from = lattice(wave.step);
  std::uint64_t mask = every(from.stride);
  for (std::int32_t z = wave.planes.begin; z < wave.planes.end; ++z) {
    for (std::int32_t y = wave.rows.begin; y < wave.rows.end; ++y) {
      if (!from.has({0, y, z})) continue;
      const std::int32_t row = octets.row({0, y, z});
      std::uint64_t bits = wave.front[row] & (everywhere ? kAllBits : octets.known[row]) & mask;
      for (; bits != 0 && from.has({0, y, z}); bits &= bits - 1) {  // 64 turns at most
        if (count == kMaxPlaces && level < kLastLevel) {
          thin(octets);
          from = lattice(wave.step);
          mask = every(from.stride);
          ++taken;
        }
        const Voxel octet{__builtin_ctzll(bits), y, z};
        if (count == kMaxPlaces || !from.has(octet)) continue;
        place[count++] = {octets.index(octet), wave.step};
        ++taken;
      }
    }
  }
  work.spend(5 * ops::kWord * (wave.planes.end - wave.planes.begin) * (wave.rows.end - wave.rows.begin) +
             4 * ops::kTurn * taken + kOctetsX);
}

}  // namespace tern
