// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "record/obstacles.hpp"

namespace tern {
namespace {

/// Kinds of runs. After the head of kFree, whose words are all 0, nothing follows. After that of kSame, whose words are
/// all equal, the word follows once. After that of kMixed, all words follow.
enum class Run : std::uint64_t { kFree = 0, kSame = 1, kMixed = 2 };
constexpr unsigned kLengthShift = 2;

/// The words of the obstacle layer in their order.
struct Layer {
  const Grid& grid;
  std::size_t size() const {
    const Voxel& dims = grid.spec().dims;
    return static_cast<std::size_t>(grid.row_words()) * static_cast<std::size_t>(dims.y) *
           static_cast<std::size_t>(dims.z);
  }
  std::uint64_t operator[](std::size_t k) const { return grid.obstacle_row(0, 0)[k]; }
  /// How many words from `begin` on are equal.
  std::size_t run(std::size_t begin) const {
    std::size_t end = begin + 1;
    while (end < size() && (*this)[end] == (*this)[begin]) ++end;
    return end - begin;
  }
};

void begin_run(Run run, std::size_t length, WordWriter& words) {
  words.word((static_cast<std::uint64_t>(length) << kLengthShift) | static_cast<std::uint64_t>(run));
}

/// The index of the next three or more equal words, or the end. Fewer equal words do not pay for a run of their own.
std::size_t mixed_end(const Layer& layer, std::size_t begin) {
  constexpr std::size_t kLeastRun = 3;
  std::size_t end = begin;
  while (end < layer.size()) {
    const std::size_t run = layer.run(end);
    if (run >= kLeastRun) break;
    end += run;
  }
  return end;
}

/// Marks the bits of a word. False for a bit past the row's end.
bool mark_word(Grid& grid, std::size_t index, std::uint64_t bits) {
  const auto row_words = static_cast<std::size_t>(grid.row_words());
  const auto rows = static_cast<std::size_t>(grid.spec().dims.y);
  const std::size_t row = index / row_words;
  const Voxel first{static_cast<std::int32_t>(64 * (index % row_words)), static_cast<std::int32_t>(row % rows),
                    static_cast<std::int32_t>(row / rows)};
  for (; bits != 0; bits &= bits - 1) {
    const Voxel voxel{first.x + __builtin_ctzll(bits), first.y, first.z};
    if (grid.mark_voxel(voxel) != Status::kOk) return false;
  }
  return true;
}

/// Reads one run. False if it is no run, or does not fit into the rest of the layer.
bool read_run(WordReader& words, std::size_t& at, std::size_t size, Grid& grid) {
  const std::uint64_t head = words.word();
  const std::uint64_t length = head >> kLengthShift;
  const auto run = static_cast<Run>(head & 3u);
  if (length == 0 || length > size - at || words.past_end() || (head & 3u) > 2u) return false;
  if (run == Run::kMixed && length > words.left()) return false;
  const std::uint64_t same = run == Run::kSame ? words.word() : 0;
  const std::size_t end = at + static_cast<std::size_t>(length);
  for (; at < end; ++at) {
    if (!mark_word(grid, at, run == Run::kMixed ? words.word() : same)) return false;
  }
  return true;
}

}  // namespace

std::size_t most_obstacle_words(std::size_t layer) noexcept {
  // A run of at least three equal words takes two words at most. The word that it saves pays for the head of a mixed
  // run before it.
  return layer + 1;
}

void write_obstacles(const Grid& grid, WordWriter& words) noexcept {
  const Layer layer{grid};
  for (std::size_t at = 0; at < layer.size();) {
    const std::size_t end = mixed_end(layer, at);
    if (end > at) {
      begin_run(Run::kMixed, end - at, words);
      for (; at < end; ++at) words.word(layer[at]);
    } else {
      const std::size_t length = layer.run(at);
      begin_run(layer[at] == 0 ? Run::kFree : Run::kSame, length, words);
      if (layer[at] != 0) words.word(layer[at]);
      at += length;
    }
  }
}

Status read_obstacles(WordReader& words, Grid& grid) noexcept {
  const std::size_t size = Layer{grid}.size();
  for (std::size_t at = 0; at < size;) {
    if (!read_run(words, at, size, grid)) return Status::kRecordDamaged;
  }
  return words.past_end() || words.left() > 0 ? Status::kRecordDamaged : Status::kOk;
}

}  // namespace tern
