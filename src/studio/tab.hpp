#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

#include "event_queue.hpp"
#include "jobs.hpp"

namespace limber {

/// One open page: its events, and one thread that works for it alone. A job ends the one before
/// it; what is found is kept. Threads: any.
class Tab {
 public:
  explicit Tab(const ProjectFolder& project);
  /// Stops its work.
  ~Tab();

  void post(Job job);
  /// Ends what is being done.
  void stop();
  /// Where a drive goes.
  DriveTarget& target() { return target_; }
  /// The last plan that was certified.
  std::optional<FoundPlan> found() const;
  EventQueue& events() { return events_; }

 private:
  void work();
  void run(const Job& job);
  void keep(FoundPlan found);
  const StudioScene& scene(const SceneNames& names);

  const ProjectFolder& project_;
  EventQueue events_;
  DriveTarget target_;
  std::atomic<bool> stop_job_ = false;

  mutable std::mutex mutex_;
  std::condition_variable has_job_;
  std::optional<Job> next_;
  std::optional<FoundPlan> found_;
  bool ending_ = false;

  std::unique_ptr<const StudioScene> scene_;  // the worker's alone
  std::thread worker_;                        // last: it uses all of the above
};

}  // namespace limber
