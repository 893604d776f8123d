#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "tab.hpp"

namespace limber {

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
