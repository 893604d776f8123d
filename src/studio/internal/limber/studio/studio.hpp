#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "limber/common/filesystem.hpp"
#include "limber/driver/process_driver.hpp"

namespace limber {

struct StudioSettings {
  static constexpr int kDefaultPort = 8750;

  std::string listen = "127.0.0.1";  ///< address or name of this machine to listen at
  int port = kDefaultPort;           ///< 0: any that is free
  fs::path project = ".";
  fs::path arm;    ///< shown first
  fs::path model;  ///< shown first; empty: the simple model
  /// How `arm` is reached: command, calibration, safety, and who is told of vents. None: nothing
  /// but models and virtual arms is moved.
  std::optional<ProcessDriverSettings> driver;
};

/// The browser studio's server (docs/studio.md, docs/studio_api.md): the page, and a JSON API for
/// it that nobody can use who does not know its token.
class Studio {
 public:
  /// Listens. @throws InputError if the project is no folder, or the port is taken.
  explicit Studio(const StudioSettings& settings);
  ~Studio();

  int port() const;
  const std::string& token() const;
  /// Where the page is, token included.
  std::string address() const;

  /// Serves until `stop`, on threads of its own.
  void serve();
  /// Safe from any thread.
  void stop();

 private:
  class Server;
  std::unique_ptr<Server> server_;
};

}  // namespace limber
