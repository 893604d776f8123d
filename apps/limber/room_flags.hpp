#pragma once

#include <CLI/CLI.hpp>

#include "limber/forward/error_room.hpp"
#include "verb.hpp"

namespace limber {

/// What plans keep in hand for the model's error, as flags ask for it.
class RoomFlags {
 public:
  /// --margin-m, --goal-margin-m and --goal-margin-rad.
  void add_to(CLI::App& app);

  const AskedRoom& asked() const { return asked_; }
  /// With what the model says where flags ask for nothing; says on standard error where that is no
  /// measured amount.
  ErrorRoom room(const ForwardModel& model, const CommonFlags& flags) const;

 private:
  AskedRoom asked_;
};

}  // namespace limber
