#include "admission.hpp"

#include <fmt/format.h>

#include "answers.hpp"

namespace limber {

namespace {

using httplib::Request;
using httplib::Response;
using Outcome = httplib::Server::HandlerResponse;

Outcome admit_body(const Request& request, Response& response) {
  if (request.has_header("Transfer-Encoding") || !request.has_header("Content-Length")) {
    return refuse(response, kLengthRequired, "Content-Length: expected");
  }
  const std::string length = request.get_header_value("Content-Length");
  constexpr std::size_t kMaxDigits = 9;
  if (length.empty() || length.size() > kMaxDigits ||
      length.find_first_not_of("0123456789") != std::string::npos ||
      std::stoul(length) > GuardedServer::kMaxBody) {
    return refuse(response, kTooLarge, "Content-Length: expected at most 262144");
  }
  if (!request.get_header_value("Content-Type").starts_with("application/json")) {
    return refuse(response, kUnsupportedMedia, "Content-Type: expected application/json");
  }
  if (request.has_header("Content-Encoding")) {  // the server would unpack it, however large
    return refuse(response, kUnsupportedMedia, "Content-Encoding: expected none");
  }
  return Outcome::Unhandled;
}

}  // namespace

void Admission::set_port(int port) {
  cookie_ = fmt::format("limber_studio_{}", port);
}

bool Admission::shows_token(const Request& request) const {
  return is_same_secret(cookie_value(request.get_header_value("Cookie"), cookie_), token_);
}

Outcome Admission::admit(const Request& request, Response& response) {
  const std::string host = request.get_header_value("Host");
  const bool changes = request.method != "GET" && request.method != "HEAD";
  if (request.get_header_value_count("Host") != 1 || !is_own_host(host, listen_)) {
    return refuse(response, kForbidden, "Host: expected this machine");
  }
  if (!is_own_origin(request.get_header_value("Origin"), host, changes)) {
    return refuse(response, kForbidden, "Origin: expected this page");
  }
  const bool is_of_api = request.path.starts_with("/api/");  // links lead from anywhere to the page
  if (is_of_api && !is_own_site(request.get_header_value("Sec-Fetch-Site"))) {
    return refuse(response, kForbidden, "Sec-Fetch-Site: expected same-origin or none");
  }
  if (request.path == "/" && request.has_param("token")) {
    return enter(request, response);
  }
  if (!shows_token(request)) {
    return refuse(response, kForbidden, "open the address that limber studio printed");
  }
  if (is_one_too_many(request)) {
    return refuse(response, kTooManyRequests, "too many requests");
  }
  return changes ? admit_body(request, response) : Outcome::Unhandled;
}

/// What an arm's safety hangs on is never refused for what others ask.
bool Admission::is_one_too_many(const Request& request) {
  if (request.path == "/api/arm/vent" || request.path == "/api/arm/lease") {
    return false;
  }
  const std::lock_guard lock(rate_mutex_);
  return !rate_.admits(RateLimit::Clock::now());
}

/// The printed address: its token becomes a cookie, and leaves the address bar.
Outcome Admission::enter(const Request& request, Response& response) const {
  if (!is_same_secret(request.get_param_value("token"), token_)) {
    return refuse(response, kForbidden, "open the address that limber studio printed last");
  }
  response.set_header("Set-Cookie",
                      fmt::format("{}={}; HttpOnly; SameSite=Strict; Path=/", cookie_, token_));
  response.set_redirect("/", kSeeOther);
  return Outcome::Handled;
}

}  // namespace limber
