#pragma once

#include <atomic>
#include <chrono>
#include <string>

namespace limber {

/// What pages ask of an arm while it moves: the run looks at it every few milliseconds. Nothing
/// here waits for anything, so that a vent overtakes all else. Threads: any.
class ArmControl {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds kHoldAfter{1000};  // without a word of its page
  static constexpr std::chrono::milliseconds kVentAfter{3000};

  /// A page has armed it: what was asked before is over.
  void begin() {
    renew();
    vent_ = stop_ = paused_ = false;
  }
  /// The page that armed it is there.
  void renew() { heard_ = Clock::now().time_since_epoch().count(); }
  void vent() { vent_ = true; }
  /// Ends the run; the arm stays armed.
  void stop() { stop_ = true; }
  void pause(bool on) { paused_ = on; }
  /// Before a run.
  void clear_stop() { stop_ = paused_ = false; }

  bool must_disarm() const { return vent_ || silence() > kVentAfter; }
  bool must_vent() const { return stop_ || must_disarm(); }
  bool must_hold() const { return paused_ || silence() > kHoldAfter; }

  /// In words; empty: it need not.
  std::string why_vented() const {
    return vent_                    ? "VENT was pressed"
           : silence() > kVentAfter ? "the page that had armed the arm was not heard for 3 s"
           : stop_                  ? "stopped by hand"
                                    : "";
  }
  std::string why_held() const {
    return silence() > kHoldAfter ? "the page that armed the arm is not heard"
           : paused_              ? "paused"
                                  : "";
  }

 private:
  Clock::duration silence() const {
    return Clock::now().time_since_epoch() - Clock::duration(heard_.load());
  }

  std::atomic<Clock::rep> heard_ = 0;
  std::atomic<bool> vent_ = false;
  std::atomic<bool> stop_ = false;
  std::atomic<bool> paused_ = false;
};

}  // namespace limber
