// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The obstacle layer in a record: its rows one after the other, in runs of words. A run begins with a word that has its
// kind and its length.
#ifndef TERN_RECORD_OBSTACLES_HPP
#define TERN_RECORD_OBSTACLES_HPP

#include <cstddef>

#include "record/words.hpp"
#include "tern/grid.hpp"

namespace tern {

/// The most words that the runs of a layer of `layer` words take.
std::size_t most_obstacle_words(std::size_t layer) noexcept;

void write_obstacles(const Grid& grid, WordWriter& words) noexcept;
/// Marks the obstacles in a grid that was bound to the record's spec. kOk, or kRecordDamaged if the runs do not fill
/// the layer exactly, or mark a bit past a row's end.
Status read_obstacles(WordReader& words, Grid& grid) noexcept;

}  // namespace tern

#endif
