#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace limber {

/// How the plans of an experiment are executed, and what the arm then meets.
class RunFlags {
 public:
  /// --replan, --controller and --disturbance.
  void add_to(CLI::App& app);

  /// In the order given; with --replan, replan is one of them. Open loop if none is given.
  std::vector<std::string> controllers() const;
  bool replans() const;
  /// In the order given, empty for none; none alone if nothing is given.
  /// @throws InputError if there is no such kind.
  std::vector<std::string> disturbances() const;

 private:
  bool replan_ = false;
  std::vector<std::string> controllers_;
  std::vector<std::string> disturbances_;
};

}  // namespace limber
