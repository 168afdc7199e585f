// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Pictures that a person can read: no text over another, a legend for all that is drawn, limits told apart, files of a
// bounded size. Scenes that were hard to label, read back from the SVG itself.
#include "host/picture/picture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "host/picture/merged_blocks.hpp"
#include "host/session.hpp"
#include "support/random.hpp"

namespace {

using tern_host::PlanResult;
using tern_host::Rect;

struct Scene {
  const char* name;
  const char* text;
};

const Scene kScenes[] = {
    {"hover", "boundary 0 0 0 6 6 3\nblock 2 2 0 2.5 2.5 3\nstart 4 4 1\ngoal 4 4 1\n"},
    {"close_ends", "boundary 0 0 0 20 20 3\nblock 8 8 0 9 9 3\nstart 5 5 1\ngoal 5.6 5.1 1\n"},
    {"climb", "boundary 0 0 0 4 4 30\nstart 2 2 1\ngoal 2 2 28\n"},
    {"tower",
     "boundary 0 0 0 6 6 30\nblock 2 2 0 3 3 28\nblock 3 2 8 6 6 8.5\nstart 1 1 1\ngoal 4.5 2.2 28\nradius 0.3\n"
     "resolution 0.15\nv_max 2 2 3\nv_min -2 -2 -1\na_max 2 2 3\na_min -2 -2 -2\n"},
    {"fences",
     "boundary 0 0 0 12 8 4\nblock 4 0 0 4.5 5 4\nkeepin 0.3 0.3 0.2 11 7.8 3.5\nkeepout 9 5 0 10 8 2\n"
     "keepout_halfspaces 1 0 0 8 -1 0 0 -7 0 1 0 4 0 -1 0 0 0 0 1 4 0 0 -1 0\nstart 1 1 1\ngoal 10 2 1.5\n"},
    {"moving",
     "boundary 0 0 0 14 8 4\nblock 4 0 0 4.5 5 4\nblock 8 3 0 8.5 8 4\nstart 1 1 1\ngoal 12 6 2\n"
     "start_velocity 1 1 0\nstart_acceleration 0.3 0 0\ngoal_velocity 0.5 0 0\n"},
    {"limits",
     "boundary 0 0 0 16 9 6\nblock 4 0 0 4.5 7 6\nblock 9 3 0 9.5 9 4\nstart 1 1 1\ngoal 14 6 5\nv_max 3 2 1\n"
     "a_max 3 2 1.5\nv_min -3 -2 -0.5\na_min -3 -2 -1\nv_horizontal 3.2\na_horizontal 3\n"},
    {"low_map",
     "boundary -100 0 0 0 50 1.5\nblock -50 0 0 -49 20 1.5\nstart -95 5 0.7\ngoal -5 5 0.7\nresolution 0.25\n"},
    {"vias",
     "boundary 0 0 0 14 8 4\nblock 4 0 0 4.5 5 4\nstart 1 1 1\nvia 4.2 6.5 1\nvia 8 2 2 0.4\nvia 12 3 2 stop\n"
     "goal 12 6 2\n"},
    {"things",
     "boundary 0 0 0 16 10 3\nblock 4 0 0 5 6 3\nstart 1 5 1.5\ngoal 15 5 1.5\nradius 0.3\n"
     "track man cylinder 0.3 1.8 at 7 9 0.9 velocity 0 -1 0\ntrack other ball 0.3 at 7 9 0.9 velocity 0.1 -1 0\n"
     "track late ball 0.3 at 7 9 0.9 from 900\nkeepout 11 3 0 13 7 3 during 0 6 zone Crane <lift>\n"},
    {"closed", "boundary 0 0 0 8 6 3\nkeepout_halfspaces 1 0 0 4 -1 0 0 -3 during 0 9\nstart 1 1 1\ngoal 7 5 2\n"},
    {"no_path", "boundary 0 0 0 8 6 3\nblock 4 0 0 5 6 3\nstart 1 1 1\ngoal 7 5 2\n"},
    {"far_goal", "boundary 0 0 0 8 6 3\nstart 1 1 1\ngoal 70 5 2\nv_max 1 2 3\nv_horizontal 2.5\na_min -1 -1.5 -3\n"},
    {"long_name_0123456789_0123456789_0123456789_0123456789_0123456789_0123456789_0123456789_0123456789",
     "boundary 0 0 0 8 6 3\nstart 1 1 1\ngoal 7 5 2\n"},
};

PlanResult plan(const std::string& name, const std::string& text) {
  static tern_host::Session session;
  return session.plan(tern_host::parse_scenario(text, name + ".txt"));
}

struct Lettering {
  std::string text;
  Rect room;
};

/// Font sizes as the document's own style sheet has them.
std::map<std::string, double> font_sizes(const std::string& svg) {
  std::map<std::string, double> sizes;
  const std::regex rule("\\.([a-z-]+) \\{ font-size: ([0-9]+)px");
  for (std::sregex_iterator it(svg.begin(), svg.end(), rule), end; it != end; ++it) {
    sizes[(*it)[1]] = std::stod((*it)[2]);
  }
  return sizes;
}

std::string attribute(const std::string& attributes, const std::string& name) {
  std::smatch match;
  return std::regex_search(attributes, match, std::regex(" " + name + "=\"([^\"]*)\"")) ? match[1].str() : "";
}

/// Of the font's size: blanks and points are narrower than letters and digits.
double width_of(const std::string& text) {
  double width = 0.0;
  for (const char c : text) {
    if ((static_cast<unsigned char>(c) & 0xC0) == 0x80) continue;  // not a letter's first byte
    width += std::string(" .,:/|-()").find(c) != std::string::npos ? 0.3 : 0.58;
  }
  return width;
}

/// The room of each text: its width, and of its height the part that capitals and digits take.
std::vector<Lettering> texts_of(const std::string& svg) {
  std::map<std::string, double> sizes = font_sizes(svg);
  std::vector<Lettering> found;
  const std::regex element("<text([^>]*)>([^<]*)</text>");
  for (std::sregex_iterator it(svg.begin(), svg.end(), element), end; it != end; ++it) {
    const std::string attributes = (*it)[1];
    const std::string anchor = attribute(attributes, "text-anchor");
    const double size = sizes.at(attribute(attributes, "class"));
    const double x = std::stod(attribute(attributes, "x"));
    const double y = std::stod(attribute(attributes, "y"));
    const std::string text = std::regex_replace((*it)[2].str(), std::regex("&[a-z]+;"), "&");
    const double width = size * width_of(text);
    const double before = anchor == "end" ? width : (anchor == "middle" ? 0.5 * width : 0.0);
    const bool upward = attributes.find("rotate(-90") != std::string::npos;
    const Rect level{x - before, y - 0.73 * size, width, 0.73 * size};
    found.push_back({text, upward ? Rect{x - level.height, y - 0.5 * width, level.height, width} : level});
  }
  return found;
}

bool has(const std::string& svg, const std::string& what) {
  return svg.find(what) != std::string::npos;
}

void expect_readable(const std::string& svg, double width) {
  const std::vector<Lettering> texts = texts_of(svg);
  ASSERT_GE(texts.size(), 3u);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const Rect& r = texts[i].room;
    EXPECT_TRUE(r.x >= 0.0 && r.right() <= width && r.y >= 0.0) << "outside the page: " << texts[i].text;
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_FALSE(r.overlaps(texts[k].room)) << "'" << texts[i].text << "' over '" << texts[k].text << "'";
    }
  }
}

