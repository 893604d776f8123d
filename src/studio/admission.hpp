#pragma once

#include <mutex>
#include <string>
#include <utility>

#include "connections.hpp"
#include "request_rules.hpp"

namespace limber {

/// Who may ask, and how much (docs/studio_api.md). What is refused here has no effect, and its body
/// is never read. Threads: any, once the port is known.
class Admission {
 public:
  /// @param listen  address or name of this machine
  explicit Admission(std::string listen) : listen_(std::move(listen)), token_(make_token()) {}

  void set_port(int port);
  const std::string& token() const { return token_; }
  bool shows_token(const httplib::Request& request) const;
  httplib::Server::HandlerResponse admit(const httplib::Request& request,
                                         httplib::Response& response);

 private:
  static constexpr double kRequestsPerS = 400.0;  // a hand drags at the screen's rate, in four tabs
  static constexpr double kRequestsAtOnce = 400.0;

  httplib::Server::HandlerResponse enter(const httplib::Request& request,
                                         httplib::Response& response) const;
  bool is_one_too_many(const httplib::Request& request);

  std::string listen_;
  std::string token_;
  std::string cookie_;
  std::mutex rate_mutex_;
  RateLimit rate_{kRequestsPerS, kRequestsAtOnce};
};

}  // namespace limber
