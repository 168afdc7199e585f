// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What port/companion makes of reports of other aircraft: their units, what is not known, and what is its own.
#include "companion/traffic.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "companion/clock_sync.hpp"

namespace tern_companion {
namespace {

using tern_onboard::Sighting;

class CompanionTraffic : public testing::Test {
 protected:
  CompanionTraffic() {
    view_.now = 100 * kSecond;
    view_.local = &local_;
    view_.here = &here_;
    view_.system = 1;
  }
  template <class Message>
  std::optional<Sighting> read(const Message& message, std::uint8_t system = 9) {
    Sender sender{system, 1, 0};
    const std::vector<std::uint8_t> bytes = pack(sender, message);
    FrameReader reader;
    reader.feed(bytes.data(), bytes.size());
    Frame frame;
    EXPECT_TRUE(reader.next(frame));
    return traffic_.read(frame, view_, why_);
  }
  /// 100 m north of the origin, which is 500 m above the sea.
  AdsbVehicle aircraft() const {
    AdsbVehicle report;
    report.icao = 0x4ca123;
    report.latitude = local_.origin.latitude + 8993;
    report.longitude = local_.origin.longitude;
    report.altitude = 620000;
    report.altitude_type = kAdsbGeometric;
    report.heading = 27000;  // west
    report.speed = 5000;
    report.climb = -250;
    report.emitter_type = 1;
    report.flags = kAdsbPlace | kAdsbAltitude | kAdsbHeading | kAdsbSpeed | kAdsbClimb;
    return report;
  }
  UtmGlobalPosition drone() const {
    UtmGlobalPosition report;
    report.time = 1700000000000000;
    report.latitude = local_.origin.latitude;
    report.longitude = local_.origin.longitude + 8993;
    report.altitude = 600000;
    report.velocity = {300, -400, 100};
    report.horizontal_deviation = 1500;
    report.vertical_deviation = 2000;
    report.speed_deviation = 25;
    report.uas_id = {0xab, 1};
    report.flags = kUtmTime | kUtmId | kUtmPlace | kUtmAltitude | kUtmSpeed | kUtmClimb;
    return report;
  }
  OpenDroneIdLocation remote() const {
    OpenDroneIdLocation report;
    report.latitude = local_.origin.latitude;
    report.longitude = local_.origin.longitude - 8993;
    report.barometric = 460.0f;
    report.geodetic = 560.0f;
    report.time = 1799.0f;
    report.direction = 9000;  // east
    report.speed = 500;
    report.climb = 100;
    report.address = {1, 2, 3};
    report.horizontal_accuracy = 10;  // 10 m
    report.vertical_accuracy = 5;     // 3 m
    report.speed_accuracy = 3;        // 1 m/s
    report.time_accuracy = 2;
    return report;
  }

