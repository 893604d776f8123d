#pragma once

#include <CLI/CLI.hpp>

#include "limber/forward/error_room.hpp"
#include "verb.hpp"

namespace limber {

/// The room that plans keep for the model's error, as asked for by flags.
class RoomFlags {
 public:
  /// --margin-m, --goal-margin-m and --goal-margin-rad.
  void add_to(CLI::App& app);

  const AskedRoom& asked() const { return asked_; }
  /// The amounts asked for; the model's own where no flag asks. Says on standard error if those are
  /// not measured.
  ErrorRoom room(const ForwardModel& model, const CommonFlags& flags) const;

 private:
  AskedRoom asked_;
};

}  // namespace limber
