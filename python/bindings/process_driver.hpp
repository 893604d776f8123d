#pragma once

#include <atomic>
#include <memory>
#include <string>

#include "limber/driver/driver_run.hpp"
#include "limber/driver/process_driver.hpp"
#include "limber/world/plan.hpp"

namespace limber::python {

/// A driver in a process of its own. It takes one thread at a time; Python's threads do not know
/// that. Python's lock is let go while it vents and says goodbye.
class SharedProcessDriver {
 public:
  SharedProcessDriver(const ArmDescription& arm, const ProcessDriverSettings& settings);
  ~SharedProcessDriver();
  SharedProcessDriver(const SharedProcessDriver&) = delete;
  SharedProcessDriver& operator=(const SharedProcessDriver&) = delete;

  /// The driver, for as long as the use lives. @throws InputError where another thread uses it, or
  /// it was closed.
  class Use {
   public:
    explicit Use(SharedProcessDriver& shared);
    ~Use() { shared_.busy_.store(false); }
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;

    ProcessDriver& operator*() const { return *shared_.driver_; }
    ProcessDriver* operator->() const { return shared_.driver_.get(); }

   private:
    SharedProcessDriver& shared_;
  };

  /// Vents and ends the process; more than once.
  void close();
  bool is_open() const { return driver_ != nullptr; }

 private:
  std::unique_ptr<ProcessDriver> driver_;
  std::atomic<bool> busy_{false};
};

/// @throws InputError where a plan goes beyond what the driver allows. Nothing was moved then.
void require_within(const Plan& plan, const ProcessDriver& driver);
/// The same of a schedule, which goes to `limit_scale` times the arm's limits.
void require_reach(const ArmDescription& arm, double limit_scale, const ProcessDriver& driver);

}  // namespace limber::python
