#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

#include "connections.hpp"
#include "limber/common/json.hpp"

namespace limber {

enum HttpStatus {
  kSeeOther = 303,
  kBadRequest = 400,
  kForbidden = 403,
  kNotFound = 404,
  kConflict = 409,
  kIsThere = 412,
  kLengthRequired = 411,
  kTooLarge = 413,
  kUnsupportedMedia = 415,
  kTooManyRequests = 429,
  kInternalError = 500,
};

/// As they are: what set_content() is given, cpp-httplib packs with Brotli at its highest level
/// for each request, which takes a second for the page and shortens no way within one machine.
/// @param owner  keeps `bytes` until they are sent
inline void send(httplib::Response& response, std::string_view bytes, const char* media_type,
                 std::shared_ptr<const void> owner = nullptr) {
  response.headers.erase("Content-Type");  // of an answer that this one replaces
  response.set_content_provider(
      bytes.size(), media_type,
      [bytes, owner = std::move(owner)](std::size_t at, std::size_t size, httplib::DataSink& sink) {
        return at < bytes.size() &&
               sink.write(bytes.data() + at, std::min(size, bytes.size() - at));
      });
}

inline void answer(httplib::Response& response, const Json& json, int status = 200) {
  response.status = status;
  // What a file is called may be no UTF-8.
  const auto text = std::make_shared<const std::string>(
      json.dump(-1, ' ', false, Json::error_handler_t::replace));
  send(response, *text, "application/json", text);
}

/// Says why. @return what ends the request
inline httplib::Server::HandlerResponse refuse(httplib::Response& response, int status,
                                               const std::string& why) {
  answer(response, {{"error", why}}, status);
  return httplib::Server::HandlerResponse::Handled;
}

/// @param why_not  empty: it is done
inline void require_done(const std::string& why_not, httplib::Response& response) {
  if (!why_not.empty()) {
    refuse(response, kConflict, why_not);
  }
}

}  // namespace limber
