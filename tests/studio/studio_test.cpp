#include "limber/studio/studio.hpp"

#include <poll.h>
#include <sys/socket.h>

#include <chrono>
#include <thread>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "limber/common/atomic_file.hpp"
#include "limber/common/data_folder.hpp"
#include "limber/common/error.hpp"
#include "limber/world/environment.hpp"
#include "limber/world/plan.hpp"
#include "support/loopback_socket.hpp"

namespace limber {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
using ::testing::ThrowsMessage;

constexpr int kPatienceMs = 20000;  // on a busy machine; nothing is expected to take so long

/// A connection that sends whatever it likes.
class RawClient {
 public:
  explicit RawClient(int port) : socket_(port) { EXPECT_TRUE(socket_.is_open()); }

  bool send(const std::string& text) {
    return ::send(socket_.get(), text.data(), text.size(), MSG_NOSIGNAL) ==
           static_cast<ssize_t>(text.size());
  }
  /// Until `end` is among what came, the other side closes, or patience is at an end.
  std::string read_until(const std::string& end) {
    while (received_.find(end) == std::string::npos) {
      pollfd ready{socket_.get(), POLLIN, 0};
      char buffer[4096];
      if (poll(&ready, 1, kPatienceMs) <= 0) {
        ADD_FAILURE() << "nothing more came after: " << received_;
        break;
      }
      const ssize_t got = recv(socket_.get(), buffer, sizeof buffer, 0);
      if (got <= 0) {
        break;
      }
      received_.append(buffer, static_cast<std::size_t>(got));
    }
    return received_;
  }
  std::string read_to_the_end() { return read_until("no such text"); }

 private:
  LoopbackSocket socket_;
  std::string received_;
};

class StudioServer : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    write_file_atomically(folder_ / "project/readme.txt", "x");
    write_file_atomically(folder_ / "secret.yaml", "schema: limber/environment/1\nSECRET\n");
    StudioSettings settings;
    settings.port = 0;
    settings.project = folder_ / "project";
    settings.arm = data_folder() / "arms/three_segment.yaml";
    studio_ = std::make_unique<Studio>(settings);
    server_ = std::thread([this] { studio_->serve(); });
  }
  void TearDown() override {
    studio_->stop();
    server_.join();
    fs::remove_all(folder_);
  }

  std::string host() const { return "127.0.0.1:" + std::to_string(studio_->port()); }
  std::string cookie() const {
    return "Cookie: limber_studio_" + std::to_string(studio_->port()) + "=" + studio_->token() +
           "\r\n";
  }
  std::string own_headers() const {
    return "Host: " + host() + "\r\nOrigin: http://" + host() + "\r\n" + cookie();
  }
  /// The whole answer to one request. @param headers  each with its line's end
  std::string ask(const std::string& line, const std::string& headers,
                  const std::string& body = "") const {
    RawClient client(studio_->port());
    client.send(line + " HTTP/1.1\r\n" + headers + "Connection: close\r\n\r\n" + body);
    return client.read_to_the_end();
  }
  std::string get(const std::string& path) const { return ask("GET " + path, own_headers()); }
  std::string post(const std::string& path, const std::string& body) const {
    return ask("POST " + path,
               own_headers() + "Content-Type: application/json\r\nContent-Length: " +
                   std::to_string(body.size()) + "\r\n",
               body);
  }
  /// Opens the page's events, and asks for a plan round the pillar with the search's tree.
  nlohmann::json question(RawClient& page) const {
    page.send("GET /api/events HTTP/1.1\r\n" + own_headers() + "\r\n");
    const std::string hello = page.read_until("\"}");
    const std::string answer =
        get("/api/environment?arm=limber:three_segment&name=limber:01_pillar");
    return {{"tab", hello.substr(hello.find("{\"id\":\"") + 7, 32)},
            {"request", 7},
            {"arm", "limber:three_segment"},
            {"model", ""},
            {"environment", nlohmann::json::parse(answer.substr(answer.find("\r\n\r\n") + 4))},
            {"time_limit_s", 20.0},
            {"limit_scale", 1.0},
            {"margin_m", nullptr},
            {"seed", 1},
            {"tree", true}};
  }

  fs::path folder_ =
      fs::canonical(fs::temp_directory_path()) / ("limber_studio_" + std::to_string(::getpid()));
  std::unique_ptr<Studio> studio_;
  std::thread server_;
};

