#include "learnt_family.hpp"

#include <Eigen/Cholesky>

namespace limber {

namespace {

// Added to the variance of the arms' vectors: a direction that none of them uses stays one.
constexpr double kLeastArmSpread = 1e-6;

}  // namespace

void make_family(const ParameterLayout& layout, const Eigen::VectorXf& parameters,
                 CompensationModel& model) {
  const auto [size, count] = layout.arms();
  const Eigen::MatrixXd arms =
      kArmVectorScale *
      Eigen::Map<const Eigen::MatrixXf>(parameters.data() + layout.arm_offset(0), size, count)
          .cast<double>();
  const Eigen::VectorXd mean = arms.rowwise().mean();
  const Eigen::MatrixXd centred = arms.colwise() - mean;
  const Eigen::MatrixXd covariance = centred * centred.transpose() / count +
                                     kLeastArmSpread * Eigen::MatrixXd::Identity(size, size);
  const Eigen::LLT<Eigen::MatrixXd> root(covariance);
  Layer& first = model.layers.front();
  const Eigen::MatrixXd columns = first.weight.rightCols(size).cast<double>();
  first.bias += (columns * mean).cast<float>();
  first.weight.conservativeResize(Eigen::NoChange, first.weight.cols() - size);
  model.family = {(columns * Eigen::MatrixXd(root.matrixL())).cast<float>(),
                  root.matrixL().solve(centred).cast<float>(),
                  {}};
}

}  // namespace limber
