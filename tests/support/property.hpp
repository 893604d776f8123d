#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace limber {

/// Whether a law holds for all that it draws. As rapidcheck, but from the same seed in every run;
/// RC_PARAMS in the environment asks for another one, or for more cases: "seed=7 max_success=9999".
/// @param slower  a case takes so many times as long as usual: so many fewer are drawn
template <class Law>
void expect_law(const char* law, Law&& holds, int slower = 1) {
  ::setenv("RC_PARAMS", "seed=20 max_success=100", 0);
  rc::detail::TestMetadata metadata;
  metadata.id = law;
  metadata.description = law;
  rc::detail::TestParams params = rc::detail::configuration().testParams;
  params.maxSuccess = std::max(1, params.maxSuccess / slower);
  const auto result = rc::detail::checkTestable(std::forward<Law>(holds), metadata, params);
  std::ostringstream said;
  rc::detail::printResultMessage(result, said);
  EXPECT_TRUE(result.template is<rc::detail::SuccessResult>()) << law << "\n" << said.str();
}

/// Number to draw an arm, an environment, … by.
inline std::uint64_t drawn_number() {
  return *rc::gen::resize(1000, rc::gen::inRange<std::uint64_t>(0, 1'000'000'000));
}

/// What people write into names and notes, also what YAML, JSON and CSV have a meaning for.
inline std::string drawn_text() {
  const std::vector<std::string> pieces = {"a",  "7", " ", "\"", "'",  "#", ": ", ",",
                                           "\\", "{", "]", "\n", "\t", "é", "→",  "🐙"};
  std::string text;
  for (int left = *rc::gen::inRange(0, 9); left > 0; --left) {
    text += *rc::gen::elementOf(pieces);
  }
  return text;
}

}  // namespace limber
