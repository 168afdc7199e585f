// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lookout/places.hpp"

namespace tern {
namespace {

/// Of the coarsest lattice there is room for all places.
constexpr std::int32_t kLastLevel = 12;

/// The bits of a row whose index is a multiple of `stride`.
std::uint64_t every(std::int32_t stride) {
  std::uint64_t mask = 0;
  for (std::int32_t x = 0; x < kOctetsX; x += stride) mask |= std::uint64_t{1} << x;
  return mask;
}

}  // namespace

bool Places::is_on_lattice(const Voxel& octet) const noexcept {
  return octet.x % stride() == 0 && octet.y % stride() == 0 && octet.z % stride_up() == 0;
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
    if (is_on_lattice(octets.octet(place[k].octet))) place[kept++] = place[k];
  }
  count = kept;
}

void Places::take_front(const Octets& octets, const Wave& wave, bool everywhere, Work& work) noexcept {
  std::int32_t taken = 0;
  std::uint64_t mask = every(stride());
  for (std::int32_t z = wave.planes.begin; z < wave.planes.end; ++z) {
    for (std::int32_t y = wave.rows.begin; y < wave.rows.end; ++y) {
      if (!is_on_lattice({0, y, z})) continue;
      const std::int32_t row = octets.row({0, y, z});
      std::uint64_t bits = wave.front[row] & (everywhere ? kAllBits : octets.known[row]) & mask;
      for (; bits != 0 && is_on_lattice({0, y, z}); bits &= bits - 1) {  // 64 turns at most
        if (count == kMaxPlaces && level < kLastLevel) {
          thin(octets);
          mask = every(stride());
          ++taken;
        }
        const Voxel octet{__builtin_ctzll(bits), y, z};
        if (count == kMaxPlaces || !is_on_lattice(octet)) continue;
        place[count++] = {octets.index(octet), wave.step};
        ++taken;
      }
    }
  }
  work.spend(5 * ops::kWord * (wave.planes.end - wave.planes.begin) * (wave.rows.end - wave.rows.begin) +
             4 * ops::kTurn * taken + kOctetsX);
}

}  // namespace tern
