// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tern_onboard/wish.hpp"

#include <algorithm>
#include <cmath>

#include "tern_onboard/parameters.hpp"
#include "tern_onboard/pose.hpp"

namespace tern_onboard {
namespace {

/// The mode of a word of FlySettings::yaw.
tern::FlightYawMode yaw_mode_of(const std::string& word) {
  const std::vector<std::string>& words = yaw_words();
  const auto at = std::find(words.begin(), words.end(), word);
  return static_cast<tern::FlightYawMode>(at == words.end() ? 0 : at - words.begin());
}

}  // namespace

Wish::Wish(const FlySettings& settings) {
  yaw_.mode = yaw_mode_of(settings.yaw);
  yaw_.acceleration_max = settings.yaw_acceleration;
  yaw_.field_of_view = settings.field_of_view;
  yaw_.heading = {1.0, 0.0};
}

void Wish::set_mission(const std::vector<tern::Via>& points, tern::ViaPolicy policy) {
  points_ = points;
  policy_ = policy;
}

tern::Status Wish::send(tern::Flight& flight, tern::FlightRecorder& record, std::size_t done,
                        const tern::Vec3& offset) {
  if (points_.empty()) return tern::Status::kOk;
  points_.erase(points_.begin(), points_.begin() + static_cast<std::ptrdiff_t>(std::min(done, points_.size() - 1)));
  std::vector<tern::Via> moved = points_;
  for (tern::Via& via : moved) via.position = minus(via.position, offset);
  const auto count = static_cast<std::int32_t>(moved.size());
  const tern::Status answer = flight.set_mission(moved.data(), count, policy_);
  record.set_mission(moved.data(), count, policy_, answer);
  return answer;
}

void Wish::set_yaw(tern::FlightYawMode mode, const tern::Vec3& point, double heading) {
  yaw_.mode = mode;
  yaw_.point = point;
  yaw_.heading = {std::cos(heading), std::sin(heading)};
}

tern::Status Wish::send_yaw(tern::Flight& flight, tern::FlightRecorder& record, double start,
                            const tern::Vec3& offset) const {
  tern::FlightYaw yaw = yaw_;
  yaw.start = {std::cos(start), std::sin(start)};
  yaw.point = minus(yaw_.point, offset);
  const tern::Status answer = flight.set_yaw(yaw);
  record.set_yaw(yaw, answer);
  return answer;
}

}  // namespace tern_onboard
