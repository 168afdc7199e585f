// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/airspace/airspace.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "host/airspace/airspace_doubts.hpp"
#include "host/airspace/zone_distance.hpp"

namespace tern_host {
namespace {

/// With so many corners, cutting a zone may take seconds.
constexpr std::size_t kManyCorners = 2000;

/// Farther than any boundary reaches: where a zone is matters to a message about it.
constexpr double kFarAway = 20e3;

constexpr double kMostHours = 24.0 * 366.0;

/// Bytes of the character at a place of a text in UTF-8; 0 where there is none, or one that controls a terminal.
std::size_t utf8_length(const std::string& text, std::size_t at) {
  const auto byte = [&text](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const unsigned first = byte(at);
  if (first < 0x80) return first >= 0x20 && first != 0x7F ? 1 : 0;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  unsigned code = first & (0xFFu >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(at + i) & 0xC0) != 0x80) return 0;
    code = (code << 6) | (byte(at + i) & 0x3F);
  }
  const unsigned least[] = {0, 0, 0xA0, 0x800, 0x10000};
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  return first >= 0xC0 && code >= least[length] && code <= 0x10FFFF && !surrogate ? length : 0;
}

bool is_meant(const std::vector<std::string>& names, const Zone& zone) {
  return std::any_of(names.begin(), names.end(), [&zone](const std::string& said) { return answers_to(zone, said); });
}

/// At most so many names are listed.
constexpr std::size_t kListed = 12;

std::string list_of(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size() && i < kListed; ++i)
    text += (i > 0 ? ", '" : "'") + printable(names[i]) + "'";
  return names.size() > kListed ? text + " and " + std::to_string(names.size() - kListed) + " more" : text;
}

/// The names of all zones for which `is` holds, each once, in their order.
template <typename Is>
std::vector<std::string> names_where(const std::vector<AirspaceFile>& files, Is is) {
  std::vector<std::string> names;
  for (const AirspaceFile& file : files) {
    for (const Zone& zone : file.zones) {
      if (is(zone) && std::find(names.begin(), names.end(), zone.name) == names.end()) names.push_back(zone.name);
    }
  }
  return names;
}

/// Each name must mean one zone, or several that are called the same.
void check_names(const std::vector<std::string>& names, const std::vector<AirspaceFile>& files) {
  for (const std::string& name : names) {
    const auto meant = names_where(files, [&name](const Zone& zone) { return answers_to(zone, name); });
    if (meant.empty()) {
      const std::vector<std::string> all = names_where(files, [](const Zone&) { return true; });
      throw std::invalid_argument("no zone is named '" + printable(name) + "': there " +
                                  (all.empty() ? "is none" : (all.size() == 1 ? "is " : "are ") + list_of(all)));
    }
    if (meant.size() == 1) continue;
    throw std::invalid_argument("several zones are named '" + printable(name) + "', say which: " + list_of(meant));
  }
}

/// The first mission with a home.
const Itinerary* home_mission(const std::vector<AirspaceFile>& files) {
  for (const AirspaceFile& file : files) {
    if (file.mission && file.mission->home) return &*file.mission;
  }
  return nullptr;
}

GeoPosition origin_of(const AirspaceSettings& settings, const Itinerary* mission) {
  const double height = settings.height.value_or(std::nan(""));
  if (settings.origin) return {*settings.origin, height};
  if (mission != nullptr) return {*mission->home, height};
  throw std::invalid_argument("the origin of the frame is not known: give --origin LATITUDE LONGITUDE");
}

bool are_same(const tern::Halfspace& a, const tern::Halfspace& b) {
  return a.normal.x == b.normal.x && a.normal.y == b.normal.y && a.normal.z == b.normal.z && a.offset == b.offset;
}

