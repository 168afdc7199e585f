// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/picture/colours.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace tern_host {

std::string speed_colour(double t) {
  constexpr int kStops = 6;
  constexpr double stops[kStops][3] = {{26, 16, 120},  {98, 9, 163},   {160, 30, 150},
                                       {209, 72, 112}, {238, 124, 76}, {250, 178, 40}};
  const double at = std::min(1.0, std::max(0.0, t)) * (kStops - 1);
  const int stop = std::min(kStops - 2, static_cast<int>(at));
  const double part = at - stop;
  int rgb[3];
  for (int c = 0; c < 3; ++c) {
    rgb[c] = static_cast<int>(std::lround(stops[stop][c] + part * (stops[stop + 1][c] - stops[stop][c])));
  }
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", rgb[0] & 255, rgb[1] & 255, rgb[2] & 255);
  return text;
}

std::string style_sheet() {
  return R"(.title { font-size: 27px; font-weight: 600; fill: #1f2733 }
.subtitle { font-size: 15px; fill: #5c6675 }
.heading { font-size: 16px; font-weight: 600; fill: #1f2733 }
.label { font-size: 14px; fill: #47505e }
.number { font-size: 13px; fill: #5c6675 }
.figure { font-size: 20px; font-weight: 600; fill: #1f2733 }
.figure-name { font-size: 13px; fill: #5c6675 }
.paper { fill: #fcfcfd }
.grid { stroke: #edeff2; stroke-width: 1 }
.frame { fill: none; stroke: #b9c0ca; stroke-width: 1 }
.tick { stroke: #b9c0ca; stroke-width: 1 }
.rule { stroke: #dfe3e8; stroke-width: 1 }
.inflated { fill: #e9ebef }
.block { fill: #8d97a6; stroke: #6c7685; stroke-width: 0.8 }
.merged-block { fill: #8d97a6 }
.merged-keepout { fill: #d99a8f }
.keepin { fill: none; stroke: #2f8f5b; stroke-width: 1.6; stroke-dasharray: 7 4 }
.keepout { fill: #d99a8f; stroke: #b8604f; stroke-width: 0.8 }
.keepout-for-a-while { fill: #d99a8f; fill-opacity: 0.3; stroke: #b8604f; stroke-width: 1.2; stroke-dasharray: 7 4 }
.thing { fill: #6b4423; stroke: #5f3d1b; stroke-width: 1 }
.thing-later { fill: #6b4423; fill-opacity: 0.16; stroke: #6b4423; stroke-width: 0.8 }
.thing-way { fill: none; stroke: #6b4423; stroke-width: 1.2; stroke-dasharray: 5 3 }
.thing-name { font-size: 12px; font-weight: 600; paint-order: stroke; stroke: #ffffff; stroke-width: 3 }
.sweep { fill: #6b4423 }
.corridor { fill: #1f9d8b; fill-opacity: 0.09; stroke: #14806f; stroke-opacity: 0.6; stroke-width: 1 }
.raw { stroke: #b7791f; stroke-width: 1.6; stroke-dasharray: 2 4; stroke-linecap: round }
.shortcut { stroke: #2d3744; stroke-width: 1.3 }
.waypoint { fill: #ffffff; stroke: #2d3744; stroke-width: 1.5 }
.halo { stroke: #ffffff; stroke-opacity: 0.85; stroke-width: 6.5; stroke-linecap: round; stroke-linejoin: round }
.trajectory { stroke-width: 3.6; stroke-linecap: round; stroke-linejoin: round }
.end { stroke: #ffffff; stroke-width: 1.8 }
.end-name { font-size: 14px; font-weight: 600; paint-order: stroke; stroke: #ffffff; stroke-width: 4; fill: #1f2733 }
.card { fill: #f6f8fa; stroke: #d0d7de; stroke-width: 1 }
.ground { fill: #e6eaee; stroke: #c6ccd4; stroke-width: 1 }
.ground-line { stroke: #d6dbe1; stroke-width: 1 }
.block-top { fill: #c3cad4; stroke: #7d8795; stroke-width: 0.6; stroke-linejoin: round }
.block-front { fill: #98a2b1; stroke: #7d8795; stroke-width: 0.6; stroke-linejoin: round }
.block-side { fill: #808b9b; stroke: #7d8795; stroke-width: 0.6; stroke-linejoin: round }
.keepout-top { fill: #ecc5bd; stroke: #b8604f; stroke-width: 0.6; stroke-linejoin: round }
.keepout-front { fill: #dfa598; stroke: #b8604f; stroke-width: 0.6; stroke-linejoin: round }
.keepout-side { fill: #cf8c7d; stroke: #b8604f; stroke-width: 0.6; stroke-linejoin: round }
.flight { stroke-width: 4.6; stroke-linecap: round; stroke-linejoin: round }
.flight-halo { stroke: #ffffff; stroke-width: 8; stroke-linejoin: round }
.behind { stroke-width: 2.6; stroke-dasharray: 4 3; stroke-opacity: 0.75 }
.shadow { stroke: #1f2733; stroke-opacity: 0.22; stroke-width: 3; stroke-linejoin: round }
.via { fill: #ffffff; stroke: #1f2733; stroke-width: 1.4 }
.via-number { font-size: 10px; text-anchor: middle }
.robot { fill: #1f2733; fill-opacity: 0.16; stroke: #1f2733; stroke-width: 1.4 }
.curve { stroke-width: 1.9; stroke-linejoin: round }
.norm { stroke: #1f2733; stroke-width: 1.1; stroke-opacity: 0.55 }
.limit { stroke-width: 1.3; stroke-dasharray: 7 4 }
.joint { stroke: #cdd3db; stroke-width: 1; stroke-dasharray: 1 3 }
.nose { stroke: #1f2733; stroke-width: 1.5; stroke-linecap: round }
.nose-root { fill: #1f2733 }
.zero { stroke: #b9c0ca; stroke-width: 1 }
)";
}

}  // namespace tern_host
