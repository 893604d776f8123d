#pragma once

namespace limber {

/// While one lives, floats of its thread below 1.2e-38 count as 0. Processors take a hundred times
/// as long for them, and training makes them: the weights and moments of units that no frame wakes
/// any more shrink from step to step, and never end. Where a processor has no such switch it does
/// nothing.
class FlushedSubnormals {
 public:
  FlushedSubnormals();
  ~FlushedSubnormals();
  FlushedSubnormals(const FlushedSubnormals&) = delete;
  FlushedSubnormals& operator=(const FlushedSubnormals&) = delete;

 private:
  unsigned long long before_ = 0;
};

}  // namespace limber