TEST(Picture, NoTextStandsOverAnotherOrOutsideThePage) {
  for (const Scene& scene : kScenes) {
    SCOPED_TRACE(scene.name);
    expect_readable(tern_host::plan_svg(plan(scene.name, scene.text)), 1200.0);
  }
}

TEST(Picture, OverlapsAreSeen) {
  const std::string sheet = "<style>\n.number { font-size: 13px; fill: #5c6675 }\n</style>\n";
  const std::string svg = sheet + "<text x=\"10\" y=\"20\" class=\"number\">shortcut</text>\n" +
                          "<text x=\"100\" y=\"22\" class=\"number\" text-anchor=\"end\">speed  0</text>\n";
  const std::vector<Lettering> texts = texts_of(svg);
  ASSERT_EQ(texts.size(), 2u);
  EXPECT_TRUE(texts[0].room.overlaps(texts[1].room));
}

TEST(Picture, BothEndsAreNamedInBothViews) {
  for (const Scene& scene : kScenes) {
    SCOPED_TRACE(scene.name);
    int starts = 0;
    int goals = 0;
    for (const Lettering& text : texts_of(tern_host::plan_svg(plan(scene.name, scene.text)))) {
      starts += text.text == "start" || text.text == "start, goal";
      goals += text.text == "goal" || text.text == "start, goal" || text.text == "goal, off the map";
    }
    EXPECT_EQ(starts, 2);
    EXPECT_EQ(goals, 2);
  }
}

