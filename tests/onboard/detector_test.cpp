// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What an Onboard asks a detector of its sensors' frames, and what it makes of the answers.
#include "tern_onboard/detector.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "onboard/onboard_lookout.hpp"
#include "tern_onboard/parameters.hpp"

namespace {

using tern::Vec3;
using tern_onboard::Detector;
using tern_onboard::Fault;
using tern_onboard::Onboard;
using tern_onboard::Seen;
using tern_onboard::Settings;
using tern_onboard::Sighting;
using tern_test::kCentisecond;
using tern_test::Lookout;
using tern_test::Told;

/// A detector that says what it was asked, and answers what it is told to.
class Witness : public Detector {
 public:
  struct Look {
    int sensor;
    std::uint64_t frames;  // that the map had
    bool is_busy;
    tern::Pose eye;
    std::int64_t stamp;
  };
  struct Book {
    std::vector<Look> looks;
    Seen answer;
  };
  explicit Witness(Book& book) : book_(book) {}
  Seen see(int sensor, const tern::RollingMap& map, const tern::DepthView&, const tern::Pose& eye,
           std::int64_t stamp) override {
    return note(sensor, map, eye, stamp);
  }
  Seen see(int sensor, const tern::RollingMap& map, const tern::Beams&, const Vec3& origin,
           std::int64_t stamp) override {
    return note(sensor, map, {origin, {1.0, 0.0, 0.0, 0.0}}, stamp);
  }
  void restart() override {}

 private:
  Seen note(int sensor, const tern::RollingMap& map, const tern::Pose& eye, std::int64_t stamp) {
    book_.looks.push_back({sensor, map.frames(), map.busy(), eye, stamp});
    Seen seen = book_.answer;
    for (Sighting& one : seen.things) one.stamp = stamp;
    return seen;
  }
  Book& book_;
};

TEST(OnboardDetector, LookAtTheMapBeforeTheFrameAndFromWhereItWasTaken) {
  Witness::Book book;
  Lookout lookout("none", {}, std::make_unique<Witness>(book));
  lookout.add_camera();
  lookout.add_lidar();
  lookout.late = 3 * kCentisecond;
  lookout.scene.has_man = false;
  lookout.fly(0.5);
  lookout.onboard->set_goal({0.7, 0.0, 1.5}, lookout.now);
  lookout.fly(1.5);
  EXPECT_GT(lookout.position.x, 0.3) << "it moves";
  ASSERT_GT(book.looks.size(), 30u);
  for (std::size_t k = 0; k < book.looks.size(); ++k) {
    const Witness::Look& look = book.looks[k];
    EXPECT_EQ(look.frames, k);
    EXPECT_FALSE(look.is_busy);
    EXPECT_LT(tern_onboard::length(tern_onboard::minus(look.eye.position, lookout.was.at(look.stamp))), 1e-9) << k;
    EXPECT_EQ(look.sensor, static_cast<int>(k % 2)) << "they take turns";
  }
}

TEST(OnboardDetector, AreNobodyElse) {
  Witness::Book book;
  Lookout lookout(
      "none", [](Settings& s) { s.map.depth_margin_square = 0.01; }, std::make_unique<Witness>(book));
  lookout.add_camera();
  lookout.add_camera();
  Sighting one;
  one.name = "track 1";
  one.position = {3.0, 0.0, 1.5};
  one.error = 0.1;
  book.answer.things = {one};
  lookout.fly(0.5);
  EXPECT_EQ(lookout.things(), 2u);
  for (const Told& told : lookout.told()) {
    const double frame = 0.02 + 0.005 * 3.0 + 0.02 + 0.01 * 9.0;
    EXPECT_NEAR(told.track.error, 0.1 + frame, 1e-6) << "that of the frame is added";
  }
  one.stamp = lookout.now;
  lookout.onboard->add_sighting(one, lookout.now);
  EXPECT_EQ(lookout.things(), 3u);
}

TEST(OnboardDetector, SayWhatIsWrong) {
  Witness::Book book;
  book.answer.is_all = false;
  Lookout lookout("none", {}, std::make_unique<Witness>(book));
  lookout.add_camera();
  lookout.fly(0.5);
  EXPECT_EQ(lookout.count(Fault::kThingsFull), book.looks.size());
  book.answer.is_all = true;
  lookout.fly(1.5);
  std::string said;
  for (const tern_onboard::Notice& notice : lookout.onboard->take_notices()) said += notice.text + "\n";
  const std::size_t first = said.find("camera: more seems to move in a frame than can be tracked");
  EXPECT_NE(first, std::string::npos) << said;
  EXPECT_EQ(said.find("more seems to move", first + 20), std::string::npos) << "said once";
  EXPECT_NE(said.find("camera: all that moves is tracked again"), std::string::npos) << said;

  Settings settings;
  EXPECT_EQ(
      tern_onboard::set_parameter_text(settings, "clusters", "people"),
      "parameter clusters = \"people\" is refused: allowed are none, person, cyclist, car, truck, bird, drone and "
      "aircraft");
  EXPECT_EQ(tern_onboard::set_parameter_text(settings, "clusters", "drone"), "");
  EXPECT_EQ(tern_onboard::settings_fault(settings), "");
  settings.things.range = 0.0;
  EXPECT_NE(tern_onboard::settings_fault(settings).find("thing_range is 0"), std::string::npos);
  settings.things.range = 1.0;
  try {
    const Onboard onboard(settings);
    FAIL() << "it must not fly without what was asked for";
  } catch (const std::invalid_argument& fault) {
    EXPECT_NE(std::string(fault.what()).find("parameter clusters = \"drone\" is refused"), std::string::npos);
    EXPECT_NE(std::string(fault.what()).find("TERN_BUILD_TRACKER"), std::string::npos);
  }
}

}  // namespace
