#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "arm_control.hpp"
#include "arm_run.hpp"
#include "project_folder.hpp"

namespace limber {

/// The arm behind `limber studio --driver`, for one page at a time: the one that has armed it, as
/// long as it renews its lease. Any page may vent it. Runs go on a thread of its own.
/// Threads: any.
class ArmStation {
 public:
  /// Passes an event on to every page. Called without a lock of the station's.
  using Send = std::function<void(const std::string& kind, const std::string& json)>;

  /// @param arm     name of the driver's arm in the project
  /// @param driver  command, safety and calibration
  ArmStation(const ProjectFolder& project, std::string arm, ProcessDriverSettings driver,
             Send send);
  /// Vents.
  ~ArmStation();

  /// Whoever confirms it gets the lease. @return empty: another page has armed the arm
  std::string arm();
  /// False: nothing is armed with that lease any more. Waits for no run.
  bool renew(const std::string& lease);
  /// @return why not; empty: it runs
  std::string run(const std::string& lease, ArmRunJob job);
  /// @return why not; empty: it is done
  std::string pause(const std::string& lease, bool on);
  bool stop(const std::string& lease);
  bool disarm(const std::string& lease);
  /// At once, whoever asks, and nothing is armed any more. Waits for nothing.
  void vent();

  /// The event `arm` (docs/studio_api.md).
  std::string status() const;
  /// The same to a page that is new, in order with what all get.
  void tell(const Send& send);

 private:
  void work();
  void run_now(const ArmRunJob& job);
  void note(const std::string& message);
  void tell();
  bool has_lease(const std::string& lease) const;
  /// Acts under the lock. @return whether that is the lease
  bool with_lease(const std::string& lease, const std::function<void()>& act);

  const ProjectFolder& project_;
  std::string arm_;
  ProcessDriverSettings driver_;
  Send send_;
  ArmControl control_;

  std::mutex tell_mutex_;  // before mutex_
  mutable std::mutex mutex_;
  std::condition_variable has_work_;
  std::string lease_;  // empty: not armed
  std::optional<ArmRunJob> next_;
  bool running_ = false;
  bool ending_ = false;
  std::string message_;    // what became of it last
  std::string recording_;  // of the last run

  std::thread worker_;  // last: it uses all of the above
};

}  // namespace limber
