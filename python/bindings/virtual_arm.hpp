#pragma once

#include <atomic>

#include "limber/common/refuse_if.hpp"
#include "limber/sim/virtual_arm.hpp"

namespace limber::python {

/// A virtual arm takes one thread at a time; Python's threads do not know that.
class SharedVirtualArm {
 public:
  SharedVirtualArm(const ArmDescription& arm, const VirtualArmOptions& options)
      : arm_(arm, options), dimension_(arm.dimension) {}

  Dimension dimension() const { return dimension_; }

  /// The arm, for as long as the use lives. @throws InputError where another thread uses it.
  class Use {
   public:
    explicit Use(SharedVirtualArm& shared) : shared_(shared) {
      refuse_if(shared.busy_.exchange(true),
                "this virtual arm is moving already; make one for each thread");
    }
    ~Use() { shared_.busy_.store(false); }
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;

    VirtualArm& operator*() const { return shared_.arm_; }
    VirtualArm* operator->() const { return &shared_.arm_; }

   private:
    SharedVirtualArm& shared_;
  };

 private:
  VirtualArm arm_;
  Dimension dimension_;
  std::atomic<bool> busy_{false};
};

}  // namespace limber::python