  TrafficSettings settings_;
  LocalFrame local_{{0, 80000000, 500000, 0}, Projection::kAzimuthal};
  tern::Vec3 here_{0.0, 50.0, 60.0};
  TrafficView view_;
  std::string why_;
  Traffic traffic_{settings_};
};

TEST_F(CompanionTraffic, TransponderUnitsAreThoseOfTheMessage) {
  const auto s = read(aircraft());
  ASSERT_TRUE(s.has_value()) << why_;
  EXPECT_EQ(s->name, "adsb 4ca123");
  EXPECT_EQ(s->kind, tern::TrackClass::kAircraft);
  EXPECT_NEAR(s->position.x, 0.0, 1e-6);
  EXPECT_NEAR(s->position.y, 100.0, 0.01);
  EXPECT_NEAR(s->position.z, 120.0, 1e-9);
  ASSERT_TRUE(s->has_velocity);
  EXPECT_NEAR(s->velocity.x, -50.0, 1e-9);
  EXPECT_NEAR(s->velocity.y, 0.0, 1e-9);
  EXPECT_NEAR(s->velocity.z, -2.5, 1e-9);
  EXPECT_EQ(s->stamp, view_.now - kSecond / 2);
  EXPECT_NEAR(s->deviation, 37.8, 0.1);
  EXPECT_NEAR(s->error, 5.0 + 0.02 * 50.0, 1e-3) << "its own, and of the scale over the 50 m between them";
  EXPECT_NEAR(s->height_error, 110.0 + 4.0 * 47.2, 0.5) << "the geoid is not known";
}

TEST_F(CompanionTraffic, AgesOfTransponderReportsCount) {
  AdsbVehicle report = aircraft();
  report.age = 7;
  EXPECT_EQ(read(report)->stamp, view_.now - 7 * kSecond - kSecond / 2);
  EXPECT_NEAR(read(report)->time_error, 1.1, 1e-12);
}

TEST_F(CompanionTraffic, WhatATransponderDoesNotKnowIsBounded) {
  AdsbVehicle report = aircraft();
  report.flags = kAdsbAltitude;
  EXPECT_FALSE(read(report).has_value());
  EXPECT_NE(why_.find("coordinates"), std::string::npos);
  report = aircraft();
  report.flags = kAdsbPlace;
  auto s = read(report);
  EXPECT_EQ(s->height_error, 20000.0) << "anywhere";
  EXPECT_FALSE(s->has_velocity);
  report.flags = kAdsbPlace | kAdsbAltitude | kAdsbSpeed;
  EXPECT_FALSE(read(report)->has_velocity) << "a speed without a course";
  report.flags = kAdsbPlace | kAdsbAltitude | kAdsbHeading | kAdsbSpeed;
  s = read(report);
  ASSERT_TRUE(s->has_velocity);
  EXPECT_EQ(s->velocity.z, 0.0);
  EXPECT_EQ(s->speed_error, 15.0);
  report = aircraft();
  report.altitude_type = 0;
  EXPECT_EQ(read(report)->height_error, 300.0) << "by pressure";
}

TEST_F(CompanionTraffic, ClassesFollowTheEmitter) {
  AdsbVehicle report = aircraft();
  for (const auto& [emitter, kind] : {std::pair{kAdsbUav, tern::TrackClass::kDrone},
                                      {kAdsbServiceVehicle, tern::TrackClass::kTruck},
                                      {std::uint8_t{0}, tern::TrackClass::kAircraft},
                                      {std::uint8_t{200}, tern::TrackClass::kAircraft}}) {
    report.emitter_type = emitter;
    EXPECT_EQ(read(report)->kind, kind) << int{emitter};
  }
}

/// With the geoid at 40 m: 600 m above the ellipsoid are 560 m above the sea.
TEST_F(CompanionTraffic, HeightsAboveTheEllipsoidBecomeHeightsAboveTheSea) {
  settings_.geoid = 40.0;
  traffic_ = Traffic(settings_);
  auto s = read(drone());
  EXPECT_NEAR(s->position.z, 60.0, 1e-9);
  EXPECT_NEAR(s->height_error, 8.0, 1e-9);
  s = read(remote());
  EXPECT_NEAR(s->position.z, 20.0, 1e-4);
  // A transponder's may be above either: from 80 m to 120 m.
  s = read(aircraft());
  EXPECT_NEAR(s->position.z, 100.0, 1e-9);
  EXPECT_NEAR(s->height_error, 20.0 + 4.0 * 47.2, 0.5);
}

TEST_F(CompanionTraffic, DronesReportDeviationsAndTheirTime) {
  view_.unix_time = 1700000000000000000 + 400 * (kSecond / 1000);
  const auto s = read(drone());
  ASSERT_TRUE(s.has_value()) << why_;
  EXPECT_EQ(s->name, "utm ab0100000000000000000000000000000000");
  EXPECT_EQ(s->kind, tern::TrackClass::kDrone);
  EXPECT_NEAR(s->position.x, 100.0, 0.01);
  EXPECT_EQ(s->velocity.x, -4.0);  // east
  EXPECT_EQ(s->velocity.y, 3.0);   // north
  EXPECT_EQ(s->velocity.z, -1.0);  // down
  EXPECT_EQ(s->deviation, 1.5);
  EXPECT_EQ(s->speed_deviation, 0.25);
  EXPECT_NEAR(s->height_error, 110.0 + 8.0, 1e-9);
  EXPECT_EQ(s->stamp, view_.now - 400 * (kSecond / 1000));
  EXPECT_EQ(s->time_error, 0.1);
  view_.unix_time = 1700000000000000000 - 50 * (kSecond / 1000);
  EXPECT_EQ(read(drone())->stamp, view_.now) << "within the error of clocks, nothing is from the future";
  view_.unix_time.reset();
  EXPECT_EQ(read(drone())->stamp, view_.now);
  EXPECT_EQ(read(drone())->time_error, 2.0);
}

TEST_F(CompanionTraffic, WhatADroneDoesNotKnowIsBounded) {
  UtmGlobalPosition report = drone();
  report.horizontal_deviation = report.vertical_deviation = report.speed_deviation = 65535;
  auto s = read(report);
  EXPECT_EQ(s->deviation, 10.0);
  EXPECT_EQ(s->speed_deviation, 1.0);
  EXPECT_EQ(s->height_error, 110.0 + 80.0);
  report.flags = kUtmPlace;
  s = read(report);
  EXPECT_EQ(s->name, "utm system 9");
  EXPECT_EQ(s->height_error, 20000.0);
  EXPECT_FALSE(s->has_velocity);
  EXPECT_EQ(s->time_error, 2.0);
  report.flags = kUtmId | kUtmTime;
  EXPECT_FALSE(read(report).has_value());
  EXPECT_NE(why_.find("no position"), std::string::npos);
}

TEST_F(CompanionTraffic, RemoteIdHasAccuraciesAndTheTimeAfterTheHour) {
  view_.unix_time = 1700000000 / 3600 * 3600 * kSecond + 1800 * kSecond;
  const auto s = read(remote());
  ASSERT_TRUE(s.has_value()) << why_;
  EXPECT_EQ(s->name, "remote id 0102030000000000000000000000000000000000");
  EXPECT_NEAR(s->position.x, -100.0, 0.01);
  EXPECT_NEAR(s->position.z, 60.0, 1e-4);
  EXPECT_NEAR(s->velocity.x, 5.0, 1e-9);
  EXPECT_NEAR(s->velocity.z, 1.0, 1e-9);
  EXPECT_NEAR(s->deviation, 10.0 / 2.448, 1e-9);
  EXPECT_NEAR(s->speed_deviation, 1.0 / 2.448, 1e-9);
  EXPECT_NEAR(s->height_error, 110.0 + 4.0 * 3.0 / 1.96, 1e-6);
  EXPECT_EQ(s->stamp, view_.now - kSecond);
  EXPECT_NEAR(s->time_error, 0.2, 1e-12);
  // Over the hour, in both directions.
  OpenDroneIdLocation report = remote();
  report.time = 3599.5f;
  view_.unix_time = *view_.unix_time - 1800 * kSecond;
  EXPECT_EQ(read(report)->stamp, view_.now - kSecond / 2);
  report.time = 0.125f;
  view_.unix_time = *view_.unix_time - kSecond / 16;
  EXPECT_EQ(read(report)->stamp, view_.now) << "ahead by less than the error of the clocks";
}

TEST_F(CompanionTraffic, WhatRemoteIdDoesNotKnowIsBounded) {
  OpenDroneIdLocation report = remote();
  report.geodetic = -1000.0f;
  EXPECT_NEAR(read(report)->position.z, -40.0, 1e-4) << "by pressure";
  EXPECT_EQ(read(report)->height_error, 300.0);
  report.barometric = -1000.0f;
  EXPECT_EQ(read(report)->height_error, 20000.0);
  report = remote();
  report.direction = 36100;
  EXPECT_FALSE(read(report)->has_velocity);
  report = remote();
  report.speed = 25500;
  EXPECT_FALSE(read(report)->has_velocity);
  report = remote();
  report.climb = 6300;
  EXPECT_EQ(read(report)->velocity.z, 0.0);
  EXPECT_EQ(read(report)->speed_error, 15.0);
  report = remote();
  report.horizontal_accuracy = report.speed_accuracy = 0;
  EXPECT_NEAR(read(report)->deviation, 185.2 / 2.448, 1e-9);
  EXPECT_NEAR(read(report)->speed_deviation, 10.0 / 2.448, 1e-9);
  view_.unix_time = 1700000000 * kSecond;
  report.time = 65535.0f;
  EXPECT_EQ(read(report)->time_error, 2.0);
  report.latitude = report.longitude = 0;
  EXPECT_FALSE(read(report).has_value());
  EXPECT_NE(why_.find("no position"), std::string::npos);
}

TEST_F(CompanionTraffic, ItsOwnReportsAreNone) {
  settings_.own_ids = {"4CA123", "ab0100000000000000000000000000000000", "1581F4FEC234"};
  traffic_ = Traffic(settings_);
  EXPECT_FALSE(read(aircraft()).has_value());
  EXPECT_FALSE(read(drone()).has_value());
  EXPECT_TRUE(read(remote()).has_value()) << "nobody has said yet whose address it is";
  OpenDroneIdBasicId id;
  id.address = remote().address;
  const std::string serial = "1581F4FEC234";
  std::copy(serial.begin(), serial.end(), id.uas_id.begin());
  EXPECT_FALSE(read(id).has_value());
  EXPECT_FALSE(read(remote()).has_value());
  EXPECT_EQ(why_, "");
  traffic_ = Traffic({});
  EXPECT_FALSE(read(drone(), view_.system).has_value()) << "from the autopilot itself";
  OpenDroneIdLocation own = remote();
  own.address = {};
  EXPECT_FALSE(read(own).has_value()) << "for its own transmitter";
  EXPECT_EQ(why_, "");
}

TEST_F(CompanionTraffic, PlacesNothingWithoutAnOriginOrFarAway) {
  AdsbVehicle report = aircraft();
  report.latitude += 1000000;
  EXPECT_FALSE(read(report).has_value());
  EXPECT_NE(why_.find("10 km"), std::string::npos);
  view_.here = nullptr;
  EXPECT_NEAR(read(aircraft())->error, 5.0 + 0.02 * 100.0, 1e-3);
  view_.local = nullptr;
  EXPECT_FALSE(read(aircraft()).has_value());
  EXPECT_NE(why_.find("GPS_GLOBAL_ORIGIN"), std::string::npos);
  EXPECT_FALSE(read(Heartbeat{}).has_value());
  EXPECT_EQ(why_, "");
}

}  // namespace
}  // namespace tern_companion
