#include "command_line.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "limber/common/atomic_file.hpp"
#include "limber/common/csv_reader.hpp"
#include "limber/common/error.hpp"
#include "limber/common/file_error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/json.hpp"
#include "limber/common/number_text.hpp"
#include "limber/common/printable.hpp"
#include "limber/common/utf8.hpp"
#include "limber/common/version.hpp"
#include "limber/driver/process_driver.hpp"
#include "limber/lab/output_folder.hpp"
#include "verb.hpp"
#include "verbs.hpp"

namespace limber {

namespace {

constexpr double kMax = 1e15;  // in kPa, m, s, Hz, rad: nothing real comes near

/// @param words  what is allowed. @param in_help  the same, as help texts have it
CLI::Validator number_check(bool (*holds)(double), const std::string& words, const char* in_help) {
  return {[=](std::string& text) {
            double value = 0.0;
            return parse_number(text, value) && holds(value)
                       ? std::string()
                       : fmt::format("'{}' found; expected {}", shortened(text), words);
          },
          in_help};
}

/// @return what is wrong with `text`; empty if nothing is
std::string check_blanks(std::string& text) {
  return text.find(',') == std::string::npos
             ? ""
             : fmt::format("'{}' found; expected numbers with blanks between them, no commas",
                           shortened(text));
}

/// Rewrites a text as a plain number, which CLI11 can't take for an octal one.
/// @param range  what is allowed, as range_in() has it; empty: what the type holds
template <class Whole>
CLI::Validator whole_check(std::string range) {
  if (range.empty()) {
    range = fmt::format(" from {} to {}", std::numeric_limits<Whole>::min(),
                        std::numeric_limits<Whole>::max());
  }
  return {[range](std::string& text) {
            const std::size_t sign = text.starts_with('+') ? 1 : 0;
            const std::optional<Whole> value =
                number_in<Whole>(std::string_view(text).substr(sign));
            if (!value) {
              return fmt::format("'{}' found; expected a whole number{}", shortened(text), range);
            }
            text = fmt::format("{}", *value);
            return std::string();
          },
          ""};
}

/// What a flag's own check allows, of its type in help texts: "INT:INT in [0 - 1024]" says " from 0
/// to 1024". Empty where it has no check.
std::string range_in(const std::string& type) {
  if (const std::size_t begin = type.find("in ["); begin != std::string::npos) {
    const std::size_t low = begin + 4, middle = type.find(" - ", low);
    return fmt::format(" from {} to {}", type.substr(low, middle - low),
                       type.substr(middle + 3, type.find(']', middle) - middle - 3));
  }
  return type.ends_with(":POSITIVE")      ? " more than 0"
         : type.ends_with(":NONNEGATIVE") ? " of at least 0"
                                          : "";
}

/// Leaves what follows each `=` to the planner, except numbers that are not finite.
std::string check_planner(const std::string& text) {
  for (std::size_t at = text.find('='); at != std::string::npos; at = text.find('=', at + 1)) {
    const std::string value = text.substr(at + 1, text.find(',', at) - at - 1);
    const std::optional<double> number = number_in(value);
    if (number && !std::isfinite(*number)) {
      return fmt::format("setting '{}' found; expected a finite number", shortened(value));
    }
  }
  return "";
}

/// Gives every option of `command` that takes numbers a check that runs before all others: the
/// value has to be one plain decimal number within its type, or of at most 1e15 if it may have
/// fractions; messages name the flag's own range where it has one. (CLI11 accepts nan, inf,
/// hexadecimal and octal numbers, and clamps numbers that are too large.) Settings of planners,
/// `NAME,key=value`, have to be finite too.
void require_plain_numbers(CLI::App& command) {
  const std::string of_at_most = fmt::format(" of at most {}", kMax);
  for (CLI::Option* option : command.get_options()) {
    const std::string type = option->get_type_name().substr(0, option->get_type_name().find(':'));
    const std::string range = range_in(option->get_type_name());
    if (type == "FLOAT") {
      option->transform(number_check([](double value) { return std::abs(value) <= kMax; },
                                     "a finite number" + (range.empty() ? of_at_most : range), ""));
    } else if (type == "INT") {
      option->transform(whole_check<std::int64_t>(range));
    } else if (type == "UINT") {
      option->transform(whole_check<std::uint64_t>(range));
    } else if (option->check_name("--planner")) {
      option->check(check_planner);
    }
    const bool is_number = type == "FLOAT" || type == "INT" || type == "UINT";
    if (is_number && option->get_items_expected_max() > 1) {
      option->transform(CLI::Validator(check_blanks, ""));  // comes before those above
    }
  }
}

// Every option by which a verb names a file or folder to write …
constexpr std::array kOutputs = {"--out",        "--svg",           "--plot",       "--plots",
                                 "--tables",     "--onnx",          "--mjcf",       "--motive",
                                 "--animation",  "--forest",        "--times-svg",  "--plans-out",
                                 "--device-log", "--pressures-svg", "--driver-log", "--truth",
                                 "--folder",     "--predictions",   "--adapted-out"};
// … and the verbs that write one which others read.
constexpr std::array<std::string_view, 2> kWritersOfCsv = {"plan", "export"};
// With --force, this verb fills in the arm file that it reads.
constexpr std::string_view kRewriter = "characterize";

// Verbs that fill a folder with results, and remove or replace those of the last run.
constexpr std::array<std::string_view, 3> kFillers = {"demo", "experiment", "improve"};

struct NamedPath {
  std::string option;
  fs::path path;
};

bool is_output(const CLI::App& command, const CLI::Option& option) {
  if (option.check_name("--csv")) {
    return std::ranges::find(kWritersOfCsv, command.get_name()) != kWritersOfCsv.end();
  }
  return std::ranges::any_of(kOutputs, [&](const char* name) { return option.check_name(name); });
}

/// As messages name it: a flag, or "the argument logs" of one that has no flag.
std::string name_of(const CLI::Option& option) {
  return (option.nonpositional() ? "" : "the argument ") + option.get_name();
}

bool same_file(const fs::path& a, const fs::path& b) {
  std::error_code error;
  if (fs::equivalent(a, b, error)) {
    return true;
  }
  const fs::path whole_a = fs::weakly_canonical(fs::absolute(a), error);
  const fs::path whole_b = fs::weakly_canonical(fs::absolute(b), error);
  return !whole_a.empty() && whole_a == whole_b;
}

/// The folder given, or the default.
fs::path folder_for_results(const CLI::Option& out) {
  std::string name = out.results().empty() ? out.get_default_str() : out.results().front();
  std::erase(name, '"');
  return name;
}

/// A file in the folder for results would be taken for a result, or be in the way of one.
void require_outside_of_results(const CLI::App& command, const fs::path& folder) {
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& value : option->results()) {
      std::error_code error;
      if (!value.empty() && !option->check_name("--out") &&
          fs::exists(fs::symlink_status(value, error)) && lies_in(value, folder)) {
        throw InputError(fmt::format(
            "{} {} lies in {}, the folder for results; choose another folder with --out",
            name_of(*option), value, folder.string()));
      }
    }
  }
}

