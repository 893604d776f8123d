#include "arm_station.hpp"

#include <exception>
#include <utility>

#include <fmt/format.h>

#include "limber/common/filesystem.hpp"
#include "limber/common/json.hpp"
#include "limber/driver/driver_run.hpp"
#include "request_rules.hpp"

namespace limber {

namespace {

constexpr std::chrono::milliseconds kLook{50};  // how soon a lease that has run out is noticed

std::string line_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

ArmStation::ArmStation(const ProjectFolder& project, std::string arm, ProcessDriverSettings driver,
                       Send send)
    : project_(project),
      arm_(std::move(arm)),
      driver_(std::move(driver)),
      send_(std::move(send)),
      worker_([this] { work(); }) {}

ArmStation::~ArmStation() {
  control_.vent();
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  has_work_.notify_one();
  worker_.join();
}

std::string ArmStation::arm() {
  std::string lease;
  {
    const std::lock_guard lock(mutex_);
    if (!lease_.empty() || running_) {
      return "";
    }
    lease = lease_ = make_token();
    message_.clear();
    control_.begin();
  }
  tell();
  return lease;
}

bool ArmStation::has_lease(const std::string& lease) const {
  return !lease_.empty() && is_same_secret(lease, lease_) && !control_.must_disarm();
}

bool ArmStation::with_lease(const std::string& lease, const std::function<void()>& act) {
  const std::lock_guard lock(mutex_);
  const bool has = has_lease(lease);
  if (has) {
    act();
  }
  return has;
}

bool ArmStation::renew(const std::string& lease) {
  return with_lease(lease, [this] { control_.renew(); });
}

std::string ArmStation::run(const std::string& lease, ArmRunJob job) {
  {
    const std::lock_guard lock(mutex_);
    if (!has_lease(lease)) {
      return "arm the arm first";
    }
    if (running_) {
      return "the arm is moving";
    }
    if (job.found.scene.arm != arm_) {
      return "the driver is that of another arm: " + arm_;
    }
    if (job.limit_scale > driver_.limit_scale) {
      return fmt::format("limits of {:g}: the studio was started with --limit-scale {:g}",
                         job.limit_scale, driver_.limit_scale);
    }
    control_.clear_stop();
    message_.clear();
    running_ = true;
    next_ = std::move(job);
  }
  has_work_.notify_one();
  tell();
  return "";
}

std::string ArmStation::pause(const std::string& lease, bool on) {
  const std::lock_guard lock(mutex_);
  if (!has_lease(lease)) {
    return "arm the arm first";
  }
  if (on && control_.is_unheld()) {
    return "a simulated arm keeps no frames and is not held; Stop vents it";
  }
  control_.pause(on);
  return "";
}

bool ArmStation::stop(const std::string& lease) {
  return with_lease(lease, [this] { control_.stop(); });
}

bool ArmStation::disarm(const std::string& lease) {
  {
    const std::lock_guard lock(mutex_);
    if (!has_lease(lease) || running_) {
      return false;
    }
    lease_.clear();
  }
  tell();
  return true;
}

void ArmStation::vent() {
  control_.vent();
  has_work_.notify_one();
}

std::string ArmStation::status() const {
  const std::lock_guard lock(mutex_);
  return line_of({{"state", running_         ? "running"
                            : lease_.empty() ? "off"
                                             : "armed"},
                  {"message", message_},
                  {"recording", recording_}});
}

void ArmStation::work() {
  while (true) {
    std::optional<ArmRunJob> job;
    bool is_news = false;
    {
      std::unique_lock lock(mutex_);
      has_work_.wait_for(lock, kLook, [this] { return ending_ || next_; });
      if (ending_) {
        return;
      }
      job = std::exchange(next_, std::nullopt);
      if (!lease_.empty() && control_.must_disarm()) {
        message_ = control_.why_vented() + ". No run was going on" +
                   (message_.empty() ? "" : "; what became of the last one: " + message_);
        lease_.clear();
        job.reset();
        running_ = false;
        is_news = true;
      }
    }
    if (job) {
      run_now(*job);
    }
    if (is_news) {
      tell();
    }
  }
}

void ArmStation::run_now(const ArmRunJob& job) {
  fs::path file;
  std::string message;
  std::string said;  // by the driver of its vents
  Json run;
  try {
    file = free_name((project_.folder() / "runs" / time_stamped_run_name()).string(), "_", ".h5");
    fs::create_directories(file.parent_path());
    const StudioScene scene(project_, job.found.scene);
    scene.require_model(job.found.plan.model_hash);
    ProcessDriverSettings driver = driver_;
    // As the arm file has it now: pages read the arm anew too.
    driver.safety = load_safety(project_.find(ProjectItem::arm, arm_));
    driver.say = [this, &said](const std::string& words) {
      said += (said.empty() ? "" : "; ") + words;
      note(words);
    };
    const auto on_frame = [this](const Json& frame) { send_("arm_frame", frame.dump()); };
    ArmRunReport report = run_on_arm(job, scene, std::move(driver), file, control_, on_frame);
    message = std::move(report.message);
    run = std::move(report.run);
  } catch (const std::exception& error) {
    message = error.what();
  }
  if (message.find(said) == std::string::npos) {  // an error, or words after the run's end
    message += (message.empty() ? "" : "; ") + said;
  }
  std::error_code ignored;
  const bool is_recorded = fs::exists(file, ignored);
  {
    const std::lock_guard lock(mutex_);
    running_ = false;
    message_ = message;
    recording_ = is_recorded ? project_.name_of(file) : "";
    if (control_.must_disarm()) {
      lease_.clear();
    }
  }
  if (!run.is_null()) {
    send_("arm_run", line_of(run));
  }
  tell();
}

/// Pages see states in the order in which they came about.
void ArmStation::tell(const Send& send) {
  const std::lock_guard lock(tell_mutex_);
  send("arm", status());
}

void ArmStation::tell() {
  tell(send_);
}

/// What the driver says of a vent: also to whoever watches the terminal.
void ArmStation::note(const std::string& message) {
  if (driver_.say) {
    driver_.say(message);
  }
  {
    const std::lock_guard lock(mutex_);
    message_ = message;
  }
  tell();
}

}  // namespace limber
