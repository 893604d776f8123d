#pragma once

#include <ompl/control/PathControl.h>
#include <ompl/control/planners/sst/SST.h>

#include <optional>

namespace limber {

struct SstCounts {
  std::size_t active = 0;     ///< nodes that may still be extended
  std::size_t inactive = 0;   ///< dominated, kept because they have children
  std::size_t witnesses = 0;  ///< in a sparse tree at least as many as active nodes
};

/// OMPL's SST with its nodes counted, and with its best motion for whoever looks while it searches.
class CountedSst final : public ompl::control::SST {
 public:
  using SST::SST;
  SstCounts counts() const;

  /// Cost of the best motion to the goal so far, if there is one.
  std::optional<double> solution_cost() const;
  /// That motion; before there is one, the motion that ended nearest. @pre a motion was kept
  ompl::control::PathControl kept_path() const;
};

}  // namespace limber
