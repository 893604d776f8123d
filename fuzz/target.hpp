#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limber/arm/arm_description.hpp"

namespace limber::fuzz {

/// What a target is given: bytes from outside, and the file that holds them.
struct Input {
  std::string_view bytes;
  std::filesystem::path file;
};

/// Stands between the two files of an input that holds two.
inline constexpr std::string_view kBreak = "\n=====\n";

struct TwoFiles {
  std::string_view first;
  std::optional<std::string_view> second;  ///< none: there is no kBreak
};
TwoFiles two_files(std::string_view bytes);

/// Something that reads bytes from outside. It may refuse them with an InputError, and in no other
/// way. Whatever else it throws, a crash, a hang and an allocation beyond measure are findings.
struct Target {
  const char* name;  ///< of its folders in corpus/ and regressions/
  const char* file;  ///< name of the file that gets the bytes; every refusal has to name it
  void (*read)(const Input& input);
  /// Valid inputs, made by limber's own writers, beside those of the corpus; may be null.
  std::vector<std::string> (*seeds)() = nullptr;
};

std::vector<Target> yaml_targets();
std::vector<Target> json_targets();
std::vector<Target> tensor_targets();
std::vector<Target> log_targets();
std::vector<Target> folder_targets();
std::vector<Target> name_targets();
std::vector<Target> driver_targets();
std::vector<Target> studio_targets();

/// The target of that name. @throws InputError naming all.
Target target_named(const std::string& name);
std::vector<Target> all_targets();

/// Gives the bytes to the target.
/// @return the refusal; empty: they were taken
/// @throws std::logic_error for a refusal that names no file, is not UTF-8, or is too long to read;
/// whatever the target throws that is no InputError.
std::string run(const Target& target, std::string_view bytes);

/// A folder of this process in memory, removed where it ends in the ordinary way.
const std::filesystem::path& scratch_folder();

/// One segment, with so many gaps.
ArmDescription one_segment_with(int gaps);
/// Two gaps, so that inputs are small.
const ArmDescription& small_arm();
/// In space: one segment of three chambers, two gaps.
const ArmDescription& small_space_arm();
/// limber's own arm of three segments.
const ArmDescription& three_segments();
/// Of a file in limber's source.
std::string source_file(const std::string& path);

/// Puts the file's name before the refusals of `ask`, as the verbs do for what knows no file.
void naming(const std::filesystem::path& file, const std::function<void()>& ask);

/// @throws std::logic_error with `what` unless `holds`.
void require(bool holds, const std::string& what);

}  // namespace limber::fuzz
