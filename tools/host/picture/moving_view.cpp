// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/picture/moving_view.hpp"

#include <algorithm>
#include <cmath>

#include "host/nanoseconds.hpp"
#include "host/picture/lettering.hpp"
#include "host/picture/outline.hpp"
#include "host/track_sample.hpp"

namespace tern_host {
namespace {

constexpr double kAlone = 10.0;    ///< s that are drawn without a plan
constexpr int kSteps = 60;         ///< of a sweep
constexpr double kMostMarks = 30;  ///< of one thing
constexpr double kThingWidth = 190.0, kThingGap = 5.0;

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

/// What the thing takes of the picture when it is first there; empty if it is not there until `end`.
std::vector<Pixel> first_outline(const tern::Track& track, double begin, double end, const WorldToPixel& pixel) {
  const double when = std::max(begin, seconds_of(track.measured));
  TrackSample sample = sample_of(track, when);
  if (!sample.is_there || when > end) return {};
  sample.error = 0.0;
  return convex_hull(outline_at(track, sample, pixel));
}

/// Above, below, right or left of the outline, or in its middle: where the name is inside the frame and clear of text.
void draw_thing_name(Canvas& canvas, const Rect& frame, const std::vector<Pixel>& outline, const TrackRecord& record) {
  const auto x = std::minmax_element(outline.begin(), outline.end(), [](Pixel a, Pixel b) { return a.x < b.x; });
  const auto y = std::minmax_element(outline.begin(), outline.end(), [](Pixel a, Pixel b) { return a.y < b.y; });
  const Pixel middle{0.5 * (x.first->x + x.second->x), 0.5 * (y.first->y + y.second->y)};
  const std::string name = fit_text(record.id, kThingName, kThingWidth);
  const double base = middle.y + 0.35 * kThingName.size;
  const std::string style =
      std::string("class=\"thing-name\" fill=\"") + (record.is_fence ? "#93372a" : "#4d3015") + "\"";
  const std::pair<Pixel, const char*> places[] = {
      {{middle.x, y.first->y - kThingGap}, " text-anchor=\"middle\""},
      {{middle.x, y.second->y + kThingGap + 0.8 * kThingName.size}, " text-anchor=\"middle\""},
      {{x.second->x + kThingGap, base}, ""},
      {{x.first->x - kThingGap, base}, " text-anchor=\"end\""},
      {{middle.x, base}, " text-anchor=\"middle\""}};
  for (const auto& [at, anchor] : places) {
    const Rect room = text_room(at, name, style + anchor);
    const bool fits = frame.holds({room.x, room.y}) && frame.holds({room.right(), room.bottom()});
    if (fits && canvas.clear_of_text(room)) return canvas.text(at, name, style + anchor);
  }
}

/// From the scenario's beginning to the plan's end, s of the clock.
std::pair<double, double> times_of(const PlanResult& result) {
  const double begin = result.scenario.start_time;
  return {begin, begin + (result.ok() ? tern::duration(result.trajectory) : kAlone)};
}

}  // namespace

void draw_thing_names(Canvas& canvas, const PlanResult& result, const WorldToPixel& pixel, const Rect& frame) {
  const std::vector<TrackRecord>& records = result.scenario.tracks;
  const std::vector<tern::Track> tracks = tracks_of(records);
  const auto [begin, end] = times_of(result);
  for (std::size_t k = 0; k < tracks.size(); ++k) {
    const std::vector<Pixel> outline = first_outline(tracks[k], begin, end, pixel);
    if (!outline.empty()) draw_thing_name(canvas, frame, outline, records[k]);
  }
}

void draw_things(Canvas& canvas, const PlanResult& result, const WorldToPixel& pixel) {
  const std::vector<TrackRecord>& records = result.scenario.tracks;
  const std::vector<tern::Track> all = tracks_of(records);
  const auto [begin, end] = times_of(result);
  std::vector<tern::Track> tracks;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (!records[k].is_fence) tracks.push_back(all[k]);
    if (!records[k].is_fence) continue;
    const std::vector<Pixel> outline = first_outline(all[k], begin, end, pixel);
    if (!outline.empty()) canvas.polygon(outline, kKeepoutForAWhileStyle);
  }
  for (const tern::Track& track : tracks) draw_sweep(canvas, track, begin, end, pixel);
  for (const tern::Track& track : tracks) draw_way(canvas, track, begin, end, pixel);
  for (const tern::Track& track : tracks) draw_marks(canvas, track, begin, end, pixel);
}

std::vector<LegendEntry> thing_entries(const Scenario& scenario) {
  const auto is_fence = [](const TrackRecord& record) { return record.is_fence; };
  const std::vector<TrackRecord>& records = scenario.tracks;
  std::vector<LegendEntry> entries;
  if (std::any_of(records.begin(), records.end(), is_fence) || has_keepout(scenario.fences, true)) {
    entries.push_back(keepout_for_a_while_entry());
  }
  if (std::all_of(records.begin(), records.end(), is_fence)) return entries;
  entries.push_back(area_entry("what moves, at the start", "class=\"thing\"", 5.0));
  entries.push_back(area_entry("once a second", "class=\"thing-later\"", 5.0));
  entries.push_back(area_entry("its tube", "class=\"sweep\" opacity=\"0.3\"", 5.0));
  return entries;
}

}  // namespace tern_host
