#include "campaign_units.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <sstream>

#include <CLI/CLI.hpp>

#include "command_line.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/descriptor.hpp"
#include "limber/common/error.hpp"
#include "limber/common/file_error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/folder_lock.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/json.hpp"
#include "limber/common/json_reader.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/seconds_since.hpp"
#include "limber/lab/campaign_report.hpp"
#include "verbs.hpp"

namespace limber {

namespace {

constexpr const char* kLevelVariable = "LIMBER_CPU";
constexpr const char* kLibraryVariable = "GLIBC_TUNABLES";
constexpr const char* kArm = "arm";
constexpr const char* kArmParameter = "arm.";
constexpr const char* kEnvironments = "environments";

/// glibc's sin, exp and the like have versions with FMA that round otherwise.
const char* library_setting(CpuLevel level) {
  return level == CpuLevel::baseline ? "glibc.cpu.hwcaps=-AVX,-AVX2,-FMA,-FMA4"
                                     : "glibc.cpu.hwcaps=-FMA4";
}

/// A standard stream of the whole process in a file, as long as this lives.
class Redirected {
 public:
  Redirected(int stream, const fs::path& path) : stream_(stream), kept_(flushed_copy(stream)) {
    const Descriptor file(path, O_WRONLY | O_CREAT | O_TRUNC);
    if (!file.is_open()) {
      throw_fault(path, "can't be written", errno);
    }
    ::dup2(file.get(), stream_);
  }
  ~Redirected() {
    flush();
    ::dup2(kept_.get(), stream_);
  }
  Redirected(const Redirected&) = delete;
  Redirected& operator=(const Redirected&) = delete;

