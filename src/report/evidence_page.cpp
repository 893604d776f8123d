#include "limber/report/evidence_page.hpp"

#include <cstdint>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/report/report_page.hpp"

namespace limber {

namespace {

using Json = nlohmann::ordered_json;

std::string percent(const Json& share) {
  return fmt::format("{:.2f} %", 100.0 * share.get<double>());
}

std::vector<std::string> row_of(const Json& phase) {
  const bool has_tube = phase.contains("coverage");
  const double environments = phase["environments"].get<double>();
  return {phase["phase"].get<std::string>(),
          has_tube ? fmt::format("{:.3f}", phase["factor"].get<double>()) : "–",
          fmt::format("{}", phase["runs"].get<int>()),
          has_tube
              ? fmt::format("{} ({}–{})", percent(phase["coverage"]["share"]),
                            percent(phase["coverage"]["low"]), percent(phase["coverage"]["high"]))
              : "–",
          fmt::format("{:.1f} %", 100.0 * phase["solved"].get<double>() / environments),
          fmt::format("{:.0f}", phase["cost"].get<double>()),
          fmt::format("{:.2f} cm", phase["mean_largest_tip_error_cm"].get<double>()),
          fmt::format("{}", phase["collided"].get<int>()),
          fmt::format("{}", phase["reached"].get<int>())};
}

void add_levels(const Json& tube, ReportPage& page) {
  ReportTable table{
      "Levels", {"level", "factor", "tip", "end", "end, heading", "tested", "audit"}, {}};
  for (const Json& level : tube["levels"]) {
    table.rows.push_back(
        {percent(level["level"]), fmt::format("{:.3f}", level["factor"].get<double>()),
         fmt::format("{:.2f} cm", level["tip_radius_cm"].get<double>()),
         fmt::format("{:.2f} cm", level["end_radius_cm"].get<double>()),
         fmt::format("{:.3f} rad", level["end_heading_rad"].get<double>()),
         fmt::format("{} of {} outside", level["outside"].get<int>(), level["runs"].get<int>()),
         fmt::format("{} of {} outside", level["audit_outside"].get<int>(),
                     level["audit_runs"].get<int>())});
  }
  page.heading("Tube").table(table);
}

}  // namespace

std::string evidence_page(const Json& evidence) {
  ReportPage page(
      "limber calibrate",
      fmt::format("arm {}, seed {}, confidence {}", evidence["arm"]["name"].get<std::string>(),
                  evidence["seed"].get<std::uint64_t>(), percent(evidence["confidence"])));
  page.paragraph(
      "How far the arm was from the predicted one, over whole motions, in random environments that "
      "no two phases share. Every phase with a factor planned with that tube. What is promised and "
      "what is not: docs/tube.md.");
  for (const Json& failure : evidence["failures"]) {
    page.remark(failure.get<std::string>());
  }
  if (evidence.contains("tube")) {
    add_levels(evidence["tube"], page);
  }
  ReportTable table{"Phases, in their order; coverage with its 95 % interval",
                    {"phase", "factor", "runs", "coverage", "solved", "cost",
                     "largest tip error, mean", "collided", "reached"},
                    {}};
  for (const Json& phase : evidence["phases"]) {
    table.rows.push_back(row_of(phase));
  }
  page.heading("Evidence").table(table);
  return page.html();
}

}  // namespace limber