/// Refuses a command line if a file to be written is also read or is written twice, or if a file to
/// be read lies in the folder that a verb of kFillers fills: the work or its input would be lost.
/// Files to be written are the values of the options named in the source; any other value that
/// names an existing file is read. Paths are compared as files, so links and detours don't hide
/// them.
/// @throws InputError naming both options and the file.
void require_distinct_files(const CLI::App& command) {
  std::vector<NamedPath> inputs;
  std::vector<NamedPath> outputs;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& value : option->results()) {
      std::error_code error;
      const bool is_rewritten = command.get_name() == kRewriter && option->check_name("--arm");
      if (is_output(command, *option)) {
        if (value.empty() || value == "-") {  // standard output has what --json prints
          throw InputError(fmt::format("{} '{}': names no file; expected a file or folder to write",
                                       option->get_name(), value));
        }
        outputs.push_back({option->get_name(), value});
      } else if (!is_rewritten && fs::is_regular_file(value, error)) {
        inputs.push_back({name_of(*option), value});
      }
    }
  }
  if (std::ranges::find(kFillers, command.get_name()) != kFillers.end()) {
    require_outside_of_results(command, folder_for_results(*command.get_option("--out")));
  }
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const auto refuse = [&](const NamedPath& other, const char* what) {
      throw InputError(fmt::format("{} {} is the file that {} {}; give it another name",
                                   outputs[i].option, outputs[i].path.string(), other.option,
                                   what));
    };
    for (const NamedPath& input : inputs) {
      if (same_file(outputs[i].path, input.path)) {
        refuse(input, "reads");
      }
    }
    for (std::size_t k = 0; k < i; ++k) {
      if (same_file(outputs[i].path, outputs[k].path)) {
        refuse(outputs[k], "also writes");
      }
    }
  }
}

int report(int code, const std::string& message) {
  print_error(message);
  return code;
}

constexpr const char* kOutputFault = "standard output can't be written";

bool is_output_written() {
  return std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
}

/// What CLI11 says: help and version unchanged, errors made printable.
int report(const CLI::App& app, const CLI::ParseError& error) {
  std::ostringstream out;
  std::ostringstream complaint;
  const int code = app.exit(error, out, complaint);
  const std::string help = out.str();
  if (std::fwrite(help.data(), 1, help.size(), stdout) != help.size() || !is_output_written()) {
    return report(kExitFault, kOutputFault);
  }
  if (code != 0) {
    print_to_stderr(printable("error: " + complaint.str()));
  }
  return code == 0 ? kExitDone : kExitBadInput;
}

