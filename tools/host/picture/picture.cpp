// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/picture/picture.hpp"

#include "host/figures.hpp"
#include "host/picture/colours.hpp"
#include "host/picture/header.hpp"
#include "host/picture/heading_view.hpp"
#include "host/picture/layout.hpp"
#include "host/picture/profile_view.hpp"

namespace tern_host {
namespace {

void draw_panel(Canvas& canvas, const PlanResult& result, const Projection& projection, const Rect& frame,
                const std::string& title, double speed_scale) {
  const Axes axes{frame, view_range(result, projection.horizontal), view_range(result, projection.vertical),
                  projection.down};
  canvas.text({frame.x, frame.y - 12.0}, title, "class=\"heading\"");
  draw_map_view(canvas, axes, projection, result, speed_scale);
}

}  // namespace

std::string plan_svg(const PlanResult& result) {
  const Figures figures = result.ok() ? measure(result.trajectory, result.scenario) : Figures{};
  Canvas page;
  const PageLayout layout = lay_out_page(result, draw_header(page, result, figures));
  if (result.ok()) {
    draw_profile(page, layout.velocity_frame, Profile::kVelocity, result, figures);
    draw_profile(page, layout.acceleration_frame, Profile::kAcceleration, result, figures);
  }
  if (result.yaw != nullptr) {
    draw_heading_profile(page, layout.yaw_frame, result);
    draw_turning_profile(page, layout.turning_frame, result);
  }
  // After the profiles, whose text the names of start and goal keep off.
  draw_panel(page, result, layout.top, layout.top_frame, "Top view", speed_scale(figures));
  draw_panel(page, result, layout.side, layout.side_frame, "Side view", speed_scale(figures));
  Canvas canvas;
  canvas.rect({0.0, 0.0, kPageWidth, layout.height}, "fill=\"#ffffff\"");
  canvas.raw(page.body());
  return canvas.document(kPageWidth, layout.height, style_sheet());
}

}  // namespace tern_host
