#include "limber/forward/ensemble_forward.hpp"

#include <cassert>
#include <utility>

#include "limber/arm/space_pose.hpp"
#include "limber/common/refuse_if.hpp"

namespace limber {

EnsembleForward::EnsembleForward(const ArmDescription& arm, const CompensationModel& model) {
  for (int index = 0; index < model.member_count(); ++index) {
    members_.emplace_back(arm, model.member(index));
  }
}

EnsembleForward::Prediction EnsembleForward::rollout(
    const Eigen::Ref<const Eigen::MatrixXf>& pressures_kpa,
    const Eigen::Ref<const Eigen::VectorXf>& first) const {
  const Dimension dimension = members_.front().dimension();
  const int channels = members_.front().channel_count();
  const int size = pose_size(dimension) * members_.front().point_count();
  refuse_if(
      pressures_kpa.rows() != channels || pressures_kpa.cols() < 1 || first.size() != size,
      "an ensemble's rollout got {} pressures per frame, {} frames and a backbone of {} numbers; "
      "expected {}, at least 1 and {}",
      pressures_kpa.rows(), pressures_kpa.cols(), first.size(), channels, size);
  refuse_if(!pressures_kpa.allFinite() || !first.allFinite(),
            "an ensemble's rollout got a number that is not finite");
  ForwardModel::Workspace workspace;
  std::vector<Eigen::MatrixXf> predicted;
  for (const ForwardModel& member : members_) {
    predicted.emplace_back(size, pressures_kpa.cols());
    predicted.back().col(0) = first;
    member.rollout(pressures_kpa, predicted.back(), workspace);
  }
  return mean_and_deviation(predicted, dimension);
}

EnsembleForward::Prediction mean_and_deviation(const std::vector<Eigen::MatrixXf>& members,
                                               Dimension dimension) {
  assert(!members.empty());
  const auto count = float(members.size());
  // Deviations from the first member: members that agree have a spread of exactly 0.
  const Eigen::MatrixXf& origin = members.front();
  Eigen::MatrixXf mean = Eigen::MatrixXf::Zero(origin.rows(), origin.cols());
  for (const Eigen::MatrixXf& member : members) {
    mean += (member - origin) / count;
  }
  Eigen::MatrixXf variance = Eigen::MatrixXf::Zero(origin.rows(), origin.cols());
  for (const Eigen::MatrixXf& member : members) {
    variance += (member - origin - mean).cwiseAbs2() / count;
  }
  mean += origin;
  if (dimension == Dimension::space) {
    normalise_rotations(mean);
  }
  return {std::move(mean), variance.cwiseSqrt()};
}

}  // namespace limber
