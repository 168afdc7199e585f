// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// KML 2.2 and KMZ: each Placemark with polygons is a keep-out.
#include <zip.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <pugixml.hpp>
#include <string>

#include "host/airspace/formats.hpp"
#include "host/number.hpp"
#include "host/text_records.hpp"

namespace tern_host {
namespace {

constexpr std::size_t kMostKmlBytes = 64u << 20;

/// The name of an element without the prefix of its namespace.
std::string local_name(const pugi::xml_node& node) {
  const std::string name = node.name();
  const std::size_t colon = name.find(':');
  return colon == std::string::npos ? name : name.substr(colon + 1);
}

pugi::xml_node child(const pugi::xml_node& node, const char* name) {
  for (const pugi::xml_node& c : node.children()) {
    if (local_name(c) == name) return c;
  }
  return {};
}

/// An element's text without the blanks around it. Comments and CDATA divide a text into several nodes.
std::string text_of(const pugi::xml_node& node) {
  std::string text;
  for (const pugi::xml_node& c : node.children()) text += c.value();
  const std::size_t first = text.find_first_not_of(" \t\r\n"), last = text.find_last_not_of(" \t\r\n");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

/// Collects the elements of a name, outermost first, wherever they are below a node.
struct Finder : pugi::xml_tree_walker {
  explicit Finder(std::vector<std::string> wanted) : names(std::move(wanted)) {}
  bool for_each(pugi::xml_node& node) override {
    if (std::find(names.begin(), names.end(), local_name(node)) != names.end()) found.push_back(node);
    return true;
  }
  std::vector<std::string> names;
  std::vector<pugi::xml_node> found;
};

std::vector<pugi::xml_node> all_below(pugi::xml_node node, std::vector<std::string> names) {
  Finder finder(std::move(names));
  node.traverse(finder);
  return finder.found;
}

class KmlReader {
 public:
  KmlReader(const std::string& text, std::string name) : name_(std::move(name)) {
    file_.format = "KML";
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] == '\n') line_ends_.push_back(static_cast<std::ptrdiff_t>(i));
    }
    const pugi::xml_parse_result result = document_.load_buffer(text.data(), text.size());
    if (!result) throw RecordError({name_, line_of(result.offset)}, std::string("not XML: ") + result.description());
  }

  AirspaceFile read() {
    if (local_name(document_.document_element()) != "kml") {
      throw RecordError({name_, 1}, "the outermost element must be 'kml'");
    }
    for (const pugi::xml_node& node : all_below(document_, {"Placemark"})) placemark(node);
    for (const pugi::xml_node& link : all_below(document_, {"NetworkLink"})) {
      file_.left_out.push_back("NetworkLink, " + place(link) + ": links are not followed");
    }
    return std::move(file_);
  }

 private:
  int line_of(std::ptrdiff_t offset) const {
    return 1 + static_cast<int>(std::lower_bound(line_ends_.begin(), line_ends_.end(), offset) - line_ends_.begin());
  }
  std::string place(const pugi::xml_node& node) const {
    return name_ + ":" + std::to_string(line_of(node.offset_debug()));
  }
  [[noreturn]] void refuse(const pugi::xml_node& node, const std::string& reason) const {
    throw RecordError({name_, line_of(node.offset_debug())}, "in " + quote(local_name(node)) + ": " + reason);
  }

  void placemark(const pugi::xml_node& node) {
    Zone zone;
    zone.name = text_of(child(node, "name"));
    if (zone.name.empty()) zone.name = "Placemark";
    zone.type = "area";
    zone.place = place(node);
    zone.edges = EdgeRule::kEither;
    read_times(node, zone);
    for (const pugi::xml_node& shape :
         all_below(node, {"Polygon", "Point", "LineString", "LinearRing", "Track", "Model"})) {
      const std::string parent = local_name(shape.parent());
      if (local_name(shape) == "Polygon") {
        polygon(shape, zone);
      } else if (parent != "outerBoundaryIs" && parent != "innerBoundaryIs") {
        file_.left_out.push_back(zone.name + ", " + place(shape) + ": a " + local_name(shape) + " has no area");
      }
    }
  }

  void read_times(const pugi::xml_node& node, Zone& zone) const {
    const pugi::xml_node span = child(node, "TimeSpan");
    if (!span) return;
    Applicability when;
    when.from = time(child(span, "begin"), false);
    when.until = time(child(span, "end"), true);
    if (when.from || when.until) zone.times.push_back(when);
  }

  /// A date is the whole day in UTC.
  std::optional<Instant> time(const pugi::xml_node& node, bool is_end) const {
    const std::string text = text_of(node);
    if (text.empty()) return {};
    if (const std::optional<Instant> instant = parse_instant(text)) return instant;
    const std::optional<Instant> day = text.size() == 10 ? parse_instant(text + "T00:00:00Z") : std::nullopt;
    if (!day) refuse(node, quote(text) + " is neither a date nor a date and time with a time zone");
    return is_end ? *day + kDay : *day;
  }

  /// Of the corners of a ring.
  struct Heights {
    double least = HUGE_VAL;
    double most = -HUGE_VAL;
  };

