#include "request_rules.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include <sys/random.h>

#include <fmt/format.h>

#include "limber/common/error.hpp"

namespace limber {

namespace {

std::string lower_case(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return result;
}

/// Without the port; of "[::1]:80" what stands in brackets. Empty if it is malformed.
std::string host_name(std::string_view host) {
  const bool bracketed = host.starts_with('[');
  const std::size_t end = bracketed ? host.find(']') : host.find(':');
  if (bracketed && end == std::string_view::npos) {
    return "";
  }
  const std::string_view port =
      end == std::string_view::npos ? "" : host.substr(bracketed ? end + 1 : end);
  const bool has_port =
      port.size() > 1 && port.front() == ':' &&
      std::ranges::all_of(port.substr(1), [](char c) { return c >= '0' && c <= '9'; });
  if (!port.empty() && !has_port) {
    return "";
  }
  return lower_case(host.substr(bracketed ? 1 : 0, bracketed ? end - 1 : end));
}

}  // namespace

std::string make_token() {
  std::array<unsigned char, 16> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
    throw SystemFault(fmt::format("no random numbers: {}", std::strerror(errno)));
  }
  std::string token;
  for (const unsigned char byte : bytes) {
    token += fmt::format("{:02x}", byte);
  }
  return token;
}

bool is_same_secret(std::string_view a, std::string_view b) {
  unsigned difference = a.size() == b.size() ? 0U : 1U;
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i) {
    difference |= static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]);
  }
  return difference == 0U;
}

std::string cookie_value(std::string_view header, std::string_view name) {
  while (!header.empty()) {
    const std::size_t end = std::min(header.find(';'), header.size());
    std::string_view pair = header.substr(0, end);
    header.remove_prefix(std::min(end + 1, header.size()));
    pair.remove_prefix(std::min(pair.find_first_not_of(' '), pair.size()));
    if (pair.size() > name.size() && pair.starts_with(name) && pair[name.size()] == '=') {
      return std::string(pair.substr(name.size() + 1));
    }
  }
  return "";
}

bool is_own_host(std::string_view host, std::string_view listen) {
  const std::string name = host_name(host);
  return !name.empty() && (name == "127.0.0.1" || name == "localhost" || name == "::1" ||
                           name == lower_case(listen));
}

bool is_own_origin(std::string_view origin, std::string_view host, bool changes_something) {
  return origin.empty() ? !changes_something : lower_case(origin) == "http://" + lower_case(host);
}

bool is_own_site(std::string_view sec_fetch_site) {
  return sec_fetch_site.empty() || sec_fetch_site == "same-origin" || sec_fetch_site == "none";
}

bool RateLimit::admits(Clock::time_point now) {
  const double seconds = std::chrono::duration<double>(now - last_).count();
  last_ = now;
  left_ = std::min(at_once_, left_ + seconds * per_second_);
  if (left_ < 1.0) {
    return false;
  }
  left_ -= 1.0;
  return true;
}

}  // namespace limber
