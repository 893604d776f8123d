#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace limber {

/// 128 random bits of the system, as 32 hexadecimal digits. @throws SystemFault
std::string make_token();

/// Takes the same time wherever they differ.
bool is_same_secret(std::string_view a, std::string_view b);

/// Value of the cookie `name` in a Cookie header; empty: there is none.
std::string cookie_value(std::string_view header, std::string_view name);

/// Whether a Host header names this machine itself, at any port (an SSH tunnel may have another),
/// or what `listen` names. Everything else is another site whose name was made to lead here.
bool is_own_host(std::string_view host, std::string_view listen);

/// Whether a request with this Origin header comes from the page itself. Requests that change
/// something must say where they come from.
bool is_own_origin(std::string_view origin, std::string_view host, bool changes_something);

/// Whether a browser says with Sec-Fetch-Site that the page itself, or a person, asks. The cookie
/// is sent from all ports of a host, and a GET may come without an Origin. Scripts say nothing.
bool is_own_site(std::string_view sec_fetch_site);

/// So many requests per second on the average, and so many at once. Threads: one at a time.
class RateLimit {
 public:
  using Clock = std::chrono::steady_clock;
  RateLimit(double per_second, double at_once)
      : per_second_(per_second), at_once_(at_once), left_(at_once) {}
  /// Counts a request; false: it is one too many.
  bool admits(Clock::time_point now);

 private:
  double per_second_;
  double at_once_;
  double left_;
  Clock::time_point last_{};
};

}  // namespace limber
