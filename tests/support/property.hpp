#pragma once

#include <cstdlib>

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace limber {

/// Whether a law holds for all that it draws. As rapidcheck, but from the same seed in every run;
/// RC_PARAMS in the environment asks for another one, or for more cases: "seed=7 max_success=9999".
template <class Law>
void expect_law(const char* law, Law&& holds) {
  ::setenv("RC_PARAMS", "seed=20 max_success=100", 0);
  EXPECT_TRUE(rc::check(law, std::forward<Law>(holds)));
}

/// Number to draw an arm, an environment, … by.
inline std::uint64_t drawn_number() {
  return *rc::gen::resize(1000, rc::gen::inRange<std::uint64_t>(0, 1'000'000'000));
}

}  // namespace limber
