#include <poll.h>
#include <sys/socket.h>

#include <chrono>
#include <cstdlib>
#include <memory>
#include <thread>

#include <fmt/format.h>

#include "limber/studio/studio.hpp"
#include "support/loopback_socket.hpp"
#include "target.hpp"

namespace limber::fuzz {

namespace {

constexpr int kAnswerMs = 100;  // until a request that is cut short is closed from our side
constexpr int kQuietMs = 2;     // within an answer, on one machine
constexpr int kRunsOfProject = 500;
constexpr auto kRateLimitPause = std::chrono::milliseconds(10);

class Connection {
 public:
  explicit Connection(int port) : socket_(port) {
    require(socket_.is_open(), "the studio takes no connection");
  }

  void send_all(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t sent = send(socket_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (sent <= 0) {
        return;  // it was refused before its end
      }
      bytes.remove_prefix(static_cast<std::size_t>(sent));
    }
  }
  /// What comes until it is quiet for so long, or closed.
  std::string read(int first_ms, int quiet_ms) {
    std::string got;
    char buffer[16384];
    pollfd ready{socket_.get(), POLLIN, 0};
    while (poll(&ready, 1, got.empty() ? first_ms : quiet_ms) > 0) {
      const ssize_t size = recv(socket_.get(), buffer, sizeof buffer, 0);
      if (size <= 0) {
        break;
      }
      got.append(buffer, static_cast<std::size_t>(size));
    }
    return got;
  }
  void end_requests() { shutdown(socket_.get(), SHUT_WR); }

 private:
  LoopbackSocket socket_;
};

/// A studio with one open tab.
class RunningStudio {
 public:
  RunningStudio() {
    setenv("LIMBER_DATA_DIR", LIMBER_SOURCE_DIR, 1);
    const auto project = scratch_folder() / "project";
    std::filesystem::create_directories(project);
    StudioSettings settings;
    settings.port = 0;
    settings.project = project;
    settings.arm = LIMBER_SOURCE_DIR "/arms/three_segment.yaml";
    studio_ = std::make_unique<Studio>(settings);
    server_ = std::thread([this] { studio_->serve(); });
    tab_ = std::make_unique<Connection>(studio_->port());
    tab_->send_all("GET /api/events HTTP/1.1\r\n" + headers() + "\r\n");
    constexpr int kHelloMs = 20000;
    const std::string hello = tab_->read(kHelloMs, kAnswerMs);
    const std::size_t at = hello.find("{\"id\":\"");
    require(at != std::string::npos, "the studio opens no tab: " + hello);
    tab_id_ = hello.substr(at + 7, 32);
  }
  ~RunningStudio() {
    tab_.reset();
    studio_->stop();
    server_.join();
  }
  RunningStudio(const RunningStudio&) = delete;
  RunningStudio& operator=(const RunningStudio&) = delete;

  std::string ask(std::string_view request) {
    if (++runs_ % kRunsOfProject == 0) {
      std::filesystem::remove_all(scratch_folder() / "project/environments");
    }
    (void)tab_->read(0, 0);  // events, so that nobody waits for their reader
    std::string answer;
    do {
      if (!answer.empty()) {
        std::this_thread::sleep_for(kRateLimitPause);
      }
      Connection connection(studio_->port());
      connection.send_all(request);
      answer = connection.read(kAnswerMs, kQuietMs);
      connection.end_requests();
      if (answer.empty()) {
        answer = connection.read(kAnswerMs, kQuietMs);
      }
    } while (answer.starts_with("HTTP/1.1 429"));
    require(answer.empty() || answer.starts_with("HTTP/1.1 "), "no HTTP: " + answer.substr(0, 200));
    require(!answer.starts_with("HTTP/1.1 5"), "an error of its own: " + answer);
    return answer;
  }
  /// With this page's name, cookie and tab in the places that are left for them.
  std::string filled(std::string text) const {
    for (const auto& [place, value] : {std::pair<std::string, std::string>{"@HOST@", host()},
                                       {"@COOKIE@", cookie()},
                                       {"@TAB@", tab_id_}}) {
      for (std::size_t at = text.find(place); at != std::string::npos;
           at = text.find(place, at + value.size())) {
        text.replace(at, place.size(), value);
      }
    }
    return text;
  }
  std::string headers() const {
    return fmt::format("Host: {0}\r\nOrigin: http://{0}\r\nCookie: {1}\r\n", host(), cookie());
  }

 private:
  std::string host() const { return fmt::format("127.0.0.1:{}", studio_->port()); }
  std::string cookie() const {
    return fmt::format("limber_studio_{}={}", studio_->port(), studio_->token());
  }

  std::unique_ptr<Studio> studio_;
  std::thread server_;
  std::unique_ptr<Connection> tab_;
  std::string tab_id_;
  int runs_ = 0;
};

RunningStudio& studio() {
  (void)scratch_folder();  // outlives it
  static RunningStudio running;
  return running;
}

/// Bytes as they come over a connection.
void serve_bytes(const Input& input) {
  (void)studio().ask(studio().filled(std::string(input.bytes)));
}

/// A path and what is posted to it, as by the page.
void serve_json(const Input& input) {
  const std::size_t end = std::min(input.bytes.find('\n'), input.bytes.size());
  const std::string path(input.bytes.substr(0, end));
  if (path.find_first_of("\r ") != std::string::npos) {
    return;  // for serve_bytes
  }
  const auto post = [](const std::string& to, const std::string& body) {
    return studio().ask(
        fmt::format("POST {} HTTP/1.1\r\n{}Content-Type: application/json\r\n"
                    "Content-Length: {}\r\n\r\n{}",
                    to, studio().headers(), body.size(), body));
  };
  const std::string body(input.bytes.substr(std::min(end + 1, input.bytes.size())));
  if (post(path, studio().filled(body)).starts_with("HTTP/1.1 200")) {
    (void)post("/api/stop", studio().filled(R"({"tab":"@TAB@"})"));
  }
}

}  // namespace

std::vector<Target> studio_targets() {
  return {{"http", "", serve_bytes}, {"studio", "", serve_json}};
}

}  // namespace limber::fuzz
