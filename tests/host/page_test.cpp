// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/page/page.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "host/page/page_parts.hpp"
#include "host/page/run_json.hpp"

namespace {

using Json = nlohmann::json;

/// A wall in the middle of a small room.
tern_host::Scenario small_room() {
  return tern_host::parse_scenario(
      "boundary 0 0 0 6 4 2\nstart 1 1 1\ngoal 5 1 1\nradius 0.2\nv_max 2\na_max 3\nblock 2.5 0 0 3 3 2\n", "room.txt");
}

TEST(Page, RunHasThePlanAtEachStep) {
  const tern_host::PlanResult result = tern_host::Session().plan(small_room());
  ASSERT_TRUE(result.ok());
  const Json run = Json::parse(tern_host::plan_run(result));
  const Json& motion = run.at("motion");
  const Json& columns = motion.at("columns");
  const double step = motion.at("step").get<double>();
  const std::size_t rows = columns.at("px").size();
  EXPECT_NEAR(step * static_cast<double>(rows - 1), tern::duration(result.trajectory), 1e-9);
  EXPECT_LE(step, 0.02);
  for (const std::size_t i : {std::size_t{0}, rows / 3, rows - 1}) {
    const tern::Sample sample = tern::evaluate(result.trajectory, step * static_cast<double>(i));
    EXPECT_NEAR(columns.at("px")[i].get<double>(), sample.position.x, 5.1e-4);
    EXPECT_NEAR(columns.at("vy")[i].get<double>(), sample.velocity.y, 5.1e-4);
    EXPECT_NEAR(columns.at("az")[i].get<double>(), sample.acceleration.z, 5.1e-4);
  }
  // The start is 1.5 m from the wall.
  EXPECT_DOUBLE_EQ(columns.at("clearance")[0].get<double>(), 1.5);
  EXPECT_EQ(run.at("boxes"), Json({2.5, 0.0, 0.0, 3.0, 3.0, 2.0}));
  EXPECT_DOUBLE_EQ(run.at("limits").at("v").get<double>(), 2.0);
  EXPECT_TRUE(run.at("limits").at("j").is_null());
  EXPECT_EQ(run.at("corridor").size(), static_cast<std::size_t>(result.corridor->count));
}

TEST(Page, RunWithoutAPlanHasNoMotion) {
  tern_host::Scenario room = small_room();
  room.goal.position = {2.7, 1.0, 1.0};
  const Json run = Json::parse(tern_host::plan_run(tern_host::Session().plan(room)));
  EXPECT_FALSE(run.contains("motion"));
  EXPECT_EQ(run.at("facts")[0], Json({"status", "goal_occupied"}));
}

TEST(Page, RunsComeBackFromThePage) {
  if (!tern_host::has_three()) GTEST_SKIP() << "this build has no three.js";
  const std::vector<std::string> runs{"{\"name\":\"</script><!-- <script>\"}", "{\"name\":\"b\"}"};
  const std::string html = tern_host::page_html(runs);
  EXPECT_EQ(html.find("</script><!--"), std::string::npos);
  EXPECT_EQ(tern_host::runs_of_page(html, "a page"), runs);
}

TEST(Page, RefusesTooFewAndTooManyRuns) {
  if (!tern_host::has_three()) GTEST_SKIP() << "this build has no three.js";
  EXPECT_THROW(tern_host::check_page(0), std::runtime_error);
  EXPECT_NO_THROW(tern_host::check_page(tern_host::kMaxRuns));
  EXPECT_THROW(tern_host::check_page(tern_host::kMaxRuns + 1), std::runtime_error);
}

TEST(Page, RefusesOtherFiles) {
  EXPECT_THROW(tern_host::runs_of_page("", "empty"), std::runtime_error);
  const std::string opening = "<script type=\"application/json\" id=\"data\">";
  EXPECT_THROW(tern_host::runs_of_page(opening + "{\"format\":", "cut off"), std::runtime_error);
  EXPECT_THROW(tern_host::runs_of_page(opening + "{\"format\":\"tern-page/2\"}</script>", "newer"), std::runtime_error);
}

TEST(Page, NumbersAreRounded) {
  EXPECT_EQ(tern_host::rounded(1.23456).dump(), "1.235");
  EXPECT_EQ(tern_host::rounded(-0.0001).dump(), "0.0");
  EXPECT_TRUE(tern_host::rounded(std::numeric_limits<double>::infinity()).is_null());
  // x <= 1 in a frame that lies at (2, 0, 0) is x <= 3 in the world.
  EXPECT_EQ(tern_host::halfspace_json({{1.0, 0.0, 0.0}, 1.0}, {2.0, 0.0, 0.0}).dump(), "[1.0,0.0,0.0,3.0]");
}

}  // namespace
