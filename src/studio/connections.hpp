#pragma once

#include <httplib.h>
#undef _res  // <resolv.h> makes it a macro; Eigen has parameters of that name

#include <atomic>
#include <chrono>
#include <functional>
#include <list>
#include <mutex>

namespace limber {

/// cpp-httplib's server, for connections that may be hostile. As it stands, one that sends a byte
/// now and then keeps a thread for ever, a body that is too long is read to its end, and whoever
/// opens many connections shuts out all others. Here:
///  - a request has kRequestS seconds to arrive, and kMaxBody bytes beside its headers;
///  - a request with a body is the last one of its connection: what follows a refused one is not
///    read;
///  - at kMaxConnections, the oldest connection that has not shown the token is closed.
class GuardedServer final : public httplib::Server {
 public:
  static constexpr int kMaxConnections = 64;
  static constexpr std::size_t kMaxBody = 256 * 1024;  // 2000 corners of obstacles are 60 kB
  static constexpr std::size_t kMaxHeaders = 32 * 1024;
  static constexpr std::chrono::seconds kRequestTime{5};
  static constexpr std::chrono::seconds kIdleTime{5};

  /// @param is_trusted  whether a request shows the token
  explicit GuardedServer(std::function<bool(const httplib::Request&)> is_trusted);

  /// Ends every connection; then `listen_after_bind` returns.
  void close_all();

 private:
  struct Connection {
    socket_t socket;
    bool trusted = false;
  };
  class Queue;

  bool process_and_close_socket(socket_t socket) override;
  bool serve_one(socket_t socket, Connection& connection);
  void close_oldest();

  std::function<bool(const httplib::Request&)> is_trusted_;
  std::mutex mutex_;
  std::list<Connection> connections_;
  std::atomic<int> waiting_ = 0;  // connections without a thread
  std::atomic<bool> closing_ = false;
};

}  // namespace limber
