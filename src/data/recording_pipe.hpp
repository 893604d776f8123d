#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "limber/data/recording.hpp"

namespace limber {

/// The end that writes. What stands twice, at both ends, is written once: see `pass`.
class PipeWriter {
 public:
  explicit PipeWriter(int pipe) : pipe_(pipe) {}

  void bytes(const void* data, std::size_t size);
  /// What stays here until more has come.
  void flush();
  /// For both ends: as many `items` follow, of `size` bytes in all.
  std::size_t announce(std::size_t items, std::size_t size_of_one) {
    (void)size_of_one;
    bytes(&items, sizeof items);
    return items;
  }

 private:
  void write_out(const char* data, std::size_t size) const;

  int pipe_;
  std::vector<char> buffer_;
};

/// The end that reads, which believes nothing. Throws EndOfPipe.
class PipeReader {
 public:
  /// @param name  of the file that is read, for messages
  /// @param most  bytes that may come in all
  PipeReader(std::string name, int pipe, std::uintmax_t most, int silence_ms)
      : name_(std::move(name)),
        pipe_(pipe),
        left_(most),
        silence_ms_(silence_ms),
        buffer_(kBuffer) {}

  void bytes(void* data, std::size_t size);
  /// @throws InputError where they are more than may come.
  std::size_t announce(std::size_t, std::size_t size_of_one);

 private:
  static constexpr std::size_t kBuffer = std::size_t{1} << 16U;

  std::size_t read_some(char* data, std::size_t size) const;

  std::string name_;
  int pipe_;
  std::uintmax_t left_;
  int silence_ms_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
};

// pass(pipe, x) writes x where the pipe is a writer and fills x where it is a reader: the order is
// defined once for both ends.

template <class Pipe, class Number>
requires std::is_arithmetic_v<Number>
void pass(Pipe& pipe, Number& number) {
  pipe.bytes(&number, sizeof number);
}

template <class Pipe>
void pass(Pipe& pipe, bool& answer) {
  std::uint8_t byte = answer ? 1 : 0;  // no other byte may become a bool
  pass(pipe, byte);
  answer = byte != 0;
}

template <class Pipe, class Item>
void pass(Pipe& pipe, std::vector<Item>& items) {
  items.resize(pipe.announce(items.size(), sizeof(Item)));
  pipe.bytes(items.data(), items.size() * sizeof(Item));
}

template <class Pipe>
void pass(Pipe& pipe, std::string& text) {
  text.resize(pipe.announce(text.size(), 1));
  pipe.bytes(text.data(), text.size());
}

template <class Pipe>
void pass(Pipe& pipe, Eigen::VectorXd& numbers) {
  const auto size = std::size_t(numbers.size());
  numbers.resize(Eigen::Index(pipe.announce(size, sizeof(double))));
  pipe.bytes(numbers.data(), std::size_t(numbers.size()) * sizeof(double));
}

template <class Pipe>
void pass(Pipe& pipe, FrameMatrix& matrix) {
  const std::size_t columns = pipe.announce(std::size_t(matrix.cols()), 1);
  const std::size_t rows = pipe.announce(std::size_t(matrix.rows()), columns * sizeof(float));
  matrix.resize(Eigen::Index(rows), Eigen::Index(columns));
  pipe.bytes(matrix.data(), rows * columns * sizeof(float));
}

template <class Pipe>
void pass(Pipe& pipe, Dimension& dimension) {
  bool in_space = dimension == Dimension::space;
  pass(pipe, in_space);
  dimension = in_space ? Dimension::space : Dimension::plane;
}

template <class Pipe>
void pass(Pipe& pipe, Episode& episode) {
  pass(pipe, episode.time_s);
  pass(pipe, episode.pressure_kpa);
  pass(pipe, episode.setpoint_kpa);
  pass(pipe, episode.backbone);
  pass(pipe, episode.motion_index);
  pass(pipe, episode.tracked);
  pass(pipe, episode.setpoints_only);
  pass(pipe, episode.dimension);
  pass(pipe, episode.lifted);
  pass(pipe, episode.physics);
  pass(pipe, episode.log);
}

/// All but the episodes and their numbers.
template <class Pipe>
void pass_header(Pipe& pipe, Recording& recording) {
  for (std::string* text : {&recording.arm_name, &recording.arm_hash, &recording.arm_description,
                            &recording.source, &recording.settings, &recording.program_version,
                            &recording.command.name, &recording.command.unit}) {
    pass(pipe, *text);
  }
  pass(pipe, recording.dimension);
  pass(pipe, recording.segment_count);
  pass(pipe, recording.chamber_count);
  pass(pipe, recording.point_count);
  pass(pipe, recording.rate_hz);
  pass(pipe, recording.seed);
}

}  // namespace limber
