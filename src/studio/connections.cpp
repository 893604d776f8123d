#include "connections.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <utility>

namespace limber {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kPollMs = 100;  // how soon a closing server is noticed
constexpr std::chrono::seconds kWriteTime{5};

bool is_ready(socket_t socket, short events, int timeout_ms) {
  pollfd poll_of{socket, events, 0};
  return poll(&poll_of, 1, timeout_ms) > 0 && (poll_of.revents & events) != 0;
}

int ms_until(Clock::time_point end) {
  return std::max(
      0, int(std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count()));
}

/// One request's bytes: no more than so many, until a time.
class BoundedStream final : public httplib::Stream {
 public:
  BoundedStream(socket_t socket, std::size_t max_bytes, Clock::time_point end)
      : socket_(socket), left_(max_bytes), end_(end) {}

  bool is_readable() const override {
    return at_ < filled_ || is_ready(socket_, POLLIN, ms_until(end_));
  }
  /// False, too, if the other side has gone.
  bool is_writable() const override {
    pollfd poll_of{socket_, POLLOUT | POLLRDHUP, 0};
    return poll(&poll_of, 1, int(kWriteTime.count()) * 1000) > 0 && poll_of.revents == POLLOUT;
  }
  ssize_t read(char* data, size_t size) override {
    if (!is_readable()) {
      return -1;
    }
    if (at_ == filled_) {
      const ssize_t got = recv(socket_, buffer_.data(), std::min(buffer_.size(), left_), 0);
      if (got <= 0) {  // also where nothing is left of what may come
        return -1;
      }
      at_ = 0;
      filled_ = std::size_t(got);
      left_ -= filled_;
    }
    const std::size_t count = std::min(size, filled_ - at_);
    std::copy_n(buffer_.begin() + std::ptrdiff_t(at_), count, data);
    at_ += count;
    return static_cast<ssize_t>(count);
  }
  ssize_t write(const char* data, size_t size) override {
    return is_writable() ? send(socket_, data, size, MSG_NOSIGNAL) : -1;
  }
  void get_remote_ip_and_port(std::string& /*ip*/, int& /*port*/) const override {}
  void get_local_ip_and_port(std::string& /*ip*/, int& /*port*/) const override {}
  socket_t socket() const override { return socket_; }

 private:
  socket_t socket_;
  std::size_t left_;
  Clock::time_point end_;
  std::array<char, 4096> buffer_;
  std::size_t at_ = 0;
  std::size_t filled_ = 0;
};

bool has_body(const httplib::Request& request) {
  return request.has_header("Transfer-Encoding") ||
         (request.has_header("Content-Length") &&
          request.get_header_value("Content-Length") != "0");
}

}  // namespace

/// Threads for all connections that may be open; one more connection costs the oldest stranger.
class GuardedServer::Queue final : public httplib::TaskQueue {
 public:
  explicit Queue(GuardedServer& server) : server_(server), threads_(kMaxConnections) {}
  void enqueue(std::function<void()> serve) override {
    ++server_.waiting_;
    if (++open_ > kMaxConnections) {
      server_.close_oldest();
    }
    threads_.enqueue([this, serve = std::move(serve)] {
      serve();
      --open_;
    });
  }
  void shutdown() override { threads_.shutdown(); }

 private:
  GuardedServer& server_;
  std::atomic<int> open_ = 0;
  httplib::ThreadPool threads_;
};

GuardedServer::GuardedServer(std::function<bool(const httplib::Request&)> is_trusted)
    : is_trusted_(std::move(is_trusted)) {
  new_task_queue = [this] { return new Queue(*this); };
  set_tcp_nodelay(true);
  set_payload_max_length(kMaxBody);
}

void GuardedServer::close_all() {
  closing_ = true;
  stop();
}

/// Its thread closes it.
void GuardedServer::close_oldest() {
  const std::lock_guard lock(mutex_);
  const auto stranger =
      std::ranges::find_if(connections_, [](const Connection& one) { return !one.trusted; });
  if (stranger != connections_.end()) {
    shutdown(stranger->socket, SHUT_RDWR);
    stranger->trusted = true;  // closed once
  }
}

bool GuardedServer::process_and_close_socket(socket_t socket) {
  std::list<Connection>::iterator own;
  bool is_full = false;  // else those that wait have threads of their own in a moment
  {
    const std::lock_guard lock(mutex_);
    own = connections_.insert(connections_.end(), {socket});
    is_full = connections_.size() >= kMaxConnections;
  }
  if (--waiting_ > 0 && is_full) {
    close_oldest();  // a crowd that came at once goes through one by one
  }
  Clock::time_point idle_end = Clock::now() + kIdleTime;
  while (!closing_ && Clock::now() < idle_end) {
    if (is_ready(socket, POLLIN, kPollMs)) {
      if (!serve_one(socket, *own)) {
        break;
      }
      idle_end = Clock::now() + kIdleTime;
    }
  }
  {
    const std::lock_guard lock(mutex_);
    connections_.erase(own);
  }
  shutdown(socket, SHUT_RDWR);
  ::close(socket);
  return true;
}

/// False: no other request may follow.
bool GuardedServer::serve_one(socket_t socket, Connection& connection) {
  BoundedStream stream(socket, kMaxHeaders + kMaxBody, Clock::now() + kRequestTime);
  bool is_last = false;
  bool closed = false;
  const auto look_at = [&](httplib::Request& request) {
    request.ranges.clear();  // 0.11.4 does not hold them against the length of what is sent
    request.headers.erase("Range");
    if (is_trusted_(request)) {
      const std::lock_guard lock(mutex_);
      connection.trusted = true;
    }
    if (has_body(request)) {
      is_last = true;
      request.headers.erase("Connection");
      request.set_header("Connection", "close");  // and the answer says so
    }
  };
  return process_request(stream, false, closed, look_at) && !is_last && !closed;
}

}  // namespace limber
