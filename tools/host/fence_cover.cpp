// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/fence_cover.hpp"

#include "host/fence_record.hpp"
#include "host/number.hpp"

namespace tern_host {
namespace {

/// Sums of doubles that mean the same differ by less.
constexpr double kTouch = 1e-9;

bool holds(const tern::Box& outer, const tern::Box& inner) {
  const tern::Vec3 &a = outer.lower, &b = inner.lower, &c = inner.upper, &d = outer.upper;
  return a.x <= b.x + kTouch && a.y <= b.y + kTouch && a.z <= b.z + kTouch && c.x <= d.x + kTouch &&
         c.y <= d.y + kTouch && c.z <= d.z + kTouch;
}

std::string corners(const tern::Box& box) {
  std::string text;
  for (const double v : {box.lower.x, box.lower.y, box.lower.z, box.upper.x, box.upper.y, box.upper.z}) {
    text += (text.empty() ? "" : " ") + brief(v);
  }
  return text;
}

}  // namespace

FenceCover read_fence_cover(const Words& words, const Place& place) {
  const std::vector<double> v = numbers(words, place);
  if (v.size() != 7) throw_count(words.front(), "7 numbers, a box and a clearance", v.size(), place);
  if (!(v[6] >= 0.0)) throw RecordError(place, "the clearance of '" + words.front() + "' must not be less than 0");
  return {box_of({v.begin(), v.begin() + 6}, words.front(), place), v[6], place};
}

void check_fence_cover(const FenceCover& cover, const tern::Box& boundary, double clearance, const std::string& sum) {
  if (!(clearance <= cover.clearance + kTouch)) {
    throw RecordError(cover.place, "the fences were made for a clearance of " + brief(cover.clearance) + " m, but " +
                                       sum + " is " + brief(clearance) +
                                       " m: zones may be missing. Make the fences again, with tern airspace " +
                                       "--clearance " + brief(clearance));
  }
  if (holds(cover.box, boundary)) return;
  throw RecordError(cover.place, "the fences were made for the boundary " + corners(cover.box) +
                                     ", but the boundary is " + corners(boundary) +
                                     ": zones may be missing. Make the fences again, with tern airspace --boundary " +
                                     corners(boundary));
}

}  // namespace tern_host
