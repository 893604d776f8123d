#include "tab.hpp"

#include <exception>
#include <utility>

#include "limber/common/interrupt.hpp"

namespace limber {

namespace {

std::uint64_t request_of(const Job& job) {
  return std::visit([](const auto& one) { return one.request; }, job);
}

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
  {
    const std::lock_guard lock(mutex_);
    if (std::holds_alternative<PlanJob>(job)) {
      found_.reset();  // of another scene: nothing may run it any more
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
    {
      const std::lock_guard lock(mutex_);
      found_.reset();
    }
    run_plan_job(*plan, scene(plan->scene), stop_job_, events_, [this](FoundPlan found) {
      const std::lock_guard lock(mutex_);
      if (!next_) {  // else it answers a question that nobody asks any more
        found_ = std::move(found);
      }
    });
  } else if (const auto* drive = std::get_if<DriveJob>(&job)) {
    run_drive_job(*drive, scene(drive->scene), target_, stop_job_, events_);
  } else if (const std::optional<FoundPlan> plan_found = found()) {
    run_run_job(std::get<RunJob>(job), scene(plan_found->scene), *plan_found, stop_job_, events_);
  }
}

const StudioScene& Tab::scene(const SceneNames& names) {
  if (!scene_ || !scene_->is_current(names)) {
    scene_.reset();
    scene_ = std::make_unique<const StudioScene>(project_, names);
  }
  return *scene_;
}

}  // namespace limber
