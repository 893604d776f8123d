// What an arm's own commands make of its segments, found from logs: limber/logs/command_shares.hpp.
#include "limber/logs/command_shares.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <Eigen/LU>
#include <nlohmann/json.hpp>

#include "limber/arm/arm_commands.hpp"
#include "logs/csv_import.hpp"

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::SizeIs;
using ::testing::ThrowsMessage;

constexpr double kShareFound = 0.03;  // the no-load model is not quite a line, and blurs shares

/// Motors that pull one by one, and one that pulls at two segments.
class CommandSharesOf : public CsvImport {
 protected:
  CommandSharesOf() {
    rows_ = 6000;
    shares_ = Eigen::MatrixXd::Zero(3, 4);
    shares_ << 1.0, 0.0, 0.0, 0.0,  //
        0.0, -0.8, 0.2, 0.0,        //
        0.0, 0.0, 1.0, 0.0;
  }

  /// Four motors: the last moves nothing.
  Eigen::VectorXd motors(double time_s) const {
    const Eigen::MatrixXd moving = shares_.leftCols(3);
    const Eigen::Vector3d three = moving.inverse() * truth_.pressures(time_s);
    return Eigen::Vector4d(three[0], three[1], three[2], 30.0 * std::sin(2.3 * time_s));
  }

  std::string motor_log() const {
    const std::string poses = header().substr(header().find(",x0"));
    return LogTruth::table("time_s,m0,m1,m2,m3" + poses, rows_, rate_hz_, [&](double t) {
      std::string text;
      for (const double value : motors(t)) {
        text += fmt::format(",{:.6f}", value);
      }
      return text + pose_cells(t);
    });
  }

  CommandShares found(const std::string& columns) const {
    write_file_atomically(folder_.path() / "run.csv", motor_log());
    write_file_atomically(
        folder_.path() / "map.yaml",
        replaced(mapping(), "pressure_1_kpa, pressure_2_kpa, pressure_3_kpa", columns));
    return find_command_shares({folder_.path() / "run.csv"}, folder_.path() / "map.yaml",
                               truth_.arm());
  }

  Eigen::MatrixXd shares_;
};

TEST_F(CommandSharesOf, LogsAreThoseThatMadeThem) {
  const CommandShares shares = found("m0, m1, m2, m3");
  ASSERT_THAT(shares.commands, SizeIs(3));
  EXPECT_EQ(shares.idle, std::vector<std::string>{"m3"});
  EXPECT_TRUE(shares.alike.empty());
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(shares.commands[k].name, fmt::format("m{}", k));
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(shares.commands[k].shares[i], shares_(Eigen::Index(i), Eigen::Index(k)),
                  kShareFound)
          << "segment " << i << ", motor " << k;
    }
  }
}

TEST_F(CommandSharesOf, TextCanBePastedIntoTheArmFile) {
  const CommandShares shares = found("m0, m1, m2, m3");
  const std::string text = to_text(shares, truth_.arm());
  EXPECT_THAT(text, HasSubstr("m3: no segment follows"));
  const ArmDescription pasted = read_arm_keys(
      arm_keys_to_yaml(truth_.arm()) + text.substr(text.find("\ncommands:\n") + 1) + "\n",
      "pasted");
  ASSERT_THAT(pasted.commands, SizeIs(3));
  EXPECT_EQ(pasted.commands[2].shares, shares.commands[2].shares);
  EXPECT_EQ(to_json(shares, truth_.arm())["commands"][0]["name"], "m0");
}

TEST_F(CommandSharesOf, PairsThatMoveAgainstEachOtherAreSplitEvenly) {
  shares_ << 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0;
  const std::string poses = header().substr(header().find(",x0"));
  const std::string log =
      LogTruth::table("time_s,m0,m1,m2,m3" + poses, rows_, rate_hz_, [&](double t) {
        const Eigen::Vector3d c = truth_.pressures(t);
        return fmt::format(",{:.4f},{:.4f},{:.4f},{:.4f}", 20.0 + c[0], 20.0 - c[0], c[1], c[2]) +
               pose_cells(t);
      });
  write_file_atomically(folder_.path() / "run.csv", log);
  write_file_atomically(
      folder_.path() / "map.yaml",
      replaced(mapping(), "pressure_1_kpa, pressure_2_kpa, pressure_3_kpa", "m0, m1, m2, m3"));
  const CommandShares shares =
      find_command_shares({folder_.path() / "run.csv"}, folder_.path() / "map.yaml", truth_.arm());
  ASSERT_THAT(shares.commands, SizeIs(4));
  EXPECT_NEAR(shares.commands[0].shares[0], 0.5, kShareFound);
  EXPECT_NEAR(shares.commands[1].shares[0], -0.5, kShareFound);
  ASSERT_THAT(shares.alike, SizeIs(1));
  EXPECT_EQ(shares.alike[0], std::pair(std::string("m0"), std::string("m1")));
}

TEST_F(CommandSharesOf, ASegmentThatNothingMovesIsNamed) {
  EXPECT_THAT([&] { found("m0, m1, m3"); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("segment 2: no command moves it"))));
  EXPECT_THAT([&] { found("m0, -m1, m2"); },
              ThrowsMessage<InputError>(HasSubstr("expected a column without a sign")));
}

}  // namespace
}  // namespace limber
