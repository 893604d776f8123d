#include "driver_log.hpp"

#include <pwd.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <ctime>
#include <system_error>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/common/error.hpp"
#include "limber/common/version.hpp"
#include "run_origin.hpp"

namespace limber {

namespace {

constexpr std::size_t kMaxLogged = 4096;  // of a line that is no JSON: what a broken driver sends

std::string as_text(std::string_view text) {
  return nlohmann::json(std::string(text.substr(0, kMaxLogged)))
      .dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

}  // namespace

DriverLog::DriverLog(const std::filesystem::path& path, std::string_view command) {
  if (path.empty()) {
    return;
  }
  file_.reset(std::fopen(path.c_str(), "we"));
  if (!file_) {
    throw SystemFault(fmt::format("{}: {}", path.string(), std::generic_category().message(errno)));
  }
  const nlohmann::ordered_json first = {
      {"schema", "limber/driver_log/1"},
      {"limber", version()},
      {"started_by", who_started_this()},
      {"started_at", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)))},
      {"command", std::string(command)}};
  fmt::print(file_.get(), "{}\n",
             first.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
  std::fflush(file_.get());
}

void DriverLog::note(std::string_view text) {
  write("note", as_text(text));
}

void DriverLog::write(const char* key, std::string_view line) {
  if (!file_) {
    return;
  }
  const double at_s =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";  // which only a whole text may have
  const bool is_json = !line.starts_with(kByteOrderMark) && nlohmann::json::accept(line);
  const std::string body = is_json ? std::string(line) : as_text(line);
  const std::string text = fmt::format("{{\"at_s\": {:.6f}, \"{}\": {}}}\n", at_s, key, body);
  if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size() ||
      std::fflush(file_.get()) != 0) {
    file_.reset();
  }
}

std::string who_started_this() {
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  std::array<char, 4096> room{};
  passwd entry{};
  passwd* found = nullptr;
  ::getpwuid_r(::getuid(), &entry, room.data(), room.size(), &found);
  const std::string user = found != nullptr ? found->pw_name : fmt::format("user {}", ::getuid());
  return fmt::format("{}@{}", user, host.data());
}

}  // namespace limber
