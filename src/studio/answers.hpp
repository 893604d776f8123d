#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "connections.hpp"

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

inline void answer(httplib::Response& response, const nlohmann::ordered_json& json,
                   int status = 200) {
  response.status = status;
  // What a file is called may be no UTF-8.
  response.set_content(json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace),
                       "application/json");
}

/// Says why. @return what ends the request
inline httplib::Server::HandlerResponse refuse(httplib::Response& response, int status,
                                               const std::string& why) {
  answer(response, {{"error", why}}, status);
  return httplib::Server::HandlerResponse::Handled;
}

}  // namespace limber
