#include "src/studio/request_rules.hpp"

#include <set>

#include <gtest/gtest.h>

namespace limber {
namespace {

TEST(RequestRules, OnlyThisMachineIsTheHost) {
  for (const char* own : {"127.0.0.1", "127.0.0.1:8750", "localhost:1", "LocalHost", "[::1]:80",
                          "[::1]", "bench.lab:8750"}) {
    EXPECT_TRUE(is_own_host(own, "bench.lab")) << own;
  }
  for (const char* other :
       {"", ":80", "evil.example", "127.0.0.1.evil.example", "localhost.evil.example:80",
        "127.0.0.2", "127.0.0.1:", "127.0.0.1:80x", "127.0.0.1:80:80", "[::1", "[::1]x", "[::2]",
        "user@127.0.0.1", "bench.lab.evil.example", "127.0.0.1@evil.example"}) {
    EXPECT_FALSE(is_own_host(other, "bench.lab")) << other;
  }
}

TEST(RequestRules, OnlyThePageItselfIsTheOrigin) {
  EXPECT_TRUE(is_own_origin("http://localhost:1", "localhost:1", true));
  EXPECT_TRUE(is_own_origin("", "localhost:1", false)) << "a link that is typed has none";
  EXPECT_FALSE(is_own_origin("", "localhost:1", true));
  for (const char* other : {"null", "http://localhost:2", "https://localhost:1", "http://localhost",
                            "http://evil.example", "http://localhost:1.evil.example"}) {
    EXPECT_FALSE(is_own_origin(other, "localhost:1", true)) << other;
    EXPECT_FALSE(is_own_origin(other, "localhost:1", false)) << other;
  }
}

TEST(RequestRules, OnlyThePageItselfOrAPersonIsTheSite) {
  for (const char* own : {"same-origin", "none", ""}) {
    EXPECT_TRUE(is_own_site(own)) << own;
  }
  for (const char* other : {"same-site", "cross-site", "Same-Origin", "anything"}) {
    EXPECT_FALSE(is_own_site(other)) << other;
  }
}

TEST(RequestRules, ACookieIsFoundByItsWholeName) {
  EXPECT_EQ(cookie_value("a=1; studio=abc; b=2", "studio"), "abc");
  EXPECT_EQ(cookie_value("studio=abc", "studio"), "abc");
  for (const char* other : {"", "xstudio=abc", "studiox=abc", "studio", "a=studio=abc"}) {
    EXPECT_EQ(cookie_value(other, "studio"), "") << other;
  }
}

TEST(RequestRules, SecretsAreTheSameOrNot) {
  const std::string token = make_token();
  EXPECT_TRUE(is_same_secret(token, token));
  for (const std::string& other : {std::string(), token.substr(1), token + "0", make_token()}) {
    EXPECT_FALSE(is_same_secret(token, other)) << other;
  }
}

TEST(RequestRules, TokensAre128BitsAndDiffer) {
  std::set<std::string> tokens;
  for (int i = 0; i < 100; ++i) {
    tokens.insert(make_token());
  }
  EXPECT_EQ(tokens.size(), 100U);
  EXPECT_EQ(tokens.begin()->size(), 32U);
}

TEST(RateLimit, AdmitsItsRateAndABurst) {
  RateLimit limit(10.0, 3.0);
  RateLimit::Clock::time_point now{};
  const auto admitted = [&](int asked) {
    int count = 0;
    for (int i = 0; i < asked; ++i) {
      count += limit.admits(now) ? 1 : 0;
    }
    return count;
  };
  EXPECT_EQ(admitted(10), 3);
  now += std::chrono::milliseconds(201);
  EXPECT_EQ(admitted(10), 2);
  now += std::chrono::hours(1);
  EXPECT_EQ(admitted(10), 3);
}

}  // namespace
}  // namespace limber