 private:
  /// What one unit could not write is no fault of the next one.
  static void flush() {
    std::fflush(nullptr);
    std::clearerr(stdout);
    std::clearerr(stderr);
  }
  static int flushed_copy(int stream) {
    flush();
    return ::fcntl(stream, F_DUPFD_CLOEXEC, 0);
  }
  int stream_;
  Descriptor kept_;
};

/// As main and exec take them.
std::vector<char*> pointers_to(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  std::ranges::transform(words, std::back_inserter(pointers),
                         [](std::string& word) { return word.data(); });
  pointers.push_back(nullptr);
  return pointers;
}

int run(const std::vector<std::string>& command) {
  std::vector<std::string> words = command;
  words.insert(words.begin(), "limber");
  return run_command_line(int(words.size()), pointers_to(words).data());
}

/// This process's command line, as the system has it: each word ends with a zero.
std::vector<std::string> own_command() {
  std::vector<std::string> words;
  std::istringstream text(read_file("/proc/self/cmdline"));
  for (std::string word; std::getline(text, word, '\0');) {
    words.push_back(word);
  }
  return words;
}

/// The command line of a verb, while `use` looks at it. Nothing where there is no such verb.
template <class Use>
void with_command_line(const std::string& verb_name, const Use& use) {
  CommonFlags flags;
  for (const std::unique_ptr<Verb>& verb : all_verbs()) {
    if (verb->name() == verb_name) {
      CLI::App app(verb->summary(), verb->name());
      add_common_flags(app, flags);
      verb->add_flags(app);
      use(app);
    }
  }
}

bool has_flag(const std::string& verb_name, const std::string& flag) {
  bool found = false;
  with_command_line(verb_name,
                    [&](CLI::App& app) { found = app.get_option_no_throw(flag) != nullptr; });
  return found;
}

/// @param command  begins with its verb. What is on unless it is said otherwise has a flag
/// --no-NAME.
void add_flag(std::vector<std::string>& command, const std::string& name,
              const FlagValues& values) {
  for (const std::string& value : values) {
    if (value != "false") {
      command.push_back("--" + name);
    } else if (const std::string off = "--no-" + name; has_flag(command.front(), off)) {
      command.push_back(off);
    }
    if (value != "false" && value != "true") {
      command.push_back(value);
    }
  }
}

bool is_arm_parameter(const std::string& name) {
  return name.rfind(kArmParameter, 0) == 0;
}

Flags arm_parameters(const CampaignUnit& unit) {
  Flags parameters;
  for (const auto& [name, values] : unit.flags) {
    if (is_arm_parameter(name)) {
      parameters.emplace_back(name.substr(std::string(kArmParameter).size()), values);
    }
  }
  return parameters;
}

const char* out_name(const Campaign& campaign, const CampaignUnit& unit) {
  if (campaign.verb == "collect") {
    return kUnitRecording;
  }
  if (campaign.verb == "experiment") {
    return kUnitExperiment;
  }
  const bool makes_model = campaign.verb == "train" || (campaign.verb == "calibrate" &&
                                                        values_in(unit.flags, "check") == nullptr);
  return makes_model ? kUnitModel : nullptr;
}

}  // namespace

void use_cpu_level(const Campaign& campaign) {
  const char* level = to_string(campaign.cpu);
  const std::vector<CpuLevel> available = available_cpu_levels();
  refuse_if(std::ranges::find(available, campaign.cpu) == available.end(),
            "the campaign runs at CPU level {}, which this machine lacks; its units would differ",
            level);
  const char* is = std::getenv(kLibraryVariable);
  const char* wanted = library_setting(campaign.cpu);
  ::setenv(kLevelVariable, level, 1);
  if (is == nullptr || std::string(is) != wanted) {
    ::setenv(kLibraryVariable, wanted, 1);
    std::vector<std::string> words = own_command();
    ::execv("/proc/self/exe", pointers_to(words).data());
    throw SystemFault(fmt::format("the program can't be started again: {}", std::strerror(errno)));
  }
}

/// The verb and the unit's own flags; its arm where the campaign changes that.
std::vector<std::string> own_flags(const Campaign& campaign, const CampaignUnit& unit,
                                   const fs::path& folder) {
  std::vector<std::string> command = {campaign.verb};
  const bool has_own_arm = !arm_parameters(unit).empty();
  for (const auto& [name, values] : unit.flags) {
    if (!is_arm_parameter(name) && !(has_own_arm && name == kArm)) {
      add_flag(command, name, values);
    }
  }
  if (has_own_arm) {
    add_flag(command, kArm, {(folder / "arm.yaml").string()});
  }
  return command;
}

std::vector<std::string> unit_command(const Campaign& campaign, const CampaignUnit& unit,
                                      const fs::path& folder, int jobs) {
  std::vector<std::string> command = own_flags(campaign, unit, folder);
  if (const char* name = out_name(campaign, unit)) {
    add_flag(command, "out", {(folder / name).string()});
  }
  const bool goes_on =
      campaign.verb == "train" && fs::exists(folder / (std::string(kUnitModel) + ".checkpoint"));
  command.insert(command.end(),
                 {goes_on ? "--resume" : "--force", "--json", "--jobs", std::to_string(jobs)});
  return command;
}

void require_known_flags(const Campaign& campaign, const CampaignUnit& unit) {
  with_command_line(campaign.verb, [&](CLI::App& app) {
    std::vector<std::string> command = unit_command(campaign, unit, "unit", 1);
    command.erase(command.begin());
    std::ranges::reverse(command);  // as CLI11 takes a vector
    try {
      app.parse(command);
    } catch (const CLI::ParseError& error) {
      throw InputError(
          fmt::format("unit {}: limber {}: {}", unit.index, campaign.verb, error.what()));
    }
  });
}

void require_forests(const Campaign& campaign) {
  const auto require = [](const std::string& flag, const FlagValues& values) {
    for (const std::string& path : values) {
      refuse_if(flag == "forest" && !fs::exists(path),
                "forest: '{}': not found; grow it first, limber plan --build-forest", path);
    }
  };
  for (const auto& [flag, values] : campaign.flags) {
    require(flag, values);
  }
  for (const CampaignFactor& factor : campaign.factors) {
    for (const FlagValues& values : factor.choices) {
      require(factor.name, values);
    }
  }
}

void require_known_parameters(const CampaignUnit& unit) {
  if (const Flags parameters = arm_parameters(unit); !parameters.empty()) {
    (void)arm_with(find_arm_file(arm_of(unit)), parameters);
  }
}

bool run_unit(const Campaign& campaign, const CampaignUnit& unit, CampaignFolder& folder,
              int jobs) {
  const auto begin = std::chrono::steady_clock::now();
  const fs::path own = folder.unit_folder(unit.index);
  const fs::path output = own / "result.json";
  int code = kExitFault;
  const FolderLock lock(own, "limber campaign");  // of the same command, given twice
  if (folder.state(unit) == UnitState::done) {
    return true;  // meanwhile, by the other
  }
  folder.begin(unit);
  {
    const Redirected out(STDOUT_FILENO, output), err(STDERR_FILENO, own / "log.txt");
    try {
      if (const Flags parameters = arm_parameters(unit); !parameters.empty()) {
        write_file_atomically(own / "arm.yaml", arm_with(find_arm_file(arm_of(unit)), parameters));
      }
      code = run(unit_command(campaign, unit, own, jobs));
    } catch (const std::exception& error) {
      print_error(error.what());
    }
  }
  if (interrupt_requested()) {
    return true;
  }
  if (code != kExitDone) {
    folder.fail(unit, code);
    return false;
  }
  const Json result = Json::parse(read_file(output));
  fs::remove(output);
  folder.finish(unit, result, seconds_since(begin));
  return true;
}

bool can_join_experiments(const Campaign& campaign) {
  const bool differs = std::ranges::any_of(
      campaign.factors, [](const CampaignFactor& factor) { return factor.name != kEnvironments; });
  if (campaign.random_count > 0 || campaign.repeat > 1 || differs) {
    return false;
  }
  for (std::size_t i = 0; i < unit_count(campaign); ++i) {
    const Flags flags = campaign_unit(campaign, i).flags;
    const FlagValues* places = values_in(flags, kEnvironments);
    if (places == nullptr || places->size() != 1 || fs::is_directory(places->front())) {
      return false;
    }
  }
  return true;
}

int join_experiments(const Campaign& campaign, CampaignFolder& folder) {
  CampaignUnit first = campaign_unit(campaign, 0);
  std::erase_if(first.flags, [](const auto& flag) { return flag.first == kEnvironments; });
  std::vector<std::string> command = own_flags(campaign, first, folder.unit_folder(0));
  for (std::size_t i = 0; i < unit_count(campaign); ++i) {
    add_flag(command, kEnvironments, *values_in(campaign_unit(campaign, i).flags, kEnvironments));
    add_flag(command, "join", {(folder.unit_folder(i) / kUnitExperiment).string()});
  }
  add_flag(command, "out", {(folder.path() / "experiment").string()});
  command.insert(command.end(), {"--force", "--quiet"});
  return run(command);
}

}  // namespace limber
