#include "temporary_file.hpp"

#include <signal.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdint>
#include <iterator>
#include <mutex>
#include <optional>
#include <regex>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"

namespace limber {

namespace {

constexpr std::string_view kEnd = ".tmp";
constexpr std::size_t kLongestName = NAME_MAX;

/// Host and namespace of process numbers: containers may share the host's name, never the latter.
std::string host() {
  std::array<char, HOST_NAME_MAX + 1> name{};
  if (::gethostname(name.data(), name.size() - 1) != 0) {
    name.fill('\0');
  }
  std::string text = name.data();
  for (char& c : text) {
    const bool plain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
    c = plain ? c : '_';
  }
  std::error_code error;
  std::string space = fs::read_symlink("/proc/self/ns/pid", error).string();  // "pid:[4026531836]"
  std::erase_if(space, [](char c) { return c < '0' || c > '9'; });
  return fmt::format("{}-{}", text, space);
}

/// When a process began, in the kernel's ticks since boot, or "ended" where only its parent has not
/// heard of its end, which some containers' first process never does; none if that can't be read.
std::optional<std::string> start_of(const std::string& process) {
  constexpr int kFieldsBefore =
      20;  // proc(5): the start is field 22; the name, field 2, ends at ')'
  std::string text;
  try {
    text = read_file(fmt::format("/proc/{}/stat", process));
  } catch (const std::exception&) {
    return std::nullopt;
  }
  std::size_t position = text.rfind(')');
  if (position != text.npos && text.substr(position).starts_with(") Z")) {
    return "ended";
  }
  for (int i = 0; i < kFieldsBefore && position != text.npos; ++i) {
    position = text.find(' ', position + 1);
  }
  if (position == text.npos) {
    return std::nullopt;
  }
  return text.substr(position + 1, text.find(' ', position + 1) - position - 1);
}

/// In doubt, it runs.
bool runs(const std::string& process, const std::string& start) {
  if (::kill(static_cast<pid_t>(std::stol(process)), 0) != 0 && errno == ESRCH) {
    return false;
  }
  const std::optional<std::string> found = start_of(process);
  return !found || *found == start;
}

/// Whether `name` is one that a process of this host gave, and that process has ended.
bool is_abandoned(const std::string& name, const std::string& own_host) {
  // .NAME.HOST.PID-START-N before the end; Linux' process numbers have at most seven digits.
  static const std::regex form(R"(\.[\s\S]*\.([^.]*)\.(\d{1,9})-(\d+)-\d+)");
  std::smatch parts;
  return name.ends_with(kEnd) &&
         std::regex_match(name.begin(), name.end() - std::ssize(kEnd), parts, form) &&
         parts[1] == own_host && !runs(parts[2], parts[3]);
}

}  // namespace

std::string temporary_name(const std::string& name) {
  static std::atomic<std::uint64_t> count{0};
  const std::string rest = fmt::format(".{}.{}-{}-{}{}", host(), ::getpid(),
                                       start_of("self").value_or("0"), count++, kEnd);
  std::string shortened = name.substr(0, kLongestName - 1 - rest.size());
  // Not within a character of several bytes: some file systems take UTF-8 alone.
  while (shortened.size() < name.size() && !shortened.empty() &&
         (static_cast<unsigned char>(name[shortened.size()]) & 0xC0U) == 0x80U) {
    shortened.pop_back();
  }
  return "." + shortened + rest;
}

void remove_abandoned_files(const fs::path& folder) {
  const std::string own_host = host();
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (is_abandoned(entry->path().filename().string(), own_host)) {
      std::error_code ignored;  // a file that stays does no harm
      fs::remove(entry->path(), ignored);
    }
  }
}

void remove_abandoned_files_once(const fs::path& folder) {
  static std::mutex mutex;
  static std::set<std::string> done;
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(folder, error);
  const std::lock_guard lock(mutex);
  if (done.insert(error ? folder.string() : whole.string()).second) {
    remove_abandoned_files(folder);
  }
}

}  // namespace limber
