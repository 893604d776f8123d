#include "arm_requests.hpp"

#include "answers.hpp"

namespace limber {

namespace {

using httplib::Response;

void require(bool done, Response& response) {
  require_done(done ? "" : "this page has not armed the arm, or not any more", response);
}

void arm(ArmStation& station, const JsonReader& body, Response& response) {
  if (!body.at("confirmed").boolean()) {
    refuse(response, kBadRequest, "confirmed: expected true: arming is deliberate");
  } else if (const std::string lease = station.arm(); lease.empty()) {
    refuse(response, kConflict, "another page has armed the arm");
  } else {
    answer(response, {{"lease", lease}});
  }
}

void run(ArmStation& station, Tabs& tabs, const JsonReader& body, Response& response) {
  ArmRunJob job;
  job.limit_scale = body.at("limit_scale").number(kMinLimitScale, 1.0);
  job.replan = body.at("replan").boolean();
  job.drop_obstacle = body.at("obstacle").boolean();
  std::optional<FoundPlan> found;
  tabs.with(body.at("tab").text(), [&](Tab& tab) { found = tab.found(); });
  std::string why_not = why_not_shown(found, body);
  if (why_not.empty()) {
    job.found = *std::move(found);
    why_not = station.run(body.at("lease").text(), std::move(job));
  }
  require_done(why_not, response);
}

}  // namespace

void add_arm_requests(
    ArmStation* station, Tabs& tabs,
    const std::function<void(const char*, std::function<void(const JsonReader&, Response&)>)>&
        post) {
  if (station == nullptr) {
    return;
  }
  ArmStation& own = *station;
  post("/api/arm/vent", [&own](const JsonReader&, Response&) { own.vent(); });
  post("/api/arm/lease", [&own](const JsonReader& body, Response& response) {
    require(own.renew(body.at("lease").text()), response);
  });
  post("/api/arm/arm",
       [&own](const JsonReader& body, Response& response) { arm(own, body, response); });
  post("/api/arm/run", [&own, &tabs](const JsonReader& body, Response& response) {
    run(own, tabs, body, response);
  });
  post("/api/arm/pause", [&own](const JsonReader& body, Response& response) {
    require_done(own.pause(body.at("lease").text(), body.at("paused").boolean()), response);
  });
  post("/api/arm/stop", [&own](const JsonReader& body, Response& response) {
    require(own.stop(body.at("lease").text()), response);
  });
  post("/api/arm/disarm", [&own](const JsonReader& body, Response& response) {
    require(own.disarm(body.at("lease").text()), response);
  });
}

}  // namespace limber
