// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A hall full of people and a detector in its middle: what a tracker makes of it, judged by where the people are.
#ifndef TERN_TESTS_TRACKER_CROWD_HPP
#define TERN_TESTS_TRACKER_CROWD_HPP

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "support/random.hpp"
#include "tern_onboard/pose.hpp"
#include "tern_tracker/tracker.hpp"

namespace tern_test {

struct CrowdSettings {
  int people = 5;
  double seconds = 60.0;
  double deviation = 0.1;  ///< m, of a detection along each axis
  double missed = 0.1;     ///< share of detections
  double clutter = 0.2;    ///< detections of nothing in a scan, 1 at most
  bool hides = true;       ///< who stands behind another one is not seen
  std::uint64_t seed = 1;
};

/// Sums over people and time.
struct CrowdFigures {
  int born = 0, born_late = 0;     ///< people who got a track; more than 0.3 s after their first detection
  int switches = 0;                ///< of a person from one track to another
  int ghosts = 0, reports = 0;     ///< sightings, and those with nobody within a metre
  long instants = 0, unknown = 0;  ///< of 10 ms and a person; without a sighting in the last 0.5 s
  long unseen = 0;                 ///< of them, without a detection
  long held = 0, outside = 0;      ///< with one; and out of its tube
  void add(const CrowdFigures& o) {
    born += o.born, born_late += o.born_late, switches += o.switches, ghosts += o.ghosts, reports += o.reports;
    instants += o.instants, unknown += o.unknown, unseen += o.unseen, held += o.held, outside += o.outside;
  }
  double minutes() const { return 0.01 * static_cast<double>(instants) / 60.0; }
};

class Crowd {
 public:
  explicit Crowd(const CrowdSettings& settings) : settings_(settings), random_(settings.seed) {
    for (int k = 0; k < settings.people; ++k) people_.push_back(enter());
  }

  CrowdFigures watch(tern_tracker::Tracker& tracker) {
    for (time_ = 0.0; time_ < settings_.seconds; time_ += kStep) {
      for (Person& person : people_) walk(person);
      if (++steps_ % 10 == 0) look(tracker);
      for (const Person& person : people_) judge(person);
    }
    return figures_;
  }

 private:
  static constexpr double kStep = 0.01, kHalfHall = 12.0, kAcceleration = 3.0;

  struct Person {
    double x = 0.0, y = 0.0, vx = 0.0, vy = 0.0, wish_x = 0.0, wish_y = 0.0, decides = 0.0, leaves = 0.0;
    double first_seen = -1.0, last_seen = -1.0;
    bool is_known = false;
    tern_onboard::Sighting last;
  };

