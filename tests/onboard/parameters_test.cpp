// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tern_onboard/parameters.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

#include "tern_onboard/onboard.hpp"

namespace {

using tern_onboard::set_parameter;
using tern_onboard::set_parameter_text;
using tern_onboard::Settings;

TEST(OnboardParameters, StandInThePage) {
  std::ifstream page(TERN_SOURCE_DIR "/port/onboard/README.md");
  std::stringstream text;
  text << page.rdbuf();
  EXPECT_NE(text.str().find(tern_onboard::parameter_table()), std::string::npos)
      << "port/onboard/README.md must have this table:\n"
      << tern_onboard::parameter_table();
}

TEST(OnboardParameters, TakeBothEndsOfTheirRangeAndNothingBeyond) {
  for (const auto& row : tern_onboard::parameters()) {
    Settings settings;
    for (const double good : {row.least, row.most, row.get(settings)}) {
      EXPECT_EQ(set_parameter(settings, row.name, good), "") << row.name;
      EXPECT_EQ(row.get(settings), good) << row.name;
    }
    const double before = row.get(settings);
    for (const double bad : {row.least - 1.0, row.most + 1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
      const std::string fault = set_parameter(settings, row.name, bad);
      EXPECT_EQ(fault.find("parameter " + std::string(row.name) + " = "), 0u) << fault;
      EXPECT_NE(fault.find("allowed are "), std::string::npos) << fault;
      EXPECT_EQ(row.get(settings), before) << row.name;
    }
    if (row.whole) {
      EXPECT_NE(set_parameter(settings, row.name, row.least + 0.5), "") << row.name;
    }
  }
}

TEST(OnboardParameters, NameWhatIsWrong) {
  Settings settings;
  EXPECT_EQ(set_parameter(settings, "cell", -1.0),
            "parameter cell = -1 m is refused: allowed are from 0.02 to 2 m. It is: edge of a voxel");
  EXPECT_EQ(set_parameter(settings, "sell", 1.0), "there is no parameter sell");
  EXPECT_EQ(set_parameter_text(settings, "cell", "0.1x"), "parameter cell = \"0.1x\" is refused: it is no number");
  EXPECT_EQ(set_parameter_text(settings, "cell", ""), "parameter cell = \"\" is refused: it is no number");
  EXPECT_EQ(set_parameter_text(settings, "yaw", "north"),
            "parameter yaw = \"north\" is refused: allowed are unseen, motion, point and heading");
  EXPECT_EQ(set_parameter_text(settings, "yaw", "motion"), "");
  EXPECT_EQ(settings.fly.yaw, "motion");
  tern_onboard::SensorSettings sensor;
  EXPECT_EQ(set_parameter(sensor, "least", -1.0, "front."),
            "parameter front.least = -1 m is refused: allowed are from 0 to 50 m. It is: depths below it are no "
            "measurement");
}

/// What making an Onboard says of these settings.
std::string said_of(const Settings& settings) {
  try {
    const tern_onboard::Onboard onboard(settings);
  } catch (const std::invalid_argument& fault) {
    return fault.what();
  }
  return "";
}

TEST(OnboardParameters, MustFitTogether) {
  EXPECT_EQ(said_of({}), "");
  const auto with = [](const char* name, double value) {
    Settings settings;
    EXPECT_EQ(set_parameter(settings, name, value), "");
    return said_of(settings);
  };
  EXPECT_EQ(with("horizon", 30.0).find("parameter horizon = 30 m is refused: it must be less than half"), 0u);
  EXPECT_EQ(with("free_radius", 0.5).find("parameter free_radius = 0.5 m is refused: it must be at least 1.05 m"), 0u);
  EXPECT_EQ(with("ceiling", -998.0), "");
  EXPECT_EQ(with("stray", 0.2).find("parameter stray = 0.2 m is refused: it must be above tracking_margin"), 0u);
  EXPECT_EQ(with("ground", 2000.0).find("parameter ceiling = 1000 m is refused: it must be at least 2000.65 m"), 0u);
  EXPECT_EQ(with("window_z", 1.0).find("parameter window_z = 1 m is refused: it must be at least 2.1 m"), 0u);
  // What only the core can judge.
  const std::string many = with("cell", 0.02);
  EXPECT_EQ(many.find("the parameters make no flight: "), 0u) << many;
}

}  // namespace