TEST_F(StudioServer, ThePrintedAddressGivesACookieForThisSiteAlone) {
  const std::string answer = ask("GET /?token=" + studio_->token(), "Host: " + host() + "\r\n");
  EXPECT_THAT(answer, StartsWith("HTTP/1.1 303"));
  EXPECT_THAT(answer, HasSubstr("Location: /\r\n"));
  EXPECT_THAT(answer, HasSubstr("=" + studio_->token() + "; HttpOnly; SameSite=Strict; Path=/"));
  EXPECT_THAT(studio_->address(), HasSubstr("?token=" + studio_->token()));
}

TEST_F(StudioServer, WithTheCookieThereIsThePage) {
  const std::string answer = get("/");
  EXPECT_THAT(answer, StartsWith("HTTP/1.1 200"));
  EXPECT_THAT(answer, HasSubstr("<title>limber studio</title>"));
  EXPECT_THAT(answer, HasSubstr("Content-Security-Policy: default-src 'self'"));
  EXPECT_THAT(get("/api/project"), HasSubstr("limber:01_pillar"));
  EXPECT_THAT(ask("GET /api/project", own_headers() + "Sec-Fetch-Site: same-origin\r\n"),
              HasSubstr("limber:01_pillar"));
  EXPECT_THAT(ask("GET /", own_headers() + "Sec-Fetch-Site: cross-site\r\n"),
              StartsWith("HTTP/1.1 200"))
      << "a link from elsewhere";
}

TEST_F(StudioServer, BrowsersThatTakePackedAnswersDoNotWaitForPacking) {
  const std::string headers = own_headers() + "Accept-Encoding: gzip, deflate, br\r\n";
  EXPECT_THAT(ask("GET /", headers), HasSubstr("<title>limber studio</title>"));
  EXPECT_THAT(ask("GET /api/project", headers), HasSubstr("limber:01_pillar"));
}

TEST_F(StudioServer, StrangersGetNothing) {
  const std::string own_host = "Host: " + host() + "\r\n";
  const std::string json = "Content-Type: application/json\r\nContent-Length: 2\r\n";
  const std::string origin = "Origin: http://" + host() + "\r\n";
  const std::string name = "Cookie: limber_studio_" + std::to_string(studio_->port()) + "=";
  const struct {
    const char* what;
    std::string line;
    std::string headers;
  } kTries[] = {
      {"no token", "GET /", own_host},
      {"no token, data", "GET /api/project", own_host},
      {"no token, script", "GET /assets/studio.js", own_host},
      {"wrong token", "GET /?token=00000000000000000000000000000000", own_host},
      {"empty token", "GET /?token=", own_host},
      {"wrong cookie", "GET /api/project", own_host + name + "0\r\n"},
      {"empty cookie", "GET /api/project", own_host + name + "\r\n"},
      {"token where it does not belong", "GET /api/project?token=" + studio_->token(), own_host},
      {"rebound name", "GET /api/project", "Host: evil.example\r\n" + cookie()},
      {"no host", "GET /api/project", cookie()},
      {"two hosts", "GET /api/project", own_host + "Host: evil.example\r\n" + cookie()},
      {"foreign origin reads", "GET /api/project",
       own_host + "Origin: http://evil.example\r\n" + cookie()},
      {"foreign origin writes", "POST /api/stop",
       own_host + "Origin: http://evil.example\r\n" + cookie() + json},
      {"opaque origin", "POST /api/stop", own_host + "Origin: null\r\n" + cookie() + json},
      {"other port's origin", "POST /api/stop",
       own_host + "Origin: http://127.0.0.1:1\r\n" + cookie() + json},
      {"no origin", "POST /api/stop", own_host + cookie() + json},
      {"other port's page, reads", "GET /api/project",
       own_host + cookie() + "Sec-Fetch-Site: same-site\r\n"},
      {"other site's page, reads", "GET /api/%65vents",
       own_host + cookie() + "Sec-Fetch-Site: cross-site\r\n"},
      {"no token, write", "POST /api/stop", own_host + origin + json},
  };
  for (const auto& one : kTries) {
    const std::string answer = ask(one.line, one.headers, "{}");
    EXPECT_THAT(answer, StartsWith("HTTP/1.1 403")) << one.what;
    EXPECT_THAT(answer, Not(HasSubstr("01_pillar"))) << one.what;
    EXPECT_THAT(answer, Not(HasSubstr("Set-Cookie"))) << one.what;
  }
}

