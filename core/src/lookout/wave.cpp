// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lookout/wave.hpp"

namespace tern {
namespace {

/// Numbers of steps are kept modulo this.
constexpr std::int32_t kTurn = 8;
/// Operations of a row in a step: nine words of the front, and the layers.
constexpr Operations kRowOperations = 22 * ops::kWord;

/// More than any squared distance of two octets.
constexpr std::int32_t kTooFar = 3 * kOctetsX * kOctetsX;

std::int32_t squared(const Voxel& a, const Voxel& b) {
  const Voxel off{a.x - b.x, a.y - b.y, a.z - b.z};
  return off.x * off.x + off.y * off.y + off.z * off.z;
}

std::uint64_t sideways(std::uint64_t word) {
  return word | word << 1 | word >> 1;
}

/// One more to both sides, within `count`.
IndexRange grown(const IndexRange& range, std::int32_t count) {
  return overlap({range.begin - 1, range.end + 1}, {0, count});
}

void cover(IndexRange& range, std::int32_t index) {
  if (index < range.begin) range.begin = index;
  if (index >= range.end) range.end = index + 1;
}

}  // namespace

void Wave::begin(const Octets& octets, std::uint64_t* words, std::size_t layer, Work& work) noexcept {
  std::uint64_t** const layers[kWaveLayers] = {&reached, &front, &next, &late, &steps[0], &steps[1], &steps[2]};
  for (int k = 0; k < kWaveLayers; ++k) {
    *layers[k] = words + static_cast<std::size_t>(k) * layer;
    for (std::int32_t r = 0; r < octets.rows(); ++r) (*layers[k])[r] = 0;
  }
  step = 0;
  is_over = false;
  rows = {octets.count.y, 0};
  planes = {octets.count.z, 0};
  work.spend(kWaveLayers * ops::kWord * octets.rows());
}

void Wave::seed(const Octets& octets, const Voxel& octet) noexcept {
  const std::int32_t row = octets.row(octet);
  const std::uint64_t bit = std::uint64_t{1} << octet.x;
  reached[row] |= bit;
  front[row] |= bit;
  began = octet;
  cover(rows, octet.y);
  cover(planes, octet.z);
}

/// A wide step leads from all that is reached: an octet that a narrow step reached, or that was reached before one, has
/// neighbours over edges and corners yet.
std::uint64_t Wave::spread(const Octets& octets, std::int32_t y, std::int32_t z, bool wide) const noexcept {
  const std::uint64_t* const from = wide ? reached : front;
  const auto word = [&](std::int32_t row, std::int32_t plane) {
    const bool inside = row >= 0 && plane >= 0 && row < octets.count.y && plane < octets.count.z;
    return inside ? from[plane * octets.count.y + row] : std::uint64_t{0};
  };
  const std::uint64_t faces = word(y - 1, z) | word(y + 1, z) | word(y, z - 1) | word(y, z + 1);
  const std::uint64_t own = word(y, z);
  if (!wide) return faces | sideways(own);
  return sideways(own | faces | word(y - 1, z - 1) | word(y + 1, z - 1) | word(y - 1, z + 1) | word(y + 1, z + 1));
}

void Wave::advance(const Octets& octets, bool everywhere, Work& work) noexcept {
  ++step;
  rows = grown(rows, octets.count.y);
  planes = grown(planes, octets.count.z);
  std::uint64_t any = 0;
  for (std::int32_t z = planes.begin; z < planes.end; ++z) {
    for (std::int32_t y = rows.begin; y < rows.end; ++y) {
      const std::int32_t row = z * octets.count.y + y;
      const std::uint64_t touched = spread(octets, y, z, step % 2 == 0) & ~reached[row];
      const std::uint64_t due = late[row];
      next[row] = (touched & octets.known[row]) | due;
      late[row] = everywhere ? touched & octets.open[row] & ~due : 0;
      any |= next[row] | late[row];
    }
  }
  std::uint64_t* const before = front;
  front = next;
  next = before;
  note_front(octets);
  // A wave may rest for one step: only a wide step leads over edges and corners.
  is_over = (any == 0 && step % 2 == 0) || step >= kMaxWave - kOpenSteps;
  work.spend(kRowOperations * (planes.end - planes.begin) * (rows.end - rows.begin));
}

void Wave::note_front(const Octets& octets) noexcept {
  for (std::int32_t z = planes.begin; z < planes.end; ++z) {
    for (std::int32_t y = rows.begin; y < rows.end; ++y) {
      const std::int32_t row = z * octets.count.y + y;
      const std::uint64_t fresh = front[row];
      if (fresh == 0) continue;
      reached[row] |= fresh;
      for (int b = 0; b < 3; ++b) {
        if ((step >> b & 1) != 0) steps[b][row] |= fresh;
      }
    }
  }
}

std::int32_t Wave::steps_to(const Octets& octets, const Voxel& octet) const noexcept {
  std::int32_t sum = 0;
  for (int b = 0; b < 3; ++b) sum += octets.bit(steps[b], octet) ? 1 << b : 0;
  return sum;
}

/// Each octet was reached from a neighbour with one step less, or two if it is open; over an edge or a corner perhaps
/// with one more less, because every second step does not lead there. Of these, goes back to a known one and, of
/// several, to the one that is nearest to where the wave began, so that ways are as straight as may be.
std::int32_t Wave::way_to(const Octets& octets, const Voxel& octet, std::int32_t* way, Work& work) const noexcept {
  std::int32_t count = 0;
  Voxel at = octet;
  for (bool goes_on = true; goes_on && count < kMaxWave;) {
    way[count++] = octets.index(at);
    const std::int32_t price = octets.bit(octets.known, at) ? 1 : kOpenSteps;
    const std::int32_t steps_here = steps_to(octets, at);
    Voxel best = at;
    std::int32_t nearest = 2 * kTooFar;
    for (std::int32_t k = 0; k < 27; ++k) {
      const Voxel beside{at.x + k % 3 - 1, at.y + k / 3 % 3 - 1, at.z + k / 9 - 1};
      if (k == 13 || !octets.has(beside) || !has(octets, beside)) continue;
      const std::int32_t less = (steps_here + kTurn - steps_to(octets, beside)) % kTurn;
      const std::int32_t far = squared(beside, began) + (octets.bit(octets.known, beside) ? 0 : kTooFar);
      if ((less != price && less != price + 1) || far >= nearest) continue;
      nearest = far;
      best = beside;
    }
    goes_on = nearest < 2 * kTooFar;
    at = best;
  }
  for (std::int32_t a = 0, b = count - 1; a < b; ++a, --b) {
    const std::int32_t kept = way[a];
    way[a] = way[b];
    way[b] = kept;
  }
  work.spend(2 * 27 * ops::kTurn * count);
  return count;
}

}  // namespace tern
