// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/fine_parts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "host/number.hpp"

namespace tern_host {
namespace {

/// Coarse cells of a part along each axis, if a grid may have as many voxels; two at least, for parts overlap by one.
constexpr std::int32_t kLongestPart = 64;

std::int32_t longest_part() {
  const auto fits = [](std::int32_t part) {
    const std::int32_t edge = tern::kFineVoxels * part;
    return tern::grid_words({edge, edge, edge}) > 0;
  };
  std::int32_t part = kLongestPart;
  while (part > 2 && !fits(part)) part /= 2;
  return part;
}

/// Cells [first, first + count) on an axis.
struct Run {
  std::int32_t first, count;
};

/// Runs that overlap by a cell, so that each pair of neighbours is in one of them.
std::vector<Run> runs_of(std::int32_t cells) {
  const std::int32_t longest = longest_part();
  std::vector<Run> runs;
  for (std::int32_t first = 0; first == 0 || first + 1 < cells; first += longest - 1) {
    runs.push_back({first, std::min(longest, cells - first)});
  }
  return runs;
}

tern::GridSpec part_spec(const tern::GridSpec& coarse, const Run& x, const Run& y, const Run& z) {
  const tern::Vec3& o = coarse.origin;
  const double c = coarse.cell;
  tern::GridSpec spec{};
  spec.origin = {o.x + c * x.first, o.y + c * y.first, o.z + c * z.first};
  spec.cell = c / tern::kFineVoxels;
  spec.dims = {tern::kFineVoxels * x.count, tern::kFineVoxels * y.count, tern::kFineVoxels * z.count};
  spec.boundary = {spec.origin,
                   {spec.origin.x + c * x.count, spec.origin.y + c * y.count, spec.origin.z + c * z.count}};
  return spec;
}

void mark_part(const tern::GridSpec& spec, const std::function<void(tern::Grid&)>& mark,
               std::vector<std::uint64_t>& words, tern::Grid& coarse) {
  words.resize(tern::grid_words(spec.dims));
  tern::Grid fine;
  const bool bound = fine.bind(spec, words.data(), words.size()) == tern::Status::kOk;
  if (bound) mark(fine);
  fine.inflate();
  if (!bound || coarse.mark_grid(fine) != tern::Status::kOk) {
    throw std::runtime_error("cells of " + brief(coarse.spec().cell) + " m are too small to be made of finer voxels");
  }
}

/// True if the boundary holds no whole cell on an axis.
bool is_flat(const tern::Grid& coarse) {
  const tern::Box inside = coarse.local_boundary();
  const double c = coarse.spec().cell;
  const auto whole = [c](double lower, double upper) {
    return std::floor(upper / c + 1e-9) > std::ceil(lower / c - 1e-9);
  };
  return !whole(inside.lower.x, inside.upper.x) || !whole(inside.lower.y, inside.upper.y) ||
         !whole(inside.lower.z, inside.upper.z);
}

}  // namespace

void mark_from_fine(tern::Grid& coarse, const std::function<void(tern::Grid&)>& mark) {
  if (is_flat(coarse)) {
    mark(coarse);
    coarse.inflate();
    return;
  }
  const tern::Voxel dims = coarse.spec().dims;
  std::vector<std::uint64_t> words;
  for (const Run& z : runs_of(dims.z)) {
    for (const Run& y : runs_of(dims.y)) {
      for (const Run& x : runs_of(dims.x)) mark_part(part_spec(coarse.spec(), x, y, z), mark, words, coarse);
    }
  }
  coarse.inflate();
}

}  // namespace tern_host
