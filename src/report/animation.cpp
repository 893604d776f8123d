#include "animation.hpp"

#include <cmath>
#include <cstdint>
#include <map>

#include <fmt/format.h>

#include "limber/common/json.hpp"
#include "limber/common/units.hpp"
#include "limber/plot/svg_text.hpp"
#include "limber/report/motion_track.hpp"
#include "limber/report/page_bytes.hpp"
#include "limber/report/plan_picture.hpp"
#include "limber/report/scene_json.hpp"

namespace limber {

namespace {

// As web/src/animation_data.ts has them: m, m, rad, below a pixel; and kPa.
const std::vector<double> kShapeUnits = {1e-4, 1e-4, 1e-3};
const std::vector<double> kPressureUnits = {0.01};

std::string outcomes(const Json& tracks) {
  std::string items;
  for (const Json& track : tracks) {
    const auto key = track["key"].get<std::string>();
    const char* name = key == "simple" ? "Simple model" : key == "network" ? "Network" : "The arm";
    items += fmt::format("<li>{}: {}</li>", name, escape_xml(track["outcome"].get<std::string>()));
  }
  return items;
}

std::string with_all(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

/// The template with each @NAME@ once replaced by its part, which may hold such names itself.
std::string filled(std::string_view page, const std::map<std::string_view, std::string>& parts) {
  std::string text;
  for (std::size_t open = page.find('@'); open != page.npos; open = page.find('@')) {
    text += page.substr(0, open);
    page.remove_prefix(open + 1);
    const std::size_t close = page.find('@');
    const auto part = close == page.npos ? parts.end() : parts.find(page.substr(0, close));
    text += part == parts.end() ? "@" : part->second;
    page.remove_prefix(part == parts.end() ? 0 : close + 1);
  }
  text += page;
  return text;
}

}  // namespace

std::string cost_text(const Plan& plan) {
  return plan.command.is_pressure_kpa()
             ? fmt::format("{:.1f} psi", plan.cost_kpa / kKpaPerPsi)
             : fmt::format("{:.2f} {}", plan.cost_kpa, plan.command.unit);
}

std::string packed_frames(const Json& frames, const std::vector<double>& units) {
  static constexpr const char* kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  constexpr std::uint64_t kBase = 32;  // a digit's sixth bit says that another follows
  std::string text;
  std::vector<std::int64_t> last;
  for (const Json& frame : frames) {
    last.resize(frame.size());
    for (std::size_t i = 0; i < frame.size(); ++i) {
      const auto whole = std::llround(frame[i].get<double>() / units[i % units.size()]);
      const std::int64_t change = whole - last[i];
      std::uint64_t left = change < 0 ? std::uint64_t(-2 * change + 1) : std::uint64_t(2 * change);
      do {
        text += kDigits[left % kBase + (left >= kBase ? kBase : 0)];
        left /= kBase;
      } while (left > 0);
      last[i] = whole;
    }
  }
  return text;
}

std::string scripted_page(const std::string& script, const std::string& title,
                          const std::string& still, const std::string& items, const Json& data) {
  const auto& files = page_bytes();
  return filled(files.at("/animation.html"),
                {{"TITLE", escape_xml(title)},
                 {"STYLE", std::string(files.at("/assets/studio.css"))},
                 {"STILL", still},
                 {"ENDS", items},
                 {"DATA", with_all(data.dump(), "<", "\\u003c")},
                 {"SCRIPT", with_all(std::string(files.at(script)), "</script", "<\\/script")}});
}

std::string animation_page(const ArmDescription& arm, const Environment& environment,
                           const std::string& title, Json motion, const std::string& still) {
  Json data = {{"title", title},
               {"unit", arm.command.unit},
               {"arm", arm_to_json(arm)},
               {"environment", environment_to_json(environment)}};
  data["arm"]["reach"] = {{"cell_m", 1}, {"middles_m", Json::array()}};
  motion["setpoints_kpa"] = packed_frames(motion["setpoints_kpa"], kPressureUnits);
  for (Json& track : motion["tracks"]) {
    track["shapes"] = packed_frames(track["shapes"], kShapeUnits);
    track["pressures_kpa"] = packed_frames(track["pressures_kpa"], kPressureUnits);
  }
  data.update(motion);
  return scripted_page("/assets/animation.js", title, still, outcomes(motion["tracks"]), data);
}

std::string plan_animation(const ArmDescription& arm, const Environment& environment,
                           const Plan& plan) {
  const std::string title =
      fmt::format("{}: {} model, {}", environment.name,
                  plan.model == "network" ? "network" : "no-load", cost_text(plan));
  SvgDrawing still(picture_box(arm, environment), kPictureWidthPx, title);
  still.axes();
  draw_environment(still, environment);
  draw_plan(still, arm, plan);
  Json motion = {{"frame_rate_hz", plan.frame_rate_hz},
                 {"appeared", nullptr},
                 {"setpoints_kpa", setpoints_to_json(plan)},
                 {"tracks", {predicted_track(arm, environment, plan).json()}}};
  return animation_page(arm, environment, title, std::move(motion), still.svg());
}

}  // namespace limber
