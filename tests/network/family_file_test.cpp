#include <gmock/gmock.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/safetensors.hpp"
#include "limber/network/arm_family.hpp"
#include "limber/network/compensation_model.hpp"
#include "limber/network/untrained_model.hpp"
#include "support/sample_arm.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// Three numbers say which of its arms one is.
CompensationModel family_of_twenty(float gains) {
  CompensationModel family = untrained_model(sample_arm(2), BackboneLayout::gap_poses, {7, 9}, 1);
  family.family = ArmFamily{Eigen::MatrixXf::Random(16, 3),
                            gains * Eigen::MatrixXf::Random(16, 4),
                            Eigen::MatrixXf::Random(3, 20),
                            {}};
  return family;
}

TEST(FamilyFile, FamiliesAndTheirArmsComeBack) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "model.safetensors";
  CompensationModel family = family_of_twenty(0.3F);
  family.family->traits = {{"tip_load_kg", 0.01F, 0.04F, 0.005F, Eigen::Vector3f(0.1F, 0.0F, -0.2F),
                            Eigen::Vector3f(7.0F, 1.0F, -1.0F)},
                           {"actuator_bow", 0.0F, 0.1F, 0.05F, Eigen::Vector3f(0.3F, 0.2F, 0.1F),
                            Eigen::Vector3f(3.0F, 2.0F, 5.0F)}};
  write_model(path, family);
  const CompensationModel back = read_model(path);
  ASSERT_TRUE(is_family(back));
  EXPECT_EQ(back.family->shifts, family.family->shifts);
  EXPECT_EQ(back.family->log_gains, family.family->log_gains);
  EXPECT_EQ(back.family->arms, family.family->arms);
  ASSERT_EQ(back.family->traits.size(), 2U);
  EXPECT_EQ(back.family->traits[1].name, "actuator_bow");
  EXPECT_EQ(back.family->traits[0].of_file, 0.01F);
  EXPECT_EQ(back.family->traits[0].middle, 0.04F);
  EXPECT_EQ(back.family->traits[0].left, 0.005F);
  EXPECT_EQ(back.family->traits[0].slope, family.family->traits[0].slope);
  EXPECT_EQ(back.family->traits[1].along, family.family->traits[1].along);
  EXPECT_THAT([&] { (void)read_model_of_one_arm(path); },
              ThrowsMessage<InputError>(AllOf(HasSubstr(path.string() + ": a family of 20 arms"),
                                              HasSubstr("limber adapt"))));
  const FamilyMember member{"0123", Eigen::Vector3f(0.5F, -1.0F, 2.0F),
                            Eigen::Matrix3f::Identity()};
  const CompensationModel one = model_of_arm(family, member);
  EXPECT_FALSE(one.layers[1].weight.isApprox(family.layers[1].weight, 0.01F));
  EXPECT_TRUE(one.layers[2].weight.isApprox(family.layers[2].weight, 0.0F));
  write_model(path, one);
  const CompensationModel read = read_model_of_one_arm(path);
  EXPECT_EQ(read.layers[0].bias, one.layers[0].bias);
  ASSERT_TRUE(read.member_of_family);
  EXPECT_EQ(read.member_of_family->e, member.e);
  EXPECT_EQ(read.member_of_family->covariance, member.covariance);
  EXPECT_EQ(read.member_of_family->family_hash, "0123");

  family.family->traits[0].name = "tip load";
  EXPECT_THAT([&] { write_model(path, family); },
              ThrowsMessage<InputError>(HasSubstr("metadata family_traits: tip load;")));
  family.family->traits[0].name = "tip_load_kg";
  family.family->traits[0].left = 0.0F;
  EXPECT_THAT([&] { write_model(path, family); },
              ThrowsMessage<InputError>(HasSubstr("tensor family.traits, tip_load_kg")));
  family.family->traits.clear();
  family.family->arms.conservativeResize(2, Eigen::NoChange);
  EXPECT_THAT([&] { write_model(path, family); },
              ThrowsMessage<InputError>(HasSubstr("tensor family.arms is 2 by 20; expected 3")));
}

/// The hidden layers as docs/families.md has them, e beside their inputs.
Eigen::VectorXf hidden_output(const CompensationModel& family, const Eigen::VectorXf& e,
                              Eigen::VectorXf x) {
  Eigen::Index row = 0;
  for (std::size_t i = 0; i + 1 < family.layers.size(); ++i) {
    const auto& [weight, bias] = family.layers[i];
    const Eigen::VectorXf shift = family.family->shifts.middleRows(row, bias.size()) * e;
    const Eigen::MatrixXf gains = family.family->log_gains.middleRows(row, bias.size());
    const Eigen::ArrayXf of_arm = gains.col(0) + gains.rightCols(e.size()) * e;
    const Eigen::VectorXf gain =
        (4.0F * (of_arm / 4.0F).tanh() - 4.0F * (gains.col(0).array() / 4.0F).tanh()).exp();
    x = gain.cwiseProduct((weight * x + bias + shift).cwiseMax(0.0F));
    row += bias.size();
  }
  return x;
}

TEST(FamilyFile, AnArmsLayersAreWhatEMakesOfTheFamilys) {
  CompensationModel family = family_of_twenty(1.0F);
  const FamilyMember member{"", Eigen::Vector3f(0.5F, -1.0F, 2.0F), Eigen::Matrix3f::Identity()};
  const CompensationModel one = model_of_arm(family, member);
  const Eigen::VectorXf x = Eigen::VectorXf::Random(family.layers[0].weight.cols());
  Eigen::VectorXf plain = x;
  for (std::size_t i = 0; i < 2; ++i) {
    plain = (one.layers[i].weight * plain + one.layers[i].bias).cwiseMax(0.0F);
  }
  const Eigen::VectorXf expected = hidden_output(family, member.e, x);
  ASSERT_GT(expected.norm(), 0.01F);
  EXPECT_TRUE(plain.isApprox(expected, 1e-5F));
  const CompensationModel again = family_of(one);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(again.layers[i].weight.isApprox(family.layers[i].weight, 1e-5F));
    EXPECT_LT((again.layers[i].bias - family.layers[i].bias).cwiseAbs().maxCoeff(), 1e-5F);
  }
}

// Files of before have the first layer's shifts alone.
TEST(FamilyFile, OneWhoseFirstLayerAloneReadsEIsRead) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "model.safetensors";
  CompensationModel family = family_of_twenty(0.0F);
  family.family->shifts.bottomRows(9).setZero();
  write_model(path, family);
  Safetensors content = parse_safetensors(read_file(path), "m");
  content.tensors.erase("family.gains");
  Tensor& columns = content.tensors.at("family.columns");
  columns.shape[0] = 7;
  columns.values.resize(7 * 3);
  write_file_atomically(path, safetensors_bytes(content));
  const CompensationModel back = read_model(path);
  EXPECT_EQ(back.family->shifts, family.family->shifts);
  EXPECT_TRUE(back.family->log_gains.isZero(0.0F));
  columns.shape[0] = 6;
  columns.values.resize(6 * 3);
  write_file_atomically(path, safetensors_bytes(content));
  EXPECT_THAT([&] { (void)read_model(path); },
              ThrowsMessage<InputError>(HasSubstr("family.columns is 6 by 3; expected 16")));
}

}  // namespace
}  // namespace limber
