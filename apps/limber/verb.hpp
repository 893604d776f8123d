#pragma once

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "limber/arm/arm_description.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/json.hpp"
#include "limber/common/printable.hpp"
#include "limber/common/progress.hpp"
#include "limber/common/standard_streams.hpp"

namespace limber {

enum ExitCode : int { kExitDone = 0, kExitNoSolution = 1, kExitBadInput = 2, kExitFault = 3 };

/// Flags that every verb has.
struct CommonFlags {
  bool json = false;
  bool quiet = false;
  bool force = false;
  int jobs = 0;  ///< 0: one per core
  std::uint64_t seed = 1;
  /// Gets the result in place of standard output, of a verb that another one runs. Empty: nobody.
  std::function<void(const Json&)> take_result = {};
  mutable std::vector<std::string> warnings = {};  ///< what `warn` said

  Progress::Mode progress() const {
    return quiet ? Progress::Mode::quiet : Progress::Mode::automatic;
  }
};

/// One verb of the program. `add_flags` declares, `run` works and returns an exit code; failures
/// are exceptions (common/error.hpp), printed and turned into exit codes in one place.
class Verb {
 public:
  virtual ~Verb() = default;
  const char* name() const { return name_; }
  const char* summary() const { return summary_; }
  /// A command that runs as it stands, for --help.
  const char* example() const { return example_; }
  virtual void add_flags(CLI::App& app) = 0;
  virtual int run(const CommonFlags& flags) = 0;

 protected:
  Verb(const char* name, const char* summary, const char* example)
      : name_(name), summary_(summary), example_(example) {}

 private:
  const char* name_;
  const char* summary_;
  const char* example_;
};

/// A line for people on standard error, unless quiet.
template <class... Arguments>
void say(const CommonFlags& flags, fmt::format_string<Arguments...> format,
         Arguments&&... arguments) {
  if (!flags.quiet) {
    print_to_stderr(printable(fmt::format(format, std::forward<Arguments>(arguments)...)) + "\n");
  }
}

/// The same of a warning, which is kept for the result.
template <class... Arguments>
void warn(const CommonFlags& flags, fmt::format_string<Arguments...> format,
          Arguments&&... arguments) {
  flags.warnings.push_back(fmt::format(format, std::forward<Arguments>(arguments)...));
  say(flags, "warning: {}", flags.warnings.back());
}

/// Checks of numbers in place of CLI::PositiveNumber and CLI::NonNegativeNumber, whose messages
/// name the largest number that there is, in 300 digits.
CLI::Validator more_than_zero();
CLI::Validator at_least_zero();

/// Gives a verb's settings those of these flags that they have.
template <class Settings>
void take_common(const CommonFlags& flags, Settings& settings) {
  if constexpr (requires { settings.seed; }) {
    settings.seed = flags.seed;
  }
  if constexpr (requires { settings.jobs; }) {
    settings.jobs = flags.jobs;
  }
  if constexpr (requires { settings.force; }) {
    settings.force = flags.force;
  }
  if constexpr (requires { settings.progress; }) {
    settings.progress = flags.progress();
  }
  if constexpr (requires { settings.say; }) {
    settings.say = [&flags](const std::string& line) { say(flags, "{}", line); };
  }
}

/// Prints to standard error, quiet or not, why a verb ends with another code than 0.
void print_error(const std::string& message);

/// Prints the verb's result to standard output: the JSON object with --json, otherwise `text`,
/// unless it is empty.
void print_result(const CommonFlags& flags, const Json& result, const std::string& text);

/// refuse_to_overwrite (common/atomic_file.hpp) for each of these that names a file: outputs that
/// were not asked for are empty.
void refuse_to_overwrite_given(std::initializer_list<std::string> paths, const CommonFlags& flags);

/// Writes what `make` returns to the file that a flag names; does nothing where it names none.
template <class Make>
void write_given(const std::string& path, const Make& make) {
  if (!path.empty()) {
    write_file_atomically(path, make());
  }
}

/// --arm, with `arm` as its default.
void add_arm_flag(CLI::App& app, std::string& arm);

/// Path of an arm file: the path given, or the name of one of limber's own ("three_segment"), found
/// in arms/ beside the program or in its installed data folder.
std::string find_arm_file(const std::string& name_or_path);

/// The arm of that file, with what the file says of the virtual arm checked too.
ArmDescription load_any_arm(const std::string& name_or_path,
                            PolynomialsOf polynomials = PolynomialsOf::model);
/// The same for verbs that can't use arms in space. @throws InputError as `require_planar`, whose
/// `what` it is.
ArmDescription load_asked_arm(const std::string& name_or_path, const std::string& what,
                              PolynomialsOf polynomials = PolynomialsOf::model);

/// What a limber file holds; an arm, an environment and valves are all YAML.
enum class FileKind { recording, model, forest, plan, yaml };

/// Decides by content, never by name.
FileKind kind_of(const fs::path& file);

/// Path of an environment file, found the same way ("01_pillar" in environments/).
std::string find_environment_file(const std::string& name_or_path);
std::string find_family_file(const std::string& name_or_path);
/// The file given, or limber's own arm, environment or family of this name; else the name.
std::string find_any_file(const std::string& name_or_path);

/// Adds "FILE HASH" to what a model says that it learnt from.
void add_source(std::string& sources, const fs::path& path, const std::string& hash);

}  // namespace limber