/// The same fences at the same times: files have surfaces of one volume as zones of their own.
bool are_same(const AirspaceEntry& a, const AirspaceEntry& b) {
  const auto same_fence = [](const FittedFence& f, const FittedFence& g) {
    return f.kind == g.kind && std::equal(f.planes.begin(), f.planes.end(), g.planes.begin(), g.planes.end(),
                                          [](const auto& p, const auto& q) { return are_same(p, q); });
  };
  const auto same_span = [](const TimeSpan& s, const TimeSpan& t) { return s.from == t.from && s.until == t.until; };
  return std::equal(a.spans.begin(), a.spans.end(), b.spans.begin(), b.spans.end(), same_span) &&
         std::equal(a.fit.fences.begin(), a.fit.fences.end(), b.fit.fences.begin(), b.fit.fences.end(), same_fence);
}

class AirspaceMaker {
 public:
  AirspaceMaker(const std::vector<AirspaceFile>& files, const AirspaceSettings& settings)
      : files_(files), settings_(settings) {
    const Itinerary* const mission = home_mission(files);
    if (mission != nullptr) settings_.heights.home = GeoPosition{*mission->home, mission->home_height};
    heights_ = std::make_unique<ZoneHeights>(origin_of(settings_, mission), settings_.heights);
  }

  Airspace run() {
    check_fit(settings_.fit);
    check_names(settings_.leave_out, files_);
    check_names(settings_.keep_in, files_);
    out_.origin = heights_->frame().origin();
    out_.knows_height = heights_->knows_origin();
    warn(doubt_of_ground(settings_.heights, *heights_));
    warn(doubt_of_home(settings_.heights, *heights_));
    for (const AirspaceFile& file : files_) {
      for (const Zone& zone : file.zones) add(zone);
      out_.left_out.insert(out_.left_out.end(), file.left_out.begin(), file.left_out.end());
      if (!file.mission) continue;
      add_points(file.mission->points, "point", out_.points);
      add_points(file.mission->rally, "rally point", out_.rally);
    }
    warn(doubt_of_points(out_.points, settings_.fit.boundary));
    out_.settings = settings_;
    return std::move(out_);
  }