TEST(ObliquePicture, NoTextStandsOverAnotherAndBothEndsAreNamed) {
  for (const Scene& scene : kScenes) {
    SCOPED_TRACE(scene.name);
    const std::string svg = tern_host::oblique_svg(plan(scene.name, scene.text));
    const std::vector<Lettering> texts = texts_of(svg);
    expect_readable(svg, 1200.0);
    const auto named = [&](const std::string& name) {
      return std::count_if(texts.begin(), texts.end(), [&](const Lettering& text) {
        return text.text == name || text.text == "start, goal" || text.text == name + ", off the map";
      });
    };
    EXPECT_EQ(named("start"), 1);
    EXPECT_EQ(named("goal"), 1);
  }
}

/// Each stands in both views of the page and once in the oblique picture, but for what is not there in time.
TEST(Picture, NamesThingsAndKeepOutsForAWhile) {
  const auto scene = std::find_if(std::begin(kScenes), std::end(kScenes),
                                  [](const Scene& each) { return std::string(each.name) == "things"; });
  const PlanResult result = plan(scene->name, scene->text);
  const std::string oblique = tern_host::oblique_svg(result);
  const std::string page = tern_host::plan_svg(result);
  expect_readable(oblique, 1200.0);
  EXPECT_TRUE(has(page, ">clear of blocks<") && has(page, ">clear of things<"));
  const auto count = [](const std::string& svg, const std::string& name) {
    const std::vector<Lettering> texts = texts_of(svg);
    return std::count_if(texts.begin(), texts.end(), [&](const Lettering& text) { return text.text == name; });
  };
  for (const char* const name : {"man", "other", "keepout 1 (Crane &lift&)"}) {
    EXPECT_EQ(count(page, name), 2) << name;
    EXPECT_EQ(count(oblique, name), 1) << name;
  }
  EXPECT_EQ(count(page, "late") + count(oblique, "late"), 0);
}

/// Classes of what is drawn, and the legend's name for each.
const std::map<std::string, std::string> kLegend = {
    {"block", "obstacle"},
    {"merged-block", "obstacle"},
    {"keepout", "keep-out fence"},
    {"keepin", "keep-in fence"},
    {"inflated", "inflated by the radius"},
    {"corridor", "corridor polyhedra"},
    {"raw", "jump-point path"},
    {"shortcut", "shortcut, waypoints"},
    {"trajectory", "trajectory, speed |v|"},
    {"keepout-for-a-while", "keep-out for a while"},
    {"thing", "what moves, at the start"},
};

const std::map<std::string, std::string> kObliqueLegend = {
    {"block-front", "obstacle"},
    {"keepout", "keep-out fence"},
    {"keepout-front", "keep-out fence"},
    {"keepin", "keep-in fence"},
    {"flight", "trajectory, speed"},
    {"behind", "behind an obstacle"},
    {"shadow", "its shadow"},
    {"robot", "the robot, once a second"},
    {"keepout-for-a-while", "keep-out for a while"},
    {"thing", "what moves, at the start"},
};

void expect_legend(const std::string& svg, const std::map<std::string, std::string>& legend) {
  std::set<std::string> drawn;
  for (const auto& [style, name] : legend) {
    if (has(svg, "class=\"" + style + "\"")) drawn.insert(name);
  }
  for (const auto& [style, name] : legend) EXPECT_EQ(has(svg, ">" + name), drawn.count(name) > 0) << name;
}

TEST(Picture, TheLegendNamesAllThatIsDrawnAndNothingElse) {
  for (const Scene& scene : kScenes) {
    SCOPED_TRACE(scene.name);
    const PlanResult result = plan(scene.name, scene.text);
    expect_legend(tern_host::plan_svg(result), kLegend);
    expect_legend(tern_host::oblique_svg(result), kObliqueLegend);
  }
}

