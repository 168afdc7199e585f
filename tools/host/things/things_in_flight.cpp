// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/things/things_in_flight.hpp"

#include <algorithm>

#include "host/flight/contact_search.hpp"
#include "host/flight/vectors.hpp"
#include "host/nanoseconds.hpp"
#include "host/number.hpp"

namespace tern_host {
namespace {

constexpr double kStepOfPlaces = 0.1;  // s
constexpr double kMostPlaces = 1200.0;

}  // namespace

int ThingTotals::in_motion() const {
  return static_cast<int>(
      std::count_if(contacts.begin(), contacts.end(), [](const ThingContact& contact) { return contact.in_motion; }));
}

ThingsInFlight::ThingsInFlight(const FlightWorld& world)
    : world_(world),
      motions_(motions_of(world.things)),
      detector_(world, motions_),
      watch_(world.things, motions_),
      step_(std::max(kStepOfPlaces, world.settings.time_limit / kMostPlaces)),
      places_(world.things.size()) {}

void ThingsInFlight::sense(std::int64_t t, const Vehicle& vehicle) {
  detector_.take(t, vehicle.position(), vehicle.estimate());
  const double seconds = seconds_of(t);
  if (places_.empty() || static_cast<double>(places_[0].size()) * step_ > seconds) return;
  for (std::size_t k = 0; k < places_.size(); ++k) {
    places_[k].push_back(motions_[k].at(seconds).position);
  }
}

void ThingsInFlight::note_tick(const tern::FlightReport& report, bool evades) {
  if (report.committed == committed_) return;
  committed_ = report.committed;
  watch_.note_commit(!evades, detector_);
}

void ThingsInFlight::hunt(std::int64_t t, std::int64_t step, const Vehicle& vehicle) {
  for (ThingMotion& motion : motions_) {
    motion.hunt(seconds_of(t), seconds_of(step), vehicle.position());
  }
}

bool ThingsInFlight::look(std::int64_t t, const Vehicle& vehicle, const tern::Sample& command) {
  const MovingBody body{vehicle.position(), length(vehicle.velocity()), most_acceleration(world_.settings),
                        world_.settings.body_radius};
  const std::size_t before = watch_.contacts().size();
  watch_.look(t, body, length(command.velocity));
  return watch_.contacts().size() > before;
}

std::string ThingsInFlight::broken() const {
  const ThingContact* const contact = watch_.in_motion();
  if (contact == nullptr || !contact->in_tube) return "";
  return "things: at " + fixed(contact->time, 3) + " s, at " + fixed(contact->speed, 2) + " m/s, the body touched " +
         world_.things[contact->thing].name + ", which was in the tube that the plan was proven with";
}

bool ThingsInFlight::collides(FlightContact& contact) const {
  const ThingContact* const first = watch_.in_motion();
  if (first == nullptr || first->in_tube) return false;
  contact.happened = true;
  contact.time = first->time;
  contact.speed = first->speed;
  contact.broken_assumption = "tube";
  return true;
}

}  // namespace tern_host