// The library does not hold a range against what there is: it would read on in memory.
TEST_F(StudioServer, NoRangeLeadsBeyondAnAnswer) {
  const std::string refused = "Host: " + host() + "\r\n";
  for (const std::string& headers : {refused, own_headers()}) {
    const std::string whole = ask("GET /api/project", headers);
    for (const char* range : {"0-200000", "100000-100999", "-200000", "5-9,0-200000"}) {
      const std::string ranged = "Range: bytes=" + std::string(range) + "\r\n";
      EXPECT_EQ(ask("GET /api/project", headers + ranged), whole) << range;
    }
    // One that the library refuses by itself, for its second part.
    const std::string mixed = ask("GET /", headers + "Range: bytes=0-200000,1-0\r\n");
    EXPECT_LT(mixed.size(), 2000U);
  }
}

TEST_F(StudioServer, PathsDoNotLeadOut) {
  for (const char* name : {"../secret.yaml", "..%2Fsecret.yaml", "%2e%2e/secret.yaml",
                           "/etc/passwd", "limber:../../etc/passwd", "x%00.yaml"}) {
    const std::string answer =
        get(std::string("/api/environment?arm=limber:three_segment&name=") + name);
    EXPECT_THAT(answer, StartsWith("HTTP/1.1 400")) << name;
    EXPECT_THAT(answer, Not(HasSubstr("SECRET"))) << name;
  }
  for (const char* path : {"/../secret.yaml", "/assets/../../secret.yaml", "/%2e%2e/secret.yaml",
                           "//etc/passwd", "/etc/passwd"}) {
    EXPECT_THAT(get(path), StartsWith("HTTP/1.1 404")) << path;
  }
  const std::string unknown = post("/api/nothing", "{}");
  EXPECT_THAT(unknown, StartsWith("HTTP/1.1 404"));
  EXPECT_THAT(unknown, HasSubstr(R"({"error":"nothing is there"})"));
}

TEST_F(StudioServer, BodiesAreJsonAndSmall) {
  const std::string json = own_headers() + "Content-Type: application/json\r\n";
  EXPECT_THAT(ask("POST /api/stop", json + "Content-Length: 1073741824\r\n"),
              StartsWith("HTTP/1.1 413"));
  EXPECT_THAT(ask("POST /api/stop", json + "Content-Length: 99999999999999999999\r\n"),
              StartsWith("HTTP/1.1 413"));
  EXPECT_THAT(ask("POST /api/stop", json + "Content-Length: -1\r\n"), StartsWith("HTTP/1.1 413"));
  EXPECT_THAT(ask("POST /api/stop", json + "Content-Length: 2\r\nContent-Encoding: gzip\r\n", "{}"),
              StartsWith("HTTP/1.1 415"));
  EXPECT_THAT(ask("POST /api/stop", json), StartsWith("HTTP/1.1 411"));
  EXPECT_THAT(
      ask("POST /api/stop", json + "Transfer-Encoding: chunked\r\n", "2\r\n{}\r\n0\r\n\r\n"),
      StartsWith("HTTP/1.1 411"));
  EXPECT_THAT(ask("POST /api/stop",
                  own_headers() + "Content-Type: text/plain\r\nContent-Length: 2\r\n", "{}"),
              StartsWith("HTTP/1.1 415"));
  for (const char* body : {"", "[]", "{", "{\"tab\": 1}", "{\"tab\": \"a\", \"tab\": \"b\"}"}) {
    EXPECT_THAT(post("/api/stop", body), StartsWith("HTTP/1.1 400")) << body;
  }
  EXPECT_THAT(post("/api/stop", std::string(100000, '[')), StartsWith("HTTP/1.1 400"));
  EXPECT_THAT(post("/api/stop", "{\"tab\": \"no such tab\"}"), StartsWith("HTTP/1.1 409"));
}

TEST_F(StudioServer, ABodyThatIsRefusedIsNeverTakenForARequest) {
  RawClient client(studio_->port());
  client.send(
      "POST /api/stop HTTP/1.1\r\nHost: evil.example\r\nContent-Length: 500\r\n\r\n"
      "GET /api/project HTTP/1.1\r\n" +
      own_headers() + "\r\n");
  const std::string answer = client.read_to_the_end();
  EXPECT_THAT(answer, StartsWith("HTTP/1.1 403"));
  EXPECT_THAT(answer, Not(HasSubstr("01_pillar")));
}

