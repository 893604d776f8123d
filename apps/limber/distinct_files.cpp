#include "distinct_files.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "limber/common/error.hpp"
#include "limber/lab/output_folder.hpp"

namespace limber {

namespace {

namespace fs = std::filesystem;

// Every option by which a verb names a file or folder to write …
constexpr std::array kOutputs = {"--out",       "--svg",    "--plot",          "--plots",
                                 "--tables",    "--onnx",   "--mjcf",          "--motive",
                                 "--animation", "--forest", "--pressures-svg", "--driver-log",
                                 "--device-log"};
// … and the verbs that write one which others read.
constexpr std::array<std::string_view, 2> kWritersOfCsv = {"plan", "export"};
// With --force, this verb fills in the arm file that it reads.
constexpr std::string_view kRewriter = "characterize";

// Verbs that fill a folder with results, and remove those of the last run.
constexpr std::array<std::string_view, 2> kFillers = {"demo", "experiment"};

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
            option->get_name(), value, folder.string()));
      }
    }
  }
}

}  // namespace

void require_distinct_files(const CLI::App& command) {
  std::vector<NamedPath> inputs;
  std::vector<NamedPath> outputs;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& value : option->results()) {
      std::error_code error;
      if (value.empty() && is_output(command, *option)) {
        throw InputError(fmt::format("{} '': names no file; expected a file or folder to write",
                                     option->get_name()));
      }
      if (value.empty()) {
        continue;
      }
      if (is_output(command, *option)) {
        outputs.push_back({option->get_name(), value});
      } else if (command.get_name() == kRewriter && option->check_name("--arm")) {
        continue;
      } else if (fs::is_regular_file(value, error)) {
        inputs.push_back({option->get_name(), value});
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

}  // namespace limber
