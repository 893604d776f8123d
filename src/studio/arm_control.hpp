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
  /// Each held frame is kept for the recording and the page: memory has to end somewhere.
  static constexpr std::chrono::minutes kLongestPause{10};

  /// A page has armed it: what was asked before is over.
  void begin() {
    renew();
    vent_ = false;
    clear_stop();
  }
  /// The page that armed it is there.
  void renew() { heard_ = Clock::now().time_since_epoch().count(); }
  void vent() { vent_ = true; }
  /// Ends the run; the arm stays armed.
  void stop() { stop_ = true; }
  /// @param at  when; of a pause that goes on, the first one counts
  void pause(bool on, Clock::time_point at = Clock::now()) {
    Clock::rep no_pause = 0;
    if (!on) {
      paused_since_ = 0;
    } else {
      paused_since_.compare_exchange_strong(no_pause, at.time_since_epoch().count());
    }
  }
  /// Of a run whose driver keeps no frames: nothing holds its arm.
  void note_unheld() {
    is_unheld_ = true;
    pause(false);  // asked for before that was known
  }
  bool is_unheld() const { return is_unheld_; }
  /// Before a run.
  void clear_stop() {
    stop_ = is_unheld_ = false;
    pause(false);
  }

  bool must_disarm() const { return vent_ || silence() > kVentAfter; }
  bool must_vent() const { return stop_ || must_disarm() || is_paused_too_long(); }
  bool must_hold() const { return is_paused() || silence() > kHoldAfter; }

  /// In words; empty: it need not.
  std::string why_vented() const {
    return vent_                    ? "VENT was pressed"
           : silence() > kVentAfter ? "the page that had armed the arm was not heard for 3 s"
           : stop_                  ? "stopped by hand"
           : is_paused_too_long()   ? "paused for 10 min, as long as a pause may last"
                                    : "";
  }
  std::string why_held() const {
    return is_unheld_               ? ""
           : silence() > kHoldAfter ? "the page that armed the arm is not heard"
           : is_paused()            ? "paused"
                                    : "";
  }

 private:
  static Clock::duration since(Clock::rep then) {
    return Clock::now().time_since_epoch() - Clock::duration(then);
  }
  Clock::duration silence() const { return since(heard_); }
  bool is_paused() const { return paused_since_ != 0; }
  bool is_paused_too_long() const {
    const Clock::rep then = paused_since_;
    return then != 0 && since(then) > kLongestPause;
  }

  std::atomic<Clock::rep> heard_ = 0;
  std::atomic<bool> vent_ = false;
  std::atomic<bool> stop_ = false;
  std::atomic<bool> is_unheld_ = false;
  std::atomic<Clock::rep> paused_since_ = 0;  // 0: it is not
};

}  // namespace limber