TEST_F(StudioServer, SlowAndSilentStrangersShutNobodyOut) {
  std::vector<std::unique_ptr<RawClient>> strangers;
  for (int i = 0; i < 300; ++i) {
    strangers.push_back(std::make_unique<RawClient>(studio_->port()));
    strangers.back()->send(i % 2 == 0 ? "GET / HT" : "");
  }
  EXPECT_THAT(get("/api/project"), StartsWith("HTTP/1.1 200"));
}

// They wait for a thread for a moment, and none of them is a stranger who is in the way.
TEST_F(StudioServer, ConnectionsThatComeAtOnceAreAllAnswered) {
  constexpr int kAtOnce = 6;  // as many as a browser opens
  constexpr int kTimes = 20;
  for (int k = 0; k < kTimes; ++k) {
    std::vector<std::unique_ptr<RawClient>> pages;
    for (int i = 0; i < kAtOnce; ++i) {
      pages.push_back(std::make_unique<RawClient>(studio_->port()));
    }
    for (const auto& page : pages) {
      page->send("GET /assets/studio.css HTTP/1.1\r\n" + own_headers() + "\r\n");
    }
    for (const auto& page : pages) {
      EXPECT_THAT(page->read_until("\r\n\r\n"), StartsWith("HTTP/1.1 200"));
    }
  }
}

TEST_F(StudioServer, StreamsAreFewAndEndWithTheirPage) {
  const std::string line = "GET /api/events HTTP/1.1\r\n" + own_headers() + "\r\n";
  std::vector<std::unique_ptr<RawClient>> pages;
  for (int i = 0; i < 4; ++i) {
    pages.push_back(std::make_unique<RawClient>(studio_->port()));
    pages.back()->send(line);
    EXPECT_THAT(pages.back()->read_until("event: tab"), StartsWith("HTTP/1.1 200"));
  }
  EXPECT_THAT(get("/api/events"), StartsWith("HTTP/1.1 429"));
  pages.pop_back();
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(kPatienceMs);
  std::string answer;
  while (std::chrono::steady_clock::now() < end && answer.find("event: tab") == std::string::npos) {
    RawClient next(studio_->port());
    next.send(line);
    answer = next.read_until("\"");
  }
  EXPECT_THAT(answer, HasSubstr("event: tab")) << "the closed page's place is free again";
}

// A page can't see a connection that stalls: its scripts are told of events alone.
TEST_F(StudioServer, AStreamWithoutNewsBeats) {
  RawClient page(studio_->port());
  page.send("GET /api/events HTTP/1.1\r\n" + own_headers() + "\r\n");
  const std::string beat = "event: beat\ndata: {}\n\n";
  EXPECT_THAT(page.read_until(beat), HasSubstr(beat));
}

TEST_F(StudioServer, ATreeIsShownWhileItGrows) {
  RawClient page(studio_->port());
  nlohmann::json request = question(page);
  request["environment"]["goal"]["position_tolerance_m"] = 1e-6;  // nobody finds a plan
  EXPECT_THAT(post("/api/plan", request.dump()), StartsWith("HTTP/1.1 200"));
  const std::string events = page.read_until("{\"request\":7,\"tree\":[");
  EXPECT_THAT(events, HasSubstr("event: tree"));
  EXPECT_THAT(events, Not(HasSubstr("event: result")));
}

