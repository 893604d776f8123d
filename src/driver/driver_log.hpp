#pragma once

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string_view>

namespace limber {

/// What limber and a driver said to each other, one JSON object per line: {"at_s": 1.25,
/// "to_driver": {…}}. The first line says who started the run, and when. Written as it happens, so
/// that it is whole up to a crash; a log that can't be written any more never stops an arm.
class DriverLog {
 public:
  /// @throws SystemFault where `path` can't be opened; does nothing where it is empty.
  DriverLog(const std::filesystem::path& path, std::string_view command);

  void sent(std::string_view line) { write("to_driver", line); }
  void received(std::string_view line) { write("from_driver", line); }
  /// What limber made of it.
  void note(std::string_view text);

 private:
  void write(const char* key, std::string_view line);

  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, Closer> file_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace limber
