#include <charconv>
#include <fstream>

#include <gtest/gtest.h>

#include "limber/arm/arm_commands.hpp"
#include "support/temporary_folder.hpp"
#include "world/small_plan.hpp"

namespace limber {
namespace {

template <class Number>
Number number_in(const std::string& cell) {
  Number number{};
  const char* end = cell.data() + cell.size();
  EXPECT_EQ(std::from_chars(cell.data(), end, number).ptr, end) << cell;
  return number;
}

TEST(Plan, CsvOfTheArmsOwnCommandsMakesTheSetPoints) {
  const TemporaryFolder folder;
  ArmDescription arm = three_segment_arm();
  arm.commands = {{"m0", {1, 0, 0}}, {"m1", {-1, 0, 0}}, {"m2", {0, 1, 0}}, {"m3", {0, 0.5, 2}}};
  const Plan plan = small_plan(arm);
  write_commands_csv(folder.path() / "p.csv", plan, arm);
  std::ifstream file(folder.path() / "p.csv");
  std::string line;
  std::getline(file, line);
  EXPECT_EQ(line, "time_s,m0,m1,m2,m3");
  constexpr double kSingle = 1e-4;  // [kPa]
  for (std::size_t k = 1; k < plan.frames.size(); ++k) {
    ASSERT_TRUE(std::getline(file, line));
    std::stringstream row(line);
    std::string cell;
    std::getline(row, cell, ',');
    EXPECT_DOUBLE_EQ(number_in<double>(cell), double(k - 1) / 20.0);
    Eigen::VectorXd commands(4);
    for (double& command : commands) {
      std::getline(row, cell, ',');
      command = number_in<double>(cell);
    }
    const Eigen::VectorXd made = segment_commands(arm, commands);
    EXPECT_TRUE(made.isApprox(plan.frames[k].setpoint_kpa.cast<double>(), kSingle)) << line;
  }
  EXPECT_FALSE(std::getline(file, line));
}

TEST(Plan, CsvHoldsTheSetPointsToCommandAndWhen) {
  const TemporaryFolder folder;
  const Plan plan = small_plan(three_segment_arm());
  write_setpoints_csv(folder.path() / "p.csv", plan);
  std::ifstream file(folder.path() / "p.csv");
  std::string line;
  std::getline(file, line);
  EXPECT_EQ(line,
            "time_s,setpoint_0_kpa,setpoint_1_kpa,setpoint_2_kpa,"
            "pressure_0_kpa,pressure_1_kpa,pressure_2_kpa");
  for (std::size_t k = 1; k < plan.frames.size(); ++k) {
    ASSERT_TRUE(std::getline(file, line));
    std::stringstream row(line);
    std::string cell;
    std::getline(row, cell, ',');
    EXPECT_DOUBLE_EQ(number_in<double>(cell), double(k - 1) / 20.0);
    for (int i = 0; i < 3; ++i) {
      std::getline(row, cell, ',');
      EXPECT_EQ(number_in<float>(cell), plan.frames[k].setpoint_kpa[i]);
    }
    for (int i = 0; i < 3; ++i) {
      std::getline(row, cell, ',');
      EXPECT_EQ(number_in<float>(cell), plan.frames[k].pressure_kpa[i]);
    }
  }
  EXPECT_FALSE(std::getline(file, line));
  EXPECT_DOUBLE_EQ(plan.duration_s(), 0.3);
}

}  // namespace
}  // namespace limber
