#pragma once
// For those who show results.

#include <string>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/planning/planner.hpp"
#include "limber/plot/svg_drawing.hpp"
#include "limber/world/environment.hpp"
#include "limber/world/plan.hpp"

namespace limber {

/// The part of the world that an arm and an environment take up, with space around it.
WorldBox picture_box(const ArmDescription& arm, const Environment& environment);

/// Obstacles, and the goal as a star in its tolerance circle; an arrow shows a wanted heading.
void draw_environment(SvgDrawing& drawing, const Environment& environment);

/// A backbone with the thickness that collisions are checked with.
void draw_arm(SvgDrawing& drawing, const ArmDescription& arm, const Backbone& backbone,
              const ShapeStyle& style);

/// Of what "no_load" and "network" predict, in all pictures.
std::string model_color(const std::string& model);

/// The backbone's points.
std::vector<WorldPoint> center_line(const Backbone& backbone);

void draw_tip_path(SvgDrawing& drawing, const Plan& plan, const ShapeStyle& style);

/// Tips of a search tree, an edge from each node's parent.
void draw_tree(SvgDrawing& drawing, const std::vector<TreeEdge>& tree);

/// The arm along a plan, early shapes faint, the last one in full colour, with the path of its tip.
void draw_plan(SvgDrawing& drawing, const ArmDescription& arm, const Plan& plan);

/// The environment with the arm at its start, as an SVG file's text.
std::string environment_picture(const ArmDescription& arm, const Environment& environment);

/// All of it as the text of an SVG file: environment, tree and plan (or, if there is no plan, the
/// nearest motion, drawn dashed).
std::string plan_picture(const ArmDescription& arm, const Environment& environment,
                         const PlanResult& result);

/// Set points and the pressures predicted from them over time, in one chart for all segments, as
/// the text of an SVG file.
std::string pressure_picture(const ArmDescription& arm, const Plan& plan);

/// A plan as its model predicts it: the page that the studio saves too, one file which loads
/// nothing else, with play, pause, a slider over time, and charts.
std::string plan_animation(const ArmDescription& arm, const Environment& environment,
                           const Plan& plan);

}  // namespace limber
