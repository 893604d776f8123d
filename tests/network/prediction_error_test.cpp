#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limber/common/error.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/common/yaml_reader.hpp"
#include "limber/network/prediction_error.hpp"

namespace limber {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

std::vector<double> shuffled_numbers(int count) {
  std::vector<double> values;
  for (int i = 1; i <= count; ++i) {
    values.push_back(i);
  }
  RandomStream random(4, 0);
  for (std::size_t i = values.size(); i > 1; --i) {
    std::swap(values[i - 1], values[random.index(static_cast<std::uint32_t>(i))]);
  }
  return values;
}

// Of 1, 2, …, n the k-th smallest is k.
TEST(ConformalQuantile, IsTheNumberOfItsDefinition) {
  for (const auto& [count, rank] :
       {std::pair{1, 1}, {10, 10}, {18, 18}, {19, 19}, {20, 20}, {39, 38}, {100, 96}, {199, 190}}) {
    EXPECT_EQ(conformal_quantile(shuffled_numbers(count)), rank) << count << " values";
  }
}

// What it is for: the next value of the same kind stays below in a share of all cases or more.
TEST(ConformalQuantile, CoversTheNextValueAsOftenAsItSays) {
  constexpr int kTrials = 20'000;
  constexpr double kFourDeviations = 4.0 * 0.0016;  // of a share of 0.95 over 20 000 trials
  RandomStream random(5, 0);
  int covered = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::vector<double> values;
    for (int i = 0; i < 39; ++i) {
      values.push_back(random.uniform());
    }
    covered += random.uniform() <= conformal_quantile(values) ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(covered) / kTrials, 0.95, kFourDeviations);
}

TEST(PredictionErrorText, SurvivesTheRoundTripExactly) {
  const PredictionError error{27, 10.0 / 3.0, 0.1 / 7.0, 1e-17, 2.0 / 3.0};
  EXPECT_EQ(read_prediction_error(YamlReader::from_text(prediction_error_to_metadata(error), "m")),
            error);
}

TEST(PredictionErrorText, IsOneLineInCentimetres) {
  EXPECT_EQ(to_text(PredictionError{27, 10.0, 0.0132, 0.0099, 0.0081, 0.0456}),
            "error on 27 unseen runs of 10 s, 95 %: 1.32 cm anywhere on the arm, 0.99 cm off "
            "the predicted path, 0.81 cm and 0.046 rad at the tip's end");
  EXPECT_THAT(to_text(PredictionError{18, 10.0, 0.0132, 0.0099, 0.0081, 0.0456}),
              testing::HasSubstr("18 unseen runs of 10 s, 95 % guessed from their median: 1.32"));
}

TEST(PredictionError, NamesTheNumberThatIsOutOfRange) {
  const auto message = [](PredictionError error, const char* expected) {
    EXPECT_THAT([&] { validate(error, "m"); }, ThrowsMessage<InputError>(HasSubstr(expected)));
  };
  EXPECT_NO_THROW(validate({1, 0.05, 0.0, 0.0, 0.0, 0.0}, "m"));
  message({0, 10.0, 0.0, 0.0, 0.0, 0.0}, "m: prediction_error.runs is 0");
  message({1, 0.0, 0.0, 0.0, 0.0, 0.0}, "prediction_error.run_s is 0");
  message({1, 10.0, -1.0, 0.0, 0.0, 0.0}, "prediction_error.largest_position_m is -1");
  message({1, 10.0, 0.0, -1.0, 0.0, 0.0}, "prediction_error.off_path_m is -1");
  message({1, 10.0, 0.0, 0.0, std::nan(""), 0.0}, "prediction_error.end_position_m is nan");
  message({1, 10.0, 0.0, 0.0, 0.0, std::numeric_limits<double>::infinity()},
          "prediction_error.end_orientation_rad is inf");
}

}  // namespace
}  // namespace limber
