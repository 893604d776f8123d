#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>

#include "limber/common/filesystem.hpp"
#include "training_tables.hpp"

namespace limber {

/// Columns of episodes' tables on disk, in a file without a name that ends with this object: it is
/// twenty times as fast to read as the recordings are. Threads: several may read at once.
class SpilledTables {
 public:
  /// @param beside  a file in whose folder they go; empty: the system's for temporary files
  explicit SpilledTables(const fs::path& beside);
  ~SpilledTables();
  SpilledTables(const SpilledTables&) = delete;
  SpilledTables& operator=(const SpilledTables&) = delete;

  /// @param episodes  numbers of those in `tables`, none of which was added before
  /// @throws SystemFault if the disk is full.
  void add(const TrainingTables& tables, std::span<const int> episodes);
  /// Frames and ranges of these, without their arms; nothing else is filled in.
  TrainingTables read(std::span<const int> episodes) const;

 private:
  /// Of an episode.
  struct Place {
    std::int64_t first = 0;  ///< byte
    int frames = 0;
  };

  void append(const void* data, std::size_t size);
  /// @return the byte behind
  std::int64_t read_at(std::int64_t first, void* data, std::size_t size) const;

  fs::path folder_;
  int file_ = -1;
  std::int64_t end_ = 0;
  std::array<Eigen::Index, 6> rows_{};
  std::map<int, Place> places_;
};

}  // namespace limber