TEST(Picture, EachAxisHasItsLimitsInItsOwnColour) {
  const std::string svg = tern_host::plan_svg(plan("limits", kScenes[6].text));
  for (const char* colour : {"#c8553d", "#2f8f5b", "#2b6cb0", "#7b3fa0"}) {
    EXPECT_TRUE(has(svg, std::string("class=\"limit\" stroke=\"") + colour + "\"")) << colour;
  }
  EXPECT_FALSE(has(svg, "#8b2e2e"));
  // Where the axes share a limit, each has dashes in the others' gaps.
  const std::string shared = tern_host::plan_svg(plan("fences", kScenes[4].text));
  for (const char* offset : {"stroke-dashoffset:0", "stroke-dashoffset:-11", "stroke-dashoffset:-22"}) {
    EXPECT_TRUE(has(shared, offset)) << offset;
  }
}

TEST(Picture, PeaksStandBesideWhatIsLimited) {
  const std::string svg = tern_host::plan_svg(plan("limits", kScenes[6].text));
  EXPECT_TRUE(std::regex_search(svg, std::regex(">x [0-9.]+ of 3\\.00<")));
  EXPECT_TRUE(std::regex_search(svg, std::regex(">z [0-9.]+ of 1\\.00, -?[0-9.]+ of -0\\.50<")));
  EXPECT_TRUE(std::regex_search(svg, std::regex(">horizontal [0-9.]+ of 3\\.20<")));
  EXPECT_TRUE(std::regex_search(svg, std::regex(">\\|v\\| [0-9.]+, no limit<")));
  EXPECT_FALSE(has(svg, "peak |v|"));
}

std::string many_blocks(int count) {
  tern_test::Random random(7);
  std::string text = "boundary 0 0 0 60 60 10\nstart 1 1 9.5\ngoal 58 58 9.5\nresolution 0.5\n";
  for (int i = 0; i < count; ++i) {
    const double x = random.real(0.0, 59.0);
    const double y = random.real(0.0, 59.0);
    const double z = random.real(0.0, 7.0);
    const char* const kind = i % 10 == 0 ? "keepout" : "block";
    text += std::string(kind) + " " + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + " " +
            std::to_string(x + 0.2) + " " + std::to_string(y + 0.2) + " " + std::to_string(z + 0.2) + "\n";
  }
  return text;
}

TEST(Picture, ManyBlocksAreMerged) {
  for (const int count : {900, 5000, tern_test::scaled(100000)}) {
    const PlanResult result = plan("many", many_blocks(count));
    const std::string svg = tern_host::plan_svg(result);
    EXPECT_LT(svg.size(), 1500000u) << count;
    EXPECT_LT(tern_host::oblique_svg(result).size(), 500000u) << count;
    EXPECT_TRUE(has(svg, count > 1000 ? "class=\"merged-block\"" : "class=\"block\"")) << count;
    expect_readable(svg, 1200.0);
  }
}

TEST(MergedBlocks, CoverWhatTheRectanglesCover) {
  tern_host::MergedBlocks raster({100.0, 50.0, 40.0, 20.0});  // cells of 2 pixels
  raster.add({104.0, 54.0, 8.0, 4.0}, 1.0);
  raster.add({108.0, 54.0, 8.0, 4.0}, 1.0);
  raster.add({0.0, 0.0, 10.0, 10.0}, 1.0);  // outside
  tern_host::Canvas canvas;
  raster.draw(canvas, "class=\"merged-block\"", 0.5, 0.0, 1.0);
  EXPECT_TRUE(has(canvas.body(), "opacity=\"1.00\" d=\"M2 2h6v2h-6z\"")) << canvas.body();
}

TEST(MergedBlocks, PartlyCoveredCellsAreFainter) {
  tern_host::MergedBlocks raster({0.0, 0.0, 40.0, 20.0});
  raster.add({2.0, 2.0, 1.0, 2.0}, 0.5);  // half of a cell, half of the depth
  tern_host::Canvas canvas;
  raster.draw(canvas, "class=\"merged-block\"", 0.0001, 0.0, 0.6);
  EXPECT_TRUE(has(canvas.body(), "opacity=\"0.20\" d=\"M1 1h1v1h-1z\"")) << canvas.body();
}

}  // namespace
