#pragma once

#include <atomic>
#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
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

inline constexpr std::uint64_t kMaxRequest = std::uint64_t{1} << 53U;  // exact in JavaScript

/// What keeps a tab's plan from being the one that its page shows; empty: it is.
/// @param body  a request; `plan`, where it has one, is the number of the request that found it
std::string why_not_shown(const std::optional<FoundPlan>& found, const JsonReader& body);

/// All open tabs by their number. A browser holds six connections to one address and an event
/// stream takes one of them: two are left, for the renewal of a lease and for VENT.
/// Threads: any.
class Tabs {
 public:
  static constexpr std::size_t kMax = 4;

  explicit Tabs(const ProjectFolder& project) : project_(project) {}

  /// A new tab; empty: there are kMax.
  std::string open();
  /// Stops its work, and only its own.
  void close(const std::string& id);
  /// The stream's next piece; empty after a while without one.
  std::string pop_event(const std::string& id);

  /// The same event for every tab. Waits for no tab's work.
  void send_to_all(const std::string& kind, const std::string& json);

  /// use(tab), while it can't be closed. @return whether there is such a tab
  template <class Use>
  bool with(const std::string& id, Use&& use) {
    const std::lock_guard lock(mutex_);
    const auto found = tabs_.find(id);
    if (found == tabs_.end()) {
      return false;
    }
    use(*found->second);
    return true;
  }

 private:
  const ProjectFolder& project_;
  std::mutex mutex_;
  std::map<std::string, std::unique_ptr<Tab>> tabs_;
  std::mutex events_mutex_;                    // after mutex_
  std::map<std::string, EventQueue*> events_;  // of tabs_
};

}  // namespace limber
