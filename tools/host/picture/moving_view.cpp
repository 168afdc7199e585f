// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/picture/moving_view.hpp"

#include <algorithm>
#include <cmath>

#include "host/picture/outline.hpp"
#include "host/track_sample.hpp"

namespace tern_host {
namespace {

constexpr double kAlone = 10.0;    ///< s that are drawn without a plan
constexpr int kSteps = 60;         ///< of a sweep
constexpr double kMostMarks = 30;  ///< of one thing

/// What a thing takes of the picture at a time.
std::vector<Pixel> outline_at(const tern::Track& track, const TrackSample& sample, const WorldToPixel& pixel) {
  std::vector<Pixel> points;
  for (const tern::Vec3& p : surface_of(track, sample)) points.push_back(pixel(p));
  return points;
}

/// One polygon from each time to the next; a group makes them one area.
void draw_sweep(Canvas& canvas, const tern::Track& track, double begin, double end, const WorldToPixel& pixel) {
  canvas.raw("<g opacity=\"0.22\">");
  std::vector<Pixel> before;
  for (int k = 0; k <= kSteps; ++k) {
    const TrackSample sample = sample_of(track, begin + (end - begin) * k / kSteps);
    std::vector<Pixel> now;
    if (sample.is_there) now = outline_at(track, sample, pixel);
    std::vector<Pixel> both = now;
    both.insert(both.end(), before.begin(), before.end());
    if (!now.empty()) canvas.polygon(convex_hull(both), "class=\"sweep\"");
    before = std::move(now);
  }
  canvas.raw("</g>");
}

void draw_way(Canvas& canvas, const tern::Track& track, double begin, double end, const WorldToPixel& pixel) {
  std::vector<Pixel> way;
  for (int k = 0; k <= kSteps; ++k) {
    const TrackSample sample = sample_of(track, begin + (end - begin) * k / kSteps);
    if (sample.is_there) way.push_back(pixel(sample.place));
  }
  if (way.size() > 1) canvas.polyline(way, "class=\"thing-way\"");
}

/// Once a second, fainter the later it is.
void draw_marks(Canvas& canvas, const tern::Track& track, double begin, double end, const WorldToPixel& pixel) {
  const double marks = std::min(kMostMarks, std::floor(end - begin));
  bool is_first = true;
  for (double k = 0.0; k <= marks; k += 1.0) {
    TrackSample sample = sample_of(track, begin + k);
    if (!sample.is_there) continue;
    sample.error = 0.0;
    const std::vector<Pixel> outline = convex_hull(outline_at(track, sample, pixel));
    if (!outline.empty()) canvas.polygon(outline, is_first ? "class=\"thing\"" : "class=\"thing-later\"");
    is_first = false;
  }
}

}  // namespace

void draw_things(Canvas& canvas, const PlanResult& result, const WorldToPixel& pixel) {
  const std::vector<TrackRecord>& records = result.scenario.tracks;
  const std::vector<tern::Track> all = tracks_of(records);
  const double begin = result.scenario.start_time;
  const double end = begin + (result.ok() ? tern::duration(result.trajectory) : kAlone);
  std::vector<tern::Track> tracks;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (!records[k].is_fence) tracks.push_back(all[k]);
    if (!records[k].is_fence) continue;
    const double when = std::max(begin, 1e-9 * static_cast<double>(all[k].measured));
    const TrackSample sample = sample_of(all[k], when);
    if (sample.is_there && when <= end) {
      canvas.polygon(convex_hull(outline_at(all[k], sample, pixel)), "class=\"keepout-for-a-while\"");
    }
  }
  for (const tern::Track& track : tracks) draw_sweep(canvas, track, begin, end, pixel);
  for (const tern::Track& track : tracks) draw_way(canvas, track, begin, end, pixel);
  for (const tern::Track& track : tracks) draw_marks(canvas, track, begin, end, pixel);
}

std::vector<LegendEntry> thing_entries(const Scenario& scenario) {
  const auto is_fence = [](const TrackRecord& record) { return record.is_fence; };
  const std::vector<TrackRecord>& records = scenario.tracks;
  std::vector<LegendEntry> entries;
  if (std::any_of(records.begin(), records.end(), is_fence)) {
    entries.push_back(area_entry("keep-out for a while", "class=\"keepout-for-a-while\""));
  }
  if (std::all_of(records.begin(), records.end(), is_fence)) return entries;
  entries.push_back(area_entry("what moves, at the start", "class=\"thing\"", 5.0));
  entries.push_back(area_entry("once a second", "class=\"thing-later\"", 5.0));
  entries.push_back(area_entry("its tube", "class=\"sweep\" opacity=\"0.3\"", 5.0));
  return entries;
}

}  // namespace tern_host
