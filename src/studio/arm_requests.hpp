#pragma once

#include <functional>
#include <string>

#include "arm_station.hpp"
#include "connections.hpp"
#include "limber/common/json_reader.hpp"
#include "tabs.hpp"

namespace limber {

/// The requests of `/api/arm/…` (docs/studio_api.md).
/// @param station  null: the studio was started without a driver
/// @param post     adds one: its path, and what answers it
void add_arm_requests(
    ArmStation* station, Tabs& tabs,
    const std::function<void(const char* path,
                             std::function<void(const JsonReader&, httplib::Response&)>)>& post);

}  // namespace limber
