// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "host/airspace/airspace.hpp"
#include "host/number.hpp"
#include "tern/config.hpp"

namespace tern_host {
namespace {

std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t width) {
  const std::size_t is = width_of(text);
  return text + std::string(is < width ? width - is : 0, ' ');
}

std::string times_text(const AirspaceEntry& entry) {
  if (entry.zone.times.empty()) return "always";
  if (entry.spans.empty()) return "not then";
  const std::string more = entry.spans.size() > 1 ? " +" + std::to_string(entry.spans.size() - 1) : "";
  return span_text(entry.spans[0]) + more;
}

std::string area_text(double square_metres) {
  if (square_metres < 1e6) return fixed(square_metres, 0) + " m2";
  return fixed(square_metres * 1e-6, 2) + " km2";
}

using Row = std::vector<std::string>;

Row row_of(const AirspaceEntry& entry) {
  const Zone& zone = entry.zone;
  Row row{printable(zone.name, 32), zone.kind == ZoneKind::kKeepIn ? "keep-in" : "keep-out", printable(zone.type, 32),
          times_text(entry), height_text(zone.lower, "ground") + " to " + height_text(zone.upper, "no end")};
  if (!entry.left_out.empty()) {
    row.push_back(entry.left_out);
    return row;
  }
  std::size_t planes = 0;
  for (const FittedFence& fence : entry.fit.fences) planes += fence.planes.size();
  row.push_back(area_text(entry.fit.area));
  row.push_back(std::to_string(entry.fit.fences.size()));
  row.push_back(std::to_string(planes));
  row.push_back(fixed(entry.fit.off, 3));
  row.push_back(fixed(entry.fit.height_off, 3));
  return row;
}

std::string lines_of(const std::vector<Row>& rows, const std::vector<std::vector<std::string>>& notes) {
  std::vector<std::size_t> widths;
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i == widths.size()) widths.push_back(0);
      // The last column of a zone without fences is a sentence.
      if (i + 1 < row.size() || row.size() == rows[0].size()) widths[i] = std::max(widths[i], width_of(row[i]));
    }
  }
  std::string text;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    text += " ";
    for (std::size_t i = 0; i < rows[r].size(); ++i) {
      text += " " + (i + 1 < rows[r].size() ? padded(rows[r][i], widths[i] + 1) : rows[r][i]);
    }
    text += "\n";
    for (const std::string& note : notes[r]) text += "      " + note + "\n";
  }
  return text;
}

std::string frame_text(const Airspace& airspace) {
  const tern::Box& b = airspace.settings.fit.boundary;
  double farthest = 0.0;
  for (const double x : {b.lower.x, b.upper.x}) {
    for (const double y : {b.lower.y, b.upper.y}) farthest = std::max(farthest, std::hypot(x, y));
  }
  std::string text = "frame: x east, y north, z up about " + fixed(airspace.origin.point.latitude, 7) + ", " +
                     fixed(airspace.origin.point.longitude, 7) + " (WGS84)";
  text += airspace.knows_height ? ", " + fixed(airspace.origin.height, 2) + " m above the ellipsoid\n"
                                : ", at an unknown height\n";
  text += "  within " + fixed(farthest, 0) + " m, lengths along the ellipsoid are off by at most " +
          fixed(1000.0 * length_error(farthest), 2) + " mm";
  if (!airspace.knows_height) return text + "\n";
  const double top =
      std::max(std::fabs(airspace.origin.height + b.lower.z), std::fabs(airspace.origin.height + b.upper.z));
  return text + "; at a height of " + fixed(top, 0) + " m, they are " + fixed(1e6 * height_scale(top), 0) +
         " ppm longer\n";
}

std::string capacity_text(const Airspace& airspace) {
  const int fences = airspace.fence_count(), planes = airspace.plane_count();
  const auto count = [](int n, const char* what) { return std::to_string(n) + " " + what + (n == 1 ? "" : "s"); };
  std::string text = count(fences, "fence") + " with " + count(planes, "half-space");
  if (fences > tern::kMaxFences || planes > tern::kMaxFencePlanes) {
    text += ": more than a request takes (TERN_MAX_FENCES " + std::to_string(tern::kMaxFences) +
            ", TERN_MAX_FENCE_PLANES " + std::to_string(tern::kMaxFencePlanes) +
            "). tern plan chooses those that matter";
  }
  return text + "\n";
}

/// What becomes of a hold: at a via, the plan has it.
std::string hold_text(const std::vector<LocalPoint>& points, std::size_t i) {
  if (!(points[i].dwell > 0.0)) return "";
  const char* const end = i == 0                   ? " before the plan begins"
                          : i + 1 == points.size() ? " after it ends: rest_clear"
                                                   : "";
  return ", " + brief(points[i].dwell) + " s" + end;
}

}  // namespace

std::string height_text(const std::optional<ZoneHeight>& height, const char* otherwise) {
  if (!height) return otherwise;
  const char* const names[] = {"WGS84", "AMSL", "AGL", "above home"};
  return brief(height->metres) + " " + names[static_cast<int>(height->reference)];
}

std::string airspace_table(const Airspace& airspace) {
  std::vector<Row> rows{
      {"zone", "kind", "type", "holds", "heights, m", "area", "fences", "half-spaces", "off, m", "off in height, m"}};
  std::vector<std::vector<std::string>> notes(1);
  for (const AirspaceEntry& entry : airspace.entries) {
    rows.push_back(row_of(entry));
    notes.push_back(entry.left_out.empty() ? entry.fit.notes : std::vector<std::string>());
  }
  std::string text = frame_text(airspace) + lines_of(rows, notes);
  for (const std::string& left_out : airspace.left_out) text += "  left out: " + printable(left_out, 200) + "\n";
  for (std::size_t i = 0; i < airspace.points.size(); ++i) {
    const tern::Vec3& p = airspace.points[i].position;
    text += "  mission point " + std::to_string(i + 1) + ": " + fixed(p.x, 2) + " " + fixed(p.y, 2) + " " +
            fixed(p.z, 2) + hold_text(airspace.points, i) + "\n";
  }
  for (const LocalPoint& p : airspace.rally) {
    text +=
        "  rally point: " + fixed(p.position.x, 2) + " " + fixed(p.position.y, 2) + " " + fixed(p.position.z, 2) + "\n";
  }
  return text + capacity_text(airspace);
}

}  // namespace tern_host