 private:
  void add(const Zone& zone) {
    AirspaceEntry entry{zone, {}, {}, ""};
    if (is_meant(settings_.keep_in, zone)) entry.zone.kind = ZoneKind::kKeepIn;
    if (is_meant(settings_.leave_out, zone)) {
      entry.left_out = "left out, as told";
    } else {
      try {
        fit(entry);
      } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(printable(zone.name) + ", " + zone.place + ": " + error.what() + far_text(zone));
      }
    }
    out_.entries.push_back(std::move(entry));
  }

  /// Nothing for a zone of which it may not matter where it is.
  std::string far_text(const Zone& zone) const {
    const ZoneDistance distance = zone_distance(zone, heights_->frame());
    return distance.is > kFarAway ? "; it is " + distance_text(distance) : "";
  }

  void fit(AirspaceEntry& entry) {
    if (entry.zone.kind == ZoneKind::kKeepIn && entry.zone.slants) {
      throw std::invalid_argument("a keep-in whose top slants is not read: give its corners one height");
    }
    if (!entry.zone.times.empty()) {
      if (!settings_.epoch) throw std::invalid_argument("it has times: give --epoch, when the flight's clock is 0");
      const Instant end = *settings_.epoch + static_cast<Instant>(settings_.hours * 3600.0) * kSecond;
      const Instant off = static_cast<Instant>(std::ceil(settings_.clock_error)) * kSecond;
      entry.spans = spans_of(entry.zone.times, {*settings_.epoch - off, end + off}, settings_.events);
      if (entry.spans.empty()) {
        entry.left_out = "does not hold then";
        return;
      }
    }
    note_work(entry.zone);
    warn(doubt_of_heights(entry.zone, *heights_, settings_.fit.boundary));
    entry.fit = fit_zone(entry.zone, *heights_, settings_.fit);
    if (entry.fit.fences.empty()) {
      entry.left_out = why_no_fence(entry);
    }
    for (const AirspaceEntry& other : out_.entries) {
      if (entry.fit.fences.empty() || !are_same(entry, other)) continue;
      entry.left_out = "as " + printable(other.zone.name) + ", " + other.zone.place;
      entry.fit.fences.clear();
    }
  }

  std::string why_no_fence(const AirspaceEntry& entry) {
    if (entry.zone.kind == ZoneKind::kKeepIn) return "holds all of the boundary";
    if (entry.fit.flat) return "has no area";
    if (entry.fit.above) return "at the boundary, but at other heights";
    const ZoneDistance distance = zone_distance(entry.zone, heights_->frame());
    warn_if_swapped(distance, printable(entry.zone.name) + ", " + entry.zone.place + ",");
    return "not at the boundary: " + distance_text(distance);
  }

  /// Of the first only: where one is swapped, most are.
  void warn_if_swapped(const ZoneDistance& distance, const std::string& what) {
    if (!distance.is_swapped() || ++swapped_ > 1) return;
    warn(what + " is " + distance_text(distance) + ": does its file, or --origin, have them the wrong way round?");
  }

  void warn(const std::string& what) const {
    if (!what.empty() && settings_.note) settings_.note("warning: " + what);
  }

  void note_work(const Zone& zone) const {
    std::size_t corners = 0;
    for (const ZoneArea& area : zone.areas) {
      corners += area.ring.size();
      for (const std::vector<GeoPoint>& hole : area.holes) corners += hole.size();
    }
    if (!settings_.note || corners < kManyCorners) return;
    settings_.note(printable(zone.name) + ", " + zone.place + ", has " + std::to_string(corners) +
                   " corners: this may take a while");
  }

  void add_points(const std::vector<ItineraryPoint>& from, const std::string& what, std::vector<LocalPoint>& to) {
    for (const ItineraryPoint& p : from) {
      const std::string name = what + " " + std::to_string(to.size() + 1) + " of the mission";
      Zone place;
      place.areas.push_back({{p.point}, {}});
      warn_if_swapped(zone_distance(place, heights_->frame()), name);
      const Plan2 at = heights_->frame().plan(p.point);
      try {
        const HeightRange z = heights_->local(p.height, {at, at});
        // Not lower than the file says, wherever the ground is.
        to.push_back({{at.east, at.north, z.high}, p.tolerance, p.dwell});
      } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(name + ": " + error.what());
      }
    }
  }

  const std::vector<AirspaceFile>& files_;
  AirspaceSettings settings_;
  std::unique_ptr<ZoneHeights> heights_;
  int swapped_ = 0;  // zones and points whose latitude and longitude are most likely swapped
  Airspace out_;
};

}  // namespace

bool answers_to(const Zone& zone, const std::string& said) {
  return zone.name == said || std::find(zone.aliases.begin(), zone.aliases.end(), said) != zone.aliases.end();
}

int Airspace::fence_count() const {
  std::size_t count = 0;
  for (const AirspaceEntry& e : entries) count += e.fit.fences.size() * std::max<std::size_t>(1, e.spans.size());
  return static_cast<int>(count);
}

int Airspace::plane_count() const {
  std::size_t count = 0;
  for (const AirspaceEntry& e : entries) {
    for (const FittedFence& f : e.fit.fences) count += f.planes.size() * std::max<std::size_t>(1, e.spans.size());
  }
  return static_cast<int>(count);
}

Airspace make_airspace(const std::vector<AirspaceFile>& files, const AirspaceSettings& settings) {
  if (!(settings.hours > 0.0 && settings.hours <= kMostHours)) {
    throw std::invalid_argument("the hours must be more than 0, and at most a year");
  }
  if (!(settings.clock_error >= 0.0 && settings.clock_error <= 1e6)) {
    throw std::invalid_argument("the clock's error must be 0 to 1000000 s");
  }
  return AirspaceMaker(files, settings).run();
}

std::string printable(const std::string& text, std::size_t most) {
  std::string out;
  std::size_t characters = 0;
  for (std::size_t at = 0; at < text.size(); ++characters) {
    if (characters == most) return out + "...";
    const std::size_t length = utf8_length(text, at);
    out += length > 0 ? text.substr(at, length) : "?";
    at += std::max<std::size_t>(1, length);
  }
  return out;
}

}  // namespace tern_host
