// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/picture/merged_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "host/number.hpp"

namespace tern_host {
namespace {

constexpr double kCells = 40000.0;
constexpr double kLeastCell = 2.0;  // pixels
constexpr int kStrengths = 6;

struct Change {
  int cell;
  double by;
};

/// The coverage of unit cells by [from, to], as changes from each cell to the next.
struct Coverage {
  Change changes[4];

  Coverage(double from, double to, int cells) {
    step(std::clamp(from, 0.0, static_cast<double>(cells)), 1.0, changes);
    step(std::clamp(to, 0.0, static_cast<double>(cells)), -1.0, changes + 2);
  }
  static void step(double at, double sign, Change* out) {
    const double cell = std::floor(at);
    out[0] = {static_cast<int>(cell), sign * (1.0 - (at - cell))};
    out[1] = {static_cast<int>(cell) + 1, sign * (at - cell)};
  }
};

using Run = std::pair<int, int>;  // first column, last column and one

std::vector<Run> runs_of_row(const int* row, int columns, int strength) {
  std::vector<Run> found;
  for (int c = 0; c < columns; ++c) {
    if (row[c] != strength) continue;
    const int first = c;
    while (c < columns && row[c] == strength) ++c;
    found.push_back({first, c});
  }
  return found;
}

std::string run_path(const Run& run, int top, int bottom) {
  const std::string width = std::to_string(run.second - run.first);
  return "M" + std::to_string(run.first) + " " + std::to_string(top) + "h" + width + "v" +
         std::to_string(bottom - top) + "h-" + width + "z";
}

}  // namespace

MergedBlocks::MergedBlocks(const Rect& frame)
    : frame_(frame),
      cell_(std::max(kLeastCell, std::sqrt(frame.width * frame.height / kCells))),
      columns_(static_cast<int>(std::ceil(frame.width / cell_))),
      rows_(static_cast<int>(std::ceil(frame.height / cell_))),
      changes_(static_cast<std::size_t>(columns_ + 2) * static_cast<std::size_t>(rows_ + 2), 0.0) {}

void MergedBlocks::add(const Rect& rect, double weight) {
  const Coverage across((rect.x - frame_.x) / cell_, (rect.right() - frame_.x) / cell_, columns_);
  const Coverage down((rect.y - frame_.y) / cell_, (rect.bottom() - frame_.y) / cell_, rows_);
  for (const Change& y : down.changes) {
    for (const Change& x : across.changes) {
      changes_[static_cast<std::size_t>(y.cell * (columns_ + 2) + x.cell)] += weight * y.by * x.by;
    }
  }
}

std::vector<int> MergedBlocks::strengths(double threshold) const {
  std::vector<int> found(static_cast<std::size_t>(columns_ * rows_), 0);
  std::vector<double> column_changes(static_cast<std::size_t>(columns_), 0.0);
  for (int r = 0; r < rows_; ++r) {
    double along = 0.0;
    for (int c = 0; c < columns_; ++c) {
      const std::size_t column = static_cast<std::size_t>(c);
      column_changes[column] += changes_[static_cast<std::size_t>(r * (columns_ + 2) + c)];
      along += column_changes[column];
      const double part = std::min(1.0, along);  // the sum of all changes up to here, both ways
      if (part < threshold) continue;
      found[static_cast<std::size_t>(r * columns_ + c)] = static_cast<int>(std::ceil(part * kStrengths - 1e-6));
    }
  }
  return found;
}

/// Runs of one strength, those of one width below each other as one.
std::string MergedBlocks::runs(const std::vector<int>& strengths, int strength) const {
  std::string path;
  std::map<Run, int> open;  // to the row where it began
  for (int r = 0; r <= rows_; ++r) {
    std::map<Run, int> next;
    if (r < rows_) {
      for (const Run& run : runs_of_row(&strengths[static_cast<std::size_t>(r * columns_)], columns_, strength)) {
        const auto above = open.find(run);
        next[run] = above == open.end() ? r : above->second;
      }
    }
    for (const auto& [run, top] : open) {
      if (next.find(run) == next.end()) path += run_path(run, top, r);
    }
    open.swap(next);
  }
  return path;
}

void MergedBlocks::draw(Canvas& canvas, const std::string& style, double threshold, double base, double span) const {
  const std::vector<int> all = strengths(threshold);
  const std::string place =
      "transform=\"translate(" + fixed(frame_.x, 2) + " " + fixed(frame_.y, 2) + ") scale(" + fixed(cell_, 4) + ")\"";
  for (int strength = 1; strength <= kStrengths; ++strength) {
    const std::string path = runs(all, strength);
    if (path.empty()) continue;
    const std::string opacity = fixed(base + span * strength / kStrengths, 2);
    canvas.raw("<path " + place + " " + style + " opacity=\"" + opacity + "\" d=\"" + path + "\"/>\n");
  }
}

}  // namespace tern_host
