#include "src/planning/planner_name.hpp"

#include <gmock/gmock.h>

#include "limber/common/error.hpp"

namespace limber {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Pair;
using ::testing::ThrowsMessage;

TEST(PlannerName, IsANameAndWhatIsSetBehindIt) {
  const PlannerName bare = PlannerName::parse("default");
  EXPECT_EQ(bare.name, "default");
  EXPECT_THAT(bare.settings, IsEmpty());
  const PlannerName set = PlannerName::parse("ompl:SST,frames=3,rule=a=b,empty=");
  EXPECT_EQ(set.name, "ompl:SST");
  EXPECT_THAT(set.settings,
              ElementsAre(Pair("empty", ""), Pair("frames", "3"), Pair("rule", "a=b")));
}

TEST(PlannerName, WhatIsNoSettingIsRefused) {
  const auto refusal = [](const char* text, const char* message) {
    EXPECT_THAT([&] { (void)PlannerName::parse(text); },
                ThrowsMessage<InputError>(HasSubstr(message)));
  };
  refusal("default,", "planner setting ''; expected NAME,key=value");
  refusal("default,=3", "planner setting '=3'");
  refusal("default,a=1,,b=2", "planner setting ''");
  refusal("default,a=1,a=2", "planner setting a: given twice");
}

TEST(PlannerName, ASettingIsTakenOnceAndOnlyInItsRange) {
  PlannerName name = PlannerName::parse("x,a=2.5,b=1e3,c=nan,d=2 ,e=");
  EXPECT_EQ(name.take("a", 0.0, 5.0, 1.0), 2.5);
  EXPECT_EQ(name.take("a", 0.0, 5.0, 1.0), 1.0) << "it is gone";
  EXPECT_EQ(name.take("unknown", 0.0, 5.0, 1.0), 1.0);
  const auto refusal = [&](const char* key, const char* message) {
    EXPECT_THAT([&] { (void)name.take(key, 0.0, 5.0, 1.0); },
                ThrowsMessage<InputError>(HasSubstr(message)));
  };
  refusal("b", "b = '1e3'; expected a number from 0 to 5");
  refusal("c", "c = 'nan'; expected a number");
  refusal("d", "d = '2 '; expected a number");
  refusal("e", "e = ''; expected a number");
}

}  // namespace
}  // namespace limber
