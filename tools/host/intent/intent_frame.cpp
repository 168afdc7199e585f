// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/intent/intent_frame.hpp"

#include <cmath>
#include <stdexcept>

#include "host/number.hpp"

namespace tern_host {
namespace {

[[noreturn]] void refuse(const std::string& file, const std::string& what, const std::string& in_file,
                         const std::string& said) {
  throw std::invalid_argument(file + ": " + what + " is " + in_file + ", not " + said +
                              ": use the frame that the plan was made in");
}

void check_origin(const EarthOrigin& said, const EarthFrame& in_file, const std::string& file) {
  if (!in_file.origin || are_same(*in_file.origin, said)) return;
  refuse(file, "the origin of its frame", origin_text(*in_file.origin), origin_text(said));
}

void check_height(double said, const EarthFrame& in_file, const std::string& file) {
  if (!in_file.height || are_same_heights(*in_file.height, said)) return;
  refuse(file, "its origin's height above the ellipsoid", shortest(*in_file.height) + " m", shortest(said) + " m");
}

void check_epoch(Instant said, const EarthFrame& in_file, const std::string& file) {
  if (in_file.epoch.empty() || *parse_instant(in_file.epoch) == said) return;
  refuse(file, "its epoch", in_file.epoch, instant_text(said));
}

}  // namespace

void check_same_frame(const IntentFrame& frame, const EarthFrame& in_file, const std::string& file) {
  const GeoPosition& origin = frame.heights.frame().origin();
  check_origin({origin.point.latitude, origin.point.longitude}, in_file, file);
  check_height(origin.height, in_file, file);
  check_epoch(frame.epoch, in_file, file);
}

IntentFrame intent_frame(const ToldFrame& told, const EarthFrame& in_file, const std::string& file) {
  const auto& origin = told.frame.origin ? told.frame.origin : in_file.origin;
  if (!origin) {
    throw std::invalid_argument(file + ": it does not say where its frame is: give --origin LATITUDE LONGITUDE");
  }
  const std::string& epoch = told.frame.epoch.empty() ? in_file.epoch : told.frame.epoch;
  if (epoch.empty()) {
    throw std::invalid_argument(file +
                                ": it does not say when its clock is 0: give --epoch, such as "
                                "2026-03-01T09:30:00Z");
  }
  const double height = told.frame.height.value_or(in_file.height.value_or(NAN));
  IntentFrame frame{ZoneHeights({{origin->latitude, origin->longitude}, height}, told.heights), *parse_instant(epoch)};
  if (!frame.heights.knows_origin()) {
    throw std::invalid_argument(file + ": it does not say how high its origin is: give --height, or --height-amsl");
  }
  check_same_frame(frame, in_file, file);
  return frame;
}

}  // namespace tern_host