TEST_F(StudioServer, APageGetsACertifiedPlanAndSavesIt) {
  RawClient page(studio_->port());
  nlohmann::json request = question(page);
  request["margin_m"] = 0.001;
  EXPECT_THAT(post("/api/plan", request.dump()), StartsWith("HTTP/1.1 200"));
  EXPECT_THAT(page.read_until("event: plan"), HasSubstr("event: plan"));
  EXPECT_THAT(page.read_until("event: result"), HasSubstr("\"status\":\"solved\""));

  nlohmann::json open = {
      {"tab", request["tab"]}, {"request", 8}, {"arm", ""}, {"model", ""}, {"plan", "none.json"}};
  EXPECT_THAT(post("/api/plan/open", open.dump()), StartsWith("HTTP/1.1 200"));
  EXPECT_THAT(page.read_until("\"request\":8"), HasSubstr("event: fault"));

  nlohmann::json save = {{"tab", request["tab"]}, {"name", "first"}, {"overwrite", false}};
  EXPECT_THAT(post("/api/plan/save", save.dump()), HasSubstr("plans/first.json"));
  EXPECT_THAT(post("/api/plan/save", save.dump()), StartsWith("HTTP/1.1 412"));
  EXPECT_TRUE(read_plan(folder_ / "project/plans/first.json").certified);
  EXPECT_EQ(read_plan(folder_ / "project/plans/first.json").margin_m, 0.001);

  nlohmann::json other = save;
  other["plan"] = 6;
  EXPECT_THAT(post("/api/plan/save", other.dump()),
              AllOf(StartsWith("HTTP/1.1 409"), HasSubstr("another plan than this page shows")));
  const nlohmann::json run = {{"tab", request["tab"]},
                              {"request", 10},
                              {"plan", 6},
                              {"replan", false},
                              {"obstacle", false}};
  EXPECT_THAT(post("/api/run", run.dump()), StartsWith("HTTP/1.1 409"));

  save["arm"] = request["arm"];
  save["environment"] = request["environment"];
  EXPECT_THAT(post("/api/environment", save.dump()), HasSubstr("environments/first.yaml"));
  EXPECT_EQ(environment_hash(load_environment(folder_ / "project/environments/first.yaml")),
            read_plan(folder_ / "project/plans/first.json").environment_hash);

  open["request"] = 9;
  open["plan"] = "plans/first.json";
  EXPECT_THAT(get("/api/project"), HasSubstr(R"("plans":["plans/first.json"])"));
  EXPECT_THAT(post("/api/plan/open", open.dump()), StartsWith("HTTP/1.1 200"));
  EXPECT_THAT(page.read_until("\"environments/first.yaml\""),
              HasSubstr("event: opened\ndata: {\"request\":9,\"arm\":\"limber:three_segment\","
                        "\"model\":\"\",\"environment\":\"environments/first.yaml\""));
  const nlohmann::json again = {
      {"tab", request["tab"]}, {"plan", 9}, {"name", "again"}, {"overwrite", false}};
  EXPECT_THAT(post("/api/plan/save", again.dump()), HasSubstr("plans/again.json"));
  EXPECT_EQ(read_file(folder_ / "project/plans/again.json"),
            read_file(folder_ / "project/plans/first.json"));

  save["name"] = "../first";
  EXPECT_THAT(post("/api/environment", save.dump()), StartsWith("HTTP/1.1 400"));
}

TEST_F(StudioServer, PathsThatAreNoneAreRefused) {
  const nlohmann::json follow = {{"tab", std::string(32, '0')},
                                 {"request", 1},
                                 {"arm", "limber:three_segment"},
                                 {"model", ""},
                                 {"environment", nlohmann::json::object()}};
  const std::vector<std::pair<std::vector<double>, std::string>> paths = {
      {{0.0, 0.3, 0.1}, "2 to 2000 points"},
      {{0.0, 0.3, 0.1, 1.0, 0.3}, "5 numbers"},
      {{0.0, 0.3, 0.1, 0.0, 0.3, 0.2}, "point 1 has time_s = 0"},
      {{1.0, 0.3, 0.1, 2.0, 0.3, 0.2}, "point 0 has time_s = 1"},
      {{0.0, 0.3, 0.1, 1000.0, 0.3, 0.2}, "path"}};
  for (const auto& [path, word] : paths) {
    nlohmann::json body = follow;
    body["path"] = path;
    const std::string answer = post("/api/follow", body.dump());
    EXPECT_THAT(answer, AllOf(StartsWith("HTTP/1.1 400"), HasSubstr(word)));
  }
}

TEST(StudioSettingsTest, EveryAddressAtOnceAndATakenPortAreRefused) {
  StudioSettings settings;
  settings.port = 0;
  settings.listen = "0.0.0.0";
  EXPECT_THAT([&] { Studio studio(settings); },
              ThrowsMessage<InputError>(HasSubstr("one address")));
  settings.listen = "127.0.0.1";
  const Studio first(settings);
  settings.port = first.port();
  EXPECT_THAT([&] { Studio studio(settings); }, ThrowsMessage<InputError>(HasSubstr("--port 0")));
}

}  // namespace
}  // namespace limber
