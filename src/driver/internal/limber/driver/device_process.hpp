#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <string_view>

#include "limber/arm/backbone.hpp"
#include "limber/common/filesystem.hpp"

namespace limber {

/// The board behind a driver, simulated as a process of its own that outlives the driver: it logs
/// what it is told, and vents when it is told nothing for 0.2 s or its line goes dead. It stands
/// for firmware, whose watchdog has to be tested with the driver killed or stopped.
class DeviceProcess {
 public:
  /// Does nothing where `log` is empty. To be made before any thread.
  /// @throws SystemFault where the log or the process can't be made.
  explicit DeviceProcess(const fs::path& log);
  ~DeviceProcess();
  DeviceProcess(const DeviceProcess&) = delete;
  DeviceProcess& operator=(const DeviceProcess&) = delete;

  void set(const Pressures& setpoint_kpa);
  void vent(std::string_view why);
  /// Notes a fault that the driver is about to play.
  void note(std::string_view kind, int frame);

 private:
  void tell(const std::string& line);

  int line_ = -1;
  pid_t process_ = -1;
};

}  // namespace limber
