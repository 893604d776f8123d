#include <gmock/gmock.h>

#include "arm/test_arms.hpp"
#include "limber/arm/characterisation.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

class BenchCsvFile : public ::testing::Test {
 protected:
  BenchData read(const std::string& text, int segments = 2) {
    const std::filesystem::path file = folder_.path() / "bench.csv";
    write_file_atomically(file, text);
    return read_bench_csv(file, arm_of(segments));
  }

  void expect_refusal(const std::string& text, const std::string& ending) {
    EXPECT_THAT([&] { read(text); }, ThrowsMessage<InputError>(HasSubstr("bench.csv" + ending)))
        << text;
  }

  TemporaryFolder folder_;
};

TEST_F(BenchCsvFile, WithoutASegmentColumnServesEverySegment) {
  const BenchData data = read("pressure_kpa,strain\n0,0\n50,-0.1\n");
  ASSERT_EQ(data.size(), 2u);
  for (const std::vector<BenchPoint>& points : data) {
    ASSERT_EQ(points.size(), 2u);
    EXPECT_EQ(points[1].pressure_kpa, 50.0);
    EXPECT_EQ(points[1].strain, -0.1);
  }
}

TEST_F(BenchCsvFile, SortsRowsBySegmentInAnyOrderOfColumns) {
  const BenchData data = read("strain,segment,pressure_kpa\n-0.1,1,50\n-0.2,0,60\n-0.15,1,55\n");
  ASSERT_EQ(data[0].size(), 1u);
  EXPECT_EQ(data[0][0].pressure_kpa, 60.0);
  ASSERT_EQ(data[1].size(), 2u);
  EXPECT_EQ(data[1][1].strain, -0.15);
}

TEST_F(BenchCsvFile, ReadsWhatSpreadsheetsWrite) {
  const BenchData data =
      read("\xEF\xBB\xBF# of 3 May\r\n\r\n pressure_kpa , strain\r\n 1e1 ,\t-0.05 \r\n-0.5,0");
  ASSERT_EQ(data[0].size(), 2u);
  EXPECT_EQ(data[0][0].pressure_kpa, 10.0);
  EXPECT_EQ(data[0][0].strain, -0.05);
  EXPECT_EQ(data[0][1].pressure_kpa, -0.5);  // a gauge's noise around zero
}

TEST_F(BenchCsvFile, QuotesInACommentAreNoCells) {
  const BenchData data =
      read("  # rig, \"new\npressure_kpa,strain\n10,-0.05\n# 3\" tube\n20,-0.1\n");
  ASSERT_EQ(data[0].size(), 2u);
  EXPECT_EQ(data[0][1].pressure_kpa, 20.0);
}

TEST_F(BenchCsvFile, NamesLineAndColumnOfEveryFault) {
  expect_refusal("", ":1:1: an empty file; expected the header pressure_kpa,strain");
  expect_refusal("pressure_kpa,strain\n", ":1:1: no rows below the header");
  expect_refusal("pressure_psi,strain\n1,2\n", ":1:1: column 'pressure_psi'; expected the header");
  expect_refusal("pressure_kpa\n1\n", ":1:1: column 'strain' is missing");
  expect_refusal("pressure_kpa,strain,strain\n", ":1:21: column 'strain' occurs twice");
  expect_refusal("0,0\n50,-0.1\n", ":1:1: column '0'; expected the header");
  expect_refusal("pressure_kpa,strain\n0,0\n50,-0.1 m\n",
                 ":3:4: '-0.1 m' found; expected a strain, a fraction");
  expect_refusal("pressure_kpa,strain\n0,0\n50, nan\n", ":3:5: 'nan' found");
  expect_refusal("pressure_kpa,strain\n0,0\n50,\n", ":3:4: '' found");
  expect_refusal("pressure_kpa,strain\n0;0\n", ":2:1: 1 values; expected 2 as in the header");
  expect_refusal("pressure_kpa,strain\n0,0\n50,0,1\n", ":3:6: 3 values; expected 2");
  expect_refusal("pressure_kpa,strain\n-30,-0.1\n", ":2:1: pressure_kpa -30; expected the gauge");
  expect_refusal("pressure_kpa,strain\n30,-12\n", ":2:4: strain -12; expected a fraction");
  expect_refusal("pressure_kpa,strain,segment\n30,-0.1,2\n",
                 ":2:9: segment number 2; expected a whole number from 0 to 1");
  expect_refusal("pressure_kpa,strain,segment\n30,-0.1,0.5\n",
                 ":2:9: segment number 0.5; expected");
  expect_refusal("pressure_kpa,strain,segment\n30,-0.1,0\n",
                 ":2:1: no row for segment 1; the arm has segments 0 to 1");
}

TEST_F(BenchCsvFile, MissingFileIsNamed) {
  EXPECT_THAT([] { read_bench_csv("no/such.csv", arm_of(1)); },
              ThrowsMessage<InputError>(HasSubstr("no/such.csv")));
}

}  // namespace
}  // namespace limber
