#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "limber/common/json.hpp"
#include "project_folder.hpp"

namespace limber {

/// What `limber experiment` left in the project folder (docs/experiments.md), by paths in it. Names
/// come from requests: none leads out of the project. Threads: any.
class ExperimentFolder {
 public:
  /// The one whose table is the newest; none: there is none.
  static std::optional<ExperimentFolder> newest(const ProjectFolder& project);
  /// @throws InputError unless there is one of that name.
  ExperimentFolder(const ProjectFolder& project, std::string name);

  const std::string& name() const { return name_; }

  /// The rows of table.json, the first kMaxRows.
  Json rows() const;
  /// The trials of a row, kMaxRuns of them: how each was planned and executed, and its plan.
  Json runs(std::size_t row) const;

  static constexpr std::size_t kMaxRows = 500;
  static constexpr std::size_t kMaxRuns = 500;

 private:
  nlohmann::json table() const;
  nlohmann::json read(const std::string& file) const;

  const ProjectFolder& project_;
  std::string name_;
};

}  // namespace limber
