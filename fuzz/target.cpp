#include "target.hpp"

#include <unistd.h>

#include <cstdio>
#include <stdexcept>

#include <fmt/format.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/printable.hpp"
#include "limber/common/utf8.hpp"
#include "support/sample_arm.hpp"
#include "support/space_arm.hpp"

namespace limber::fuzz {

namespace {

constexpr std::size_t kMaxMessage = 6000;  // bytes; what a user can still read

class ScratchFolder {
 public:
  ScratchFolder() {
    const std::filesystem::path memory = "/dev/shm";
    const auto place =
        std::filesystem::exists(memory) ? memory : std::filesystem::temp_directory_path();
    path_ = place / fmt::format("limber_fuzz_{}", getpid());
    std::filesystem::create_directories(path_);
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Without the care that write_file_atomically takes for the disk.
void write_plainly(const std::filesystem::path& path, std::string_view bytes) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  require(file != nullptr, fmt::format("{}: can't be written", path.string()));
  const std::size_t written = std::fwrite(bytes.data(), 1, bytes.size(), file);
  require(std::fclose(file) == 0 && written == bytes.size(),
          fmt::format("{}: can't be written", path.string()));
}

}  // namespace

std::vector<Target> all_targets() {
  std::vector<Target> all;
  for (const auto& group : {yaml_targets(), json_targets(), tensor_targets(), log_targets(),
                            folder_targets(), name_targets(), driver_targets(), studio_targets()}) {
    all.insert(all.end(), group.begin(), group.end());
  }
  return all;
}

Target target_named(const std::string& name) {
  std::string known;
  for (const Target& target : all_targets()) {
    if (name == target.name) {
      return target;
    }
    known += std::string(known.empty() ? "" : ", ") + target.name;
  }
  throw InputError(fmt::format("target '{}': expected one of {}", name, known));
}

std::string run(const Target& target, std::string_view bytes) {
  Input input{bytes, {}};
  if (target.file[0] != '\0') {
    input.file = scratch_folder() / target.file;
    write_plainly(input.file, bytes);
  }
  try {
    target.read(input);
    return "";
  } catch (const InputError& refusal) {
    const std::string message = refusal.what();
    require(message.size() <= kMaxMessage,
            fmt::format("a message of {} bytes: {}…", message.size(), message.substr(0, 200)));
    require(is_utf8(message), "a message that is not UTF-8: " + printable(message));
    require(message.find(target.file) != std::string::npos,
            fmt::format("'{}' does not name {}", message, target.file));
    return message;
  }
}

TwoFiles two_files(std::string_view bytes) {
  const std::size_t end = bytes.find(kBreak);
  if (end == bytes.npos) {
    return {bytes, std::nullopt};
  }
  return {bytes.substr(0, end), bytes.substr(end + kBreak.size())};
}

const std::filesystem::path& scratch_folder() {
  static const ScratchFolder folder;
  return folder.path();
}

ArmDescription one_segment_with(int gaps) {
  ArmDescription arm = sample_arm(1);
  arm.segments[0].gaps = gaps;
  return arm;
}

const ArmDescription& small_arm() {
  static const ArmDescription arm = one_segment_with(2);
  return arm;
}

const ArmDescription& small_space_arm() {
  static const ArmDescription arm = [] {
    ArmDescription one = testing_support::space_arm();
    one.segments.resize(1);
    one.segments[0].gaps = 2;
    return one;
  }();
  return arm;
}

const ArmDescription& three_segments() {
  static const ArmDescription arm = load_arm(LIMBER_SOURCE_DIR "/arms/three_segment.yaml");
  return arm;
}

std::string source_file(const std::string& path) {
  return read_file(std::filesystem::path(LIMBER_SOURCE_DIR) / path);
}

void naming(const std::filesystem::path& file, const std::function<void()>& ask) {
  try {
    ask();
  } catch (const InputError& refusal) {
    throw InputError(fmt::format("{}: {}", file.string(), refusal.what()));
  }
}

void require(bool holds, const std::string& what) {
  if (!holds) {
    throw std::logic_error(what);
  }
}

}  // namespace limber::fuzz