  std::vector<GeoPoint> ring(const pugi::xml_node& boundary, Heights& heights) const {
    const pugi::xml_node node = child(child(boundary, "LinearRing"), "coordinates");
    if (!node) refuse(boundary, "a LinearRing with coordinates is missing");
    std::string text = text_of(node);
    std::replace(text.begin(), text.end(), '\n', ' ');
    std::vector<GeoPoint> corners;
    for (const std::string& tuple : split_words(text, false)) {
      const Words words = split_words(tuple, true);
      double v[3] = {0.0, 0.0, 0.0};
      if (words.size() < 2 || words.size() > 3) refuse(node, quote(tuple) + " is no longitude,latitude[,height]");
      for (std::size_t i = 0; i < words.size(); ++i) {
        if (parse_number(words[i], v[i]) != NumberError::kNone) refuse(node, quote(words[i]) + " is no number");
      }
      if (!(std::fabs(v[1]) <= 90.0)) refuse(node, "the latitude " + brief(v[1]) + " is beyond 90 degrees");
      if (!(std::fabs(v[0]) <= 360.0)) refuse(node, "the longitude " + brief(v[0]) + " is beyond 360 degrees");
      corners.push_back({v[1], v[0]});
      heights = {std::min(heights.least, v[2]), std::max(heights.most, v[2])};
    }
    const bool closed = corners.size() > 1 && corners.front().latitude == corners.back().latitude &&
                        corners.front().longitude == corners.back().longitude;
    if (closed) corners.pop_back();
    if (corners.size() < 3) refuse(node, "an outline needs three corners or more");
    return corners;
  }

  void polygon(const pugi::xml_node& node, const Zone& like) {
    Zone zone = like;
    zone.place = place(node);
    Heights heights, of_hole;
    ZoneArea area;
    const pugi::xml_node outer = child(node, "outerBoundaryIs");
    if (!outer) refuse(node, "the outerBoundaryIs is missing");
    area.ring = ring(outer, heights);
    for (const pugi::xml_node& c : node.children()) {
      if (local_name(c) == "outerBoundaryIs" && c != outer) refuse(c, "a Polygon has one outerBoundaryIs");
      if (local_name(c) == "innerBoundaryIs") area.holes.push_back(ring(c, of_hole));
    }
    zone.areas.push_back(area);
    const std::string mode = text_of(child(node, "altitudeMode")), extrude = text_of(child(node, "extrude"));
    const bool extruded = extrude == "1" || extrude == "true";
    if (extruded && mode == "absolute") zone.upper = ZoneHeight{heights.most, HeightReference::kSeaLevel};
    if (extruded && mode == "relativeToGround") zone.upper = ZoneHeight{heights.most, HeightReference::kGround};
    zone.slants = zone.upper && heights.least < heights.most;
    if (!zone.upper) zone.notes.push_back("not extruded from a height: taken for all heights");
    file_.zones.push_back(zone);
  }

  std::string name_;
  std::vector<std::ptrdiff_t> line_ends_;
  pugi::xml_document document_;
  AirspaceFile file_;
};

bool ends_with_kml(const std::string& name) {
  const std::string end = name.size() < 4 ? "" : name.substr(name.size() - 4);
  return end == ".kml" || end == ".KML";
}

struct CloseArchive {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct CloseEntry {
  void operator()(zip_file_t* entry) const { zip_fclose(entry); }
};

}  // namespace

AirspaceFile read_kml(const std::string& text, const std::string& name) {
  if (text.size() > kMostKmlBytes) throw RecordError({name, 0}, "larger than 64 MB");
  return KmlReader(text, name).read();
}

std::string kml_of_kmz(const std::string& bytes, const std::string& name) {
  const Place where{name, 0};
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* const source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  const std::unique_ptr<zip_t, CloseArchive> archive(
      source == nullptr ? nullptr : zip_open_from_source(source, ZIP_RDONLY, &error));
  zip_error_fini(&error);
  if (archive == nullptr) {
    zip_source_free(source);
    throw RecordError(where, "not a KMZ archive, or a damaged one");
  }
  zip_int64_t chosen = zip_name_locate(archive.get(), "doc.kml", 0);
  for (zip_int64_t i = 0; chosen < 0 && i < zip_get_num_entries(archive.get(), 0); ++i) {
    const char* const entry = zip_get_name(archive.get(), static_cast<zip_uint64_t>(i), 0);
    if (entry != nullptr && ends_with_kml(entry)) chosen = i;
  }
  if (chosen < 0) throw RecordError(where, "the archive has no KML file");
  const std::unique_ptr<zip_file_t, CloseEntry> entry(
      zip_fopen_index(archive.get(), static_cast<zip_uint64_t>(chosen), 0));
  if (entry == nullptr) throw RecordError(where, "the archive's KML file cannot be read");
  std::string text;
  char buffer[65536];
  zip_int64_t got = 0;
  while ((got = zip_fread(entry.get(), buffer, sizeof buffer)) > 0) {
    text.append(buffer, static_cast<std::size_t>(got));
    if (text.size() > kMostKmlBytes) throw RecordError(where, "its KML file is larger than 64 MB");
  }
  if (got < 0) throw RecordError(where, "the archive's KML file is damaged");
  return text;
}

}  // namespace tern_host
