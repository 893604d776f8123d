#include "command_line.hpp"

#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <memory>
#include <sstream>
#include <vector>

#include "distinct_files.hpp"
#include "limber/common/file_error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/printable.hpp"
#include "limber/common/utf8.hpp"
#include "limber/common/version.hpp"
#include "limber/driver/process_driver.hpp"
#include "numeric_flags.hpp"
#include "verb.hpp"
#include "verbs.hpp"

namespace limber {

namespace {

int report(int code, const std::string& message) {
  print_error(message);
  return code;
}

/// What CLI11 says: help and version unchanged, errors made printable.
int report(const CLI::App& app, const CLI::ParseError& error) {
  std::ostringstream out;
  std::ostringstream complaint;
  const int code = app.exit(error, out, complaint);
  fmt::print("{}", out.str());
  print_to_stderr(printable(complaint.str()));
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
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
      throw SystemFault("standard output can't be written");
    }
    return code;
  } catch (const InputError& error) {
    return report(kExitBadInput, error.what());
  } catch (const Interrupted& error) {
    return report(kExitNoSolution, error.what());
  } catch (const std::filesystem::filesystem_error& error) {
    return report(is_callers_mistake(error.code().value()) ? kExitBadInput : kExitFault,
                  fmt::format("{}: {}", error.path1().string(), error.code().message()));
  } catch (const std::bad_alloc&) {
    return report(kExitFault, "out of memory");
  } catch (const std::exception& error) {
    return report(kExitFault, error.what());
  }
}

/// An arm that may be under pressure is a fault, whatever else came of the run.
int run_guarded(Verb& verb, const CLI::App& command, const CommonFlags& flags) {
  const int code = run_caught(verb, command, flags);
  return ProcessDriver::was_any_left_unsafe() ? kExitFault : code;
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
      ->check(CLI::NonNegativeNumber)
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
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return report(app, error);
  }
  install_interrupt_handler();
  for (const std::unique_ptr<Verb>& verb : verbs) {
    if (app.got_subcommand(verb->name())) {
      return run_guarded(*verb, *app.get_subcommand(verb->name()), flags);
    }
  }
  return kExitBadInput;
}

void print_error(const std::string& message) {
  print_to_stderr(fmt::format("error: {}\n", printable(message)));
}

void print_result(const CommonFlags& flags, const nlohmann::ordered_json& result,
                  const std::string& text) {
  if (flags.take_result) {
    flags.take_result(result);
  } else if (flags.json) {
    fmt::print("{}\n", printable_json(result.dump(
                           2, ' ', false, nlohmann::ordered_json::error_handler_t::replace)));
  } else if (!flags.quiet && !text.empty()) {
    fmt::print("{}\n", printable(text));
  }
}

}  // namespace limber