/// Names end up in JSON, HDF5 and messages, which are UTF-8.
bool all_utf8(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    if (!is_utf8(argv[i])) {
      report(kExitBadInput,
             fmt::format("argument {} is not UTF-8: rename the file that it names", i));
      return false;
    }
  }
  return true;
}

int run_caught(Verb& verb, const CLI::App& command, const CommonFlags& flags) {
  try {
    require_distinct_files(command);
    const int code = verb.run(flags);
    if (!is_output_written()) {
      throw SystemFault(kOutputFault);
    }
    return code;
  } catch (const InputError& error) {
    return report(kExitBadInput, error.what());
  } catch (const Interrupted& error) {
    return report(kExitNoSolution, error.what());
  } catch (const fs::filesystem_error& error) {
    return report(is_callers_mistake(error.code().value()) ? kExitBadInput : kExitFault,
                  fmt::format("{}: {}", error.path1().string(), error.code().message()));
  } catch (const std::bad_alloc&) {
    return report(kExitFault, "out of memory");
  } catch (const std::exception& error) {
    return report(kExitFault, error.what());
  }
}

}  // namespace

void add_common_flags(CLI::App& app, CommonFlags& flags) {
  app.add_flag("--json", flags.json,
               "Print one JSON object on standard output, and nothing else there");
  app.add_flag("--quiet", flags.quiet, "No messages, no progress");
  app.add_flag("--force", flags.force, "Replace files that exist");
  app.add_option("--jobs", flags.jobs, "Threads to use, 0 for one per core; never changes a result")
      ->check(CLI::Range(0, 1024));
  app.add_option("--seed", flags.seed, "Seed of everything that is random")
      ->check(at_least_zero())
      ->capture_default_str();
}

int run_command_line(int argc, char** argv) {
  open_missing_standard_streams();
  std::signal(SIGXFSZ, SIG_IGN);  // a file beyond `ulimit -f` is then an error like a full disk
  CLI::App app(
      "limber makes soft robot arms plannable: characterise, "
      "collect, train, evaluate, plan, execute.");
  app.set_version_flag("--version", std::string("limber ") + version());
  app.require_subcommand(1);
  app.fallthrough(false);

  if (!all_utf8(argc, argv)) {
    return kExitBadInput;
  }
  CommonFlags flags;
  const std::vector<std::unique_ptr<Verb>> verbs = all_verbs();
  for (const std::unique_ptr<Verb>& verb : verbs) {
    CLI::App* command = app.add_subcommand(verb->name(), verb->summary());
    command->footer(std::string("Example:\n  ") + verb->example());
    add_common_flags(*command, flags);
    verb->add_flags(*command);
    require_plain_numbers(*command);
  }
  const std::string first = argc > 1 ? argv[1] : "";
  const auto is_first = [&](const auto& verb) { return verb->name() == first; };
  if (argc > 1 && !app.get_option_no_throw(first) && std::ranges::none_of(verbs, is_first)) {
    return report(
        kExitBadInput,
        fmt::format("'{}': no verb, and no flag that comes before one; limber --help lists "
                    "the verbs",
                    first));
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return report(app, error);
  }
  install_interrupt_handler();
  for (const std::unique_ptr<Verb>& verb : verbs) {
    if (app.got_subcommand(verb->name())) {
      const int code = run_caught(*verb, *app.get_subcommand(verb->name()), flags);
      // An arm that may be under pressure is a fault, whatever else came of the run.
      return ProcessDriver::was_any_left_unsafe() ? kExitFault : code;
    }
  }
  return kExitBadInput;
}

CLI::Validator more_than_zero() {
  return number_check([](double value) { return value > 0.0; }, "more than 0", "POSITIVE");
}

CLI::Validator at_least_zero() {
  return number_check([](double value) { return value >= 0.0; }, "at least 0", "NONNEGATIVE");
}

void print_error(const std::string& message) {
  print_to_stderr(fmt::format("error: {}\n", printable(message)));
}

void refuse_to_overwrite_given(std::initializer_list<std::string> paths, const CommonFlags& flags) {
  for (const std::string& path : paths) {
    if (!path.empty()) {
      refuse_to_overwrite(path, flags.force);
    }
  }
}

void print_result(const CommonFlags& flags, const Json& result, const std::string& text) {
  if (flags.take_result) {
    flags.take_result(result);
  } else if (flags.json) {
    fmt::print("{}\n", printable_json(result.dump(2, ' ', false, Json::error_handler_t::replace)));
  } else if (!flags.quiet && !text.empty()) {
    fmt::print("{}\n", printable(text));
  }
}

}  // namespace limber