  double normal() {
    const double u = random_.real(1e-12, 1.0), turn = random_.real(0.0, 6.283185307179586);
    return std::sqrt(-2.0 * std::log(u)) * std::cos(turn);
  }
  /// Somebody comes in at a wall, for 10 to 40 s.
  Person enter() {
    const double at = random_.real(-kHalfHall, kHalfHall), wall = random_.chance(0.5) ? kHalfHall : -kHalfHall;
    const bool across = random_.chance(0.5);
    Person person{};
    person.x = across ? at : wall;
    person.y = across ? wall : at;
    person.decides = time_;
    person.leaves = time_ + random_.real(10.0, 40.0);
    return person;
  }
  /// Stops and turns at random, and walks at 0.5 to 1.8 m/s; never faster than a person may.
  void walk(Person& p) {
    if (time_ > p.leaves) p = enter();
    if (time_ >= p.decides) {
      const double speed = random_.chance(0.25) ? 0.0 : random_.real(0.5, 1.8);
      const bool is_out = std::max(std::abs(p.x), std::abs(p.y)) > kHalfHall - 2.0;
      const double way = is_out ? std::atan2(-p.y, -p.x) : random_.real(-3.15, 3.15);
      p.wish_x = speed * std::cos(way), p.wish_y = speed * std::sin(way);
      p.decides = time_ + random_.real(1.0, 4.0);
    }
    const double ax = p.wish_x - p.vx, ay = p.wish_y - p.vy, change = std::hypot(ax, ay);
    const double share = change > kAcceleration * kStep ? kAcceleration * kStep / change : 1.0;
    p.vx += share * ax, p.vy += share * ay;
    p.x += kStep * p.vx, p.y += kStep * p.vy;
  }
  bool is_hidden(const Person& p) const {
    const double far = std::hypot(p.x, p.y);
    return settings_.hides && std::any_of(people_.begin(), people_.end(), [&](const Person& o) {
             const double near = std::hypot(o.x, o.y);
             if (&o == &p || near >= far) return false;
             const double turn = std::remainder(std::atan2(p.y, p.x) - std::atan2(o.y, o.x), 6.283185307179586);
             return std::abs(turn) < std::asin(std::min(1.0, 0.25 / near));
           });
  }
  tern_onboard::Sighting detection(double x, double y) {
    tern_onboard::Sighting sighting;
    sighting.position = {x + settings_.deviation * normal(), y + settings_.deviation * normal(),
                         1.0 + settings_.deviation * normal()};
    sighting.deviation = settings_.deviation;
    return sighting;
  }
  void look(tern_tracker::Tracker& tracker) {
    std::vector<tern_onboard::Sighting> detections;
    for (Person& p : people_) {
      if (is_hidden(p) || random_.chance(settings_.missed)) continue;
      if (p.first_seen < 0.0) p.first_seen = time_;
      p.last_seen = time_;
      detections.push_back(detection(p.x, p.y));
    }
    if (random_.chance(settings_.clutter)) {
      detections.push_back(detection(random_.real(-kHalfHall, kHalfHall), random_.real(-kHalfHall, kHalfHall)));
    }
    for (std::size_t k = detections.size(); k > 1; --k) {  // in no order
      std::swap(detections[k - 1], detections[static_cast<std::size_t>(random_.integer(0, static_cast<int>(k) - 1))]);
    }
    for (const auto& told : tracker.scan(std::llround(1e9 * time_), detections)) note(told);
  }
  /// A sighting is of whom its track was of, if that is within a metre; else of who is nearest.
  void note(const tern_onboard::Sighting& told) {
    ++figures_.reports;
    const auto away = [&](const Person& p) { return std::hypot(p.x - told.position.x, p.y - told.position.y); };
    const auto is_his = [&](const Person& p) { return p.is_known && p.last.name == told.name && away(p) <= 1.0; };
    const auto nearer = [&](const Person& a, const Person& b) { return away(a) < away(b); };
    const auto his = std::find_if(people_.begin(), people_.end(), is_his);
    Person& p = his != people_.end() ? *his : *std::min_element(people_.begin(), people_.end(), nearer);
    if (away(p) > 1.0) {
      ++figures_.ghosts;
      return;
    }
    if (!p.is_known) {
      ++figures_.born;
      figures_.born_late += p.first_seen < 0.0 || time_ - p.first_seen > 0.3 + 1e-9 ? 1 : 0;
    } else if (p.last.name != told.name) {
      ++figures_.switches;
    }
    p.is_known = true;
    p.last = told;
  }
  void judge(const Person& p) {
    if (p.first_seen < 0.0) return;  // nobody has seen him yet
    ++figures_.instants;
    const double s = time_ - 1e-9 * static_cast<double>(p.last.stamp);
    if (!p.is_known || s > 0.5) {
      ++figures_.unknown;
      figures_.unseen += time_ - p.last_seen > 0.5 ? 1 : 0;
      return;
    }
    ++figures_.held;
    const tern::Track tube = tern_onboard::track_of(p.last, 4.0);
    const double error = tube.error + s * (tube.error_speed + 0.5 * s * tube.error_growth);
    const double dx = p.x - tube.position.x, dy = p.y - tube.position.y, dz = 1.0 - tube.position.z;
    const double off = std::hypot(dx - s * tube.velocity.x, dy - s * tube.velocity.y, dz - s * tube.velocity.z);
    figures_.outside += off > error || std::hypot(dx, dy, dz) > tube.error + tube.reach * s ? 1 : 0;
  }

  CrowdSettings settings_;
  Random random_;
  std::vector<Person> people_;
  CrowdFigures figures_;
  double time_ = 0.0;
  int steps_ = 0;
};

}  // namespace tern_test

#endif
