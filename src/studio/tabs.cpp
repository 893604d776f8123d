#include "tabs.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <exception>
#include <utility>

#include "limber/common/interrupt.hpp"
#include "request_rules.hpp"

namespace limber {

namespace {

std::uint64_t request_of(const Job& job) {
  return std::visit([](const auto& one) { return one.request; }, job);
}

/// This thread alone: the browser on the same machine paints first. An arm behind a driver has a
/// thread of its own.
void give_way() {
  constexpr int kNice = 10;
  setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kNice);  // where it is refused, it is late
}

constexpr std::chrono::milliseconds kEventWait{200};  // how soon a closed page is noticed

}  // namespace

Tab::Tab(const ProjectFolder& project) : project_(project), worker_([this] { work(); }) {}

Tab::~Tab() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
    stop_job_ = true;
  }
  has_job_.notify_one();
  worker_.join();
}

void Tab::post(Job job) {
  std::optional<FoundPlan> gone;  // without the lock, which an arm's frames may wait for
  {
    const std::lock_guard lock(mutex_);
    if (std::holds_alternative<PlanJob>(job)) {
      gone.swap(found_);  // of another scene: nothing may run it any more
    }
    next_ = std::move(job);
    stop_job_ = true;
  }
  has_job_.notify_one();
}

void Tab::stop() {
  const std::lock_guard lock(mutex_);
  next_.reset();
  stop_job_ = true;
}

std::optional<FoundPlan> Tab::found() const {
  const std::lock_guard lock(mutex_);
  return found_;
}

void Tab::work() {
  give_way();
  const StopScope scope(&stop_job_);  // a search looks at it often
  while (true) {
    std::optional<Job> job;
    {
      std::unique_lock lock(mutex_);
      has_job_.wait(lock, [this] { return ending_ || next_; });
      if (ending_) {
        return;
      }
      job = std::exchange(next_, std::nullopt);
      stop_job_ = false;
    }
    try {
      run(*job);
    } catch (const std::exception& error) {
      if (!stop_job_) {
        events_.push("fault",
                     nlohmann::json{{"request", request_of(*job)}, {"message", error.what()}}.dump(
                         -1, ' ', false, nlohmann::json::error_handler_t::replace));
      }
    }
  }
}

void Tab::run(const Job& job) {
  if (const auto* plan = std::get_if<PlanJob>(&job)) {
    run_plan_job(*plan, scene(plan->scene), stop_job_, events_,
                 [this](FoundPlan found) { keep(std::move(found)); });
  } else if (const auto* open = std::get_if<OpenJob>(&job)) {
    const auto scene_of = [this](const SceneNames& names) -> const StudioScene& {
      return scene(names);
    };
    run_open_job(*open, project_, scene_of, events_,
                 [this](FoundPlan found) { keep(std::move(found)); });
  } else if (const auto* drive = std::get_if<DriveJob>(&job)) {
    run_drive_job(*drive, scene(drive->scene), target_, stop_job_, events_);
  } else if (const auto* follow = std::get_if<FollowJob>(&job)) {
    run_follow_job(*follow, scene(follow->scene), stop_job_, events_);
  } else if (const auto* measure = std::get_if<MeasureJob>(&job)) {
    run_measure_job(*measure, project_, scene(measure->scene), stop_job_, events_);
  } else if (const auto* fit = std::get_if<FitJob>(&job)) {
    run_fit_job(*fit, project_, scene(fit->scene), stop_job_, events_);
  } else if (const std::optional<FoundPlan> plan_found = found()) {
    run_run_job(std::get<RunJob>(job), scene(plan_found->scene), *plan_found, stop_job_, events_);
  }
}

void Tab::keep(FoundPlan found) {
  std::optional<FoundPlan> other(std::move(found));  // goes without the lock
  const std::lock_guard lock(mutex_);
  if (!next_) {  // else it answers a question that nobody asks any more
    other.swap(found_);
  }
}

const StudioScene& Tab::scene(const SceneNames& names) {
  if (!scene_ || !scene_->is_current(names)) {
    scene_.reset();
    scene_ = std::make_unique<const StudioScene>(project_, names);
  }
  return *scene_;
}

std::string why_not_shown(const std::optional<FoundPlan>& found, const JsonReader& body) {
  if (!found) {
    return "there is no certified plan";
  }
  return body.has("plan") && body.at("plan").count(kMaxRequest) != found->request
             ? "the studio has another plan than this page shows: plan again, or open it again"
             : "";
}

std::string Tabs::open() {
  const std::lock_guard lock(mutex_);
  if (tabs_.size() >= kMax) {
    return "";
  }
  const std::string id = make_token();
  auto tab = std::make_unique<Tab>(project_);
  tab->events().push("tab", nlohmann::json{{"id", id}}.dump());
  const std::lock_guard events_lock(events_mutex_);
  events_[id] = &tab->events();
  tabs_[id] = std::move(tab);
  return id;
}

void Tabs::close(const std::string& id) {
  decltype(tabs_)::node_type closed;  // joins its thread without the lock
  const std::lock_guard lock(mutex_);
  {
    const std::lock_guard events_lock(events_mutex_);
    events_.erase(id);
  }
  closed = tabs_.extract(id);
}

void Tabs::send_to_all(const std::string& kind, const std::string& json) {
  const std::lock_guard lock(events_mutex_);
  for (const auto& [id, events] : events_) {
    events->push(kind, json);
  }
}

/// Only its own stream closes a tab, so that it outlives this call.
std::string Tabs::pop_event(const std::string& id) {
  EventQueue* events = nullptr;
  with(id, [&](Tab& tab) { events = &tab.events(); });
  return events == nullptr ? "" : events->pop(kEventWait);
}

}  // namespace limber
