#include "spilled_tables.hpp"

#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <string>

#include "limber/common/file_error.hpp"
#include "limber/common/filesystem.hpp"

namespace limber {

namespace {

/// The matrices of a table; Frames may be const.
template <class Frames>
auto matrices_of(Frames& frames) {
  return std::array{&frames.pressure, &frames.no_load, &frames.uncompensated,
                    &frames.state,    &frames.target,  &frames.change};
}

std::size_t bytes_of(Eigen::Index rows, int frames) {
  return std::size_t(rows) * std::size_t(frames) * sizeof(float);
}

}  // namespace

SpilledTables::SpilledTables(const fs::path& beside)
    : folder_(beside.empty() ? fs::temp_directory_path() : fs::absolute(beside).parent_path()) {
  std::string path = (folder_ / ".limber-slices-XXXXXX").string();
  file_ = ::mkstemp(path.data());
  if (file_ < 0) {
    throw_file_error(folder_, "no file for slices can be made there", errno);
  }
  ::unlink(path.c_str());
}

SpilledTables::~SpilledTables() {
  ::close(file_);
}

void SpilledTables::append(const void* data, std::size_t size) {
  const char* next = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t count = ::pwrite(file_, next, size, end_);
    if (count < 0 && errno != EINTR) {
      throw_fault(folder_, "the slices can't be written there", errno);
    }
    const auto written = std::size_t(std::max<ssize_t>(count, 0));
    next += written;
    size -= written;
    end_ += std::int64_t(written);
  }
}

std::int64_t SpilledTables::read_at(std::int64_t first, void* data, std::size_t size) const {
  char* next = static_cast<char*>(data);
  while (size > 0) {
    const ssize_t count = ::pread(file_, next, size, first);
    if (count == 0 || (count < 0 && errno != EINTR)) {
      throw_fault(folder_, "the slices can't be read there", count == 0 ? EIO : errno);
    }
    const auto read = std::size_t(std::max<ssize_t>(count, 0));
    next += read;
    size -= read;
    first += std::int64_t(read);
  }
  return first;
}

void SpilledTables::add(const TrainingTables& tables, std::span<const int> episodes) {
  assert(episodes.size() == tables.episodes.size());
  const FrameTable<float>& frames = tables.frames;
  const auto matrices = matrices_of(frames);
  for (std::size_t i = 0; i < episodes.size(); ++i) {
    const auto [first, count] = tables.episodes[i];
    places_[episodes[i]] = {end_, count};
    for (std::size_t k = 0; k < matrices.size(); ++k) {
      rows_[k] = matrices[k]->rows();
      append(matrices[k]->data() + rows_[k] * first, bytes_of(rows_[k], count));
    }
    std::vector<std::uint8_t> tracked(count, 1);
    if (!frames.tracked.empty()) {
      tracked.assign(frames.tracked.begin() + first, frames.tracked.begin() + first + count);
    }
    append(tracked.data(), tracked.size());
  }
}

TrainingTables SpilledTables::read(std::span<const int> episodes) const {
  TrainingTables tables;
  int total = 0;
  for (const int episode : episodes) {
    const int count = places_.at(episode).frames;
    tables.episodes.push_back({total, count});
    total += count;
  }
  const auto matrices = matrices_of(tables.frames);
  for (std::size_t k = 0; k < matrices.size(); ++k) {
    matrices[k]->resize(rows_[k], rows_[k] > 0 ? total : 0);
  }
  tables.frames.tracked.resize(total);
  for (std::size_t i = 0; i < episodes.size(); ++i) {
    const auto [first, count] = tables.episodes[i];
    std::int64_t at = places_.at(episodes[i]).first;
    for (std::size_t k = 0; k < matrices.size(); ++k) {
      at = read_at(at, matrices[k]->data() + rows_[k] * first, bytes_of(rows_[k], count));
    }
    read_at(at, tables.frames.tracked.data() + first, std::size_t(count));
  }
  return tables;
}

}  // namespace limber
