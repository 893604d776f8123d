#include "limber/arm/damped_solve.hpp"

#include <limits>

#include <gmock/gmock.h>

#include "limber/common/random_stream.hpp"

namespace limber {
namespace {

constexpr double kRounding = 1e-12;  // of systems of numbers about 1

Eigen::MatrixXd random_matrix(Eigen::Index rows, Eigen::Index cols, int stream) {
  RandomStream random(11, static_cast<std::uint64_t>(stream));
  return Eigen::MatrixXd::NullaryExpr(rows, cols, [&] { return random.uniform(-1.0, 1.0); });
}

TEST(DampedSolve, OfADiagonalDividesByItAndTheDamping) {
  const Eigen::Vector3d diagonal(1.0, 2.0, 4.0);
  const Eigen::Vector3d x =
      damped_solve(Eigen::Matrix3d(diagonal.asDiagonal()), Eigen::Vector3d(3.0, 6.0, 9.0), 0.5);
  EXPECT_LT((x - Eigen::Vector3d(2.0, 2.4, 2.0)).norm(), kRounding);
}

// Its gradient vanishes there: Aᵀ(Ax − b) + λx = 0.
TEST(DampedSolve, IsTheLeastOfItsDampedSquares) {
  const Eigen::MatrixXd a = random_matrix(7, 4, 0);
  const Eigen::VectorXd b = random_matrix(7, 1, 1);
  for (const double damping : {0.0, 1e-3, 1.0}) {
    const Eigen::VectorXd x =
        damped_solve((a.transpose() * a).eval(), (a.transpose() * b).eval(), damping);
    EXPECT_LT((a.transpose() * (a * x - b) + damping * x).norm(), kRounding);
  }
}

TEST(DampedSolve, BothNormalMatricesGiveTheSameStep) {
  const Eigen::MatrixXd a = random_matrix(3, 6, 2);
  const Eigen::VectorXd b = random_matrix(3, 1, 3);
  const Eigen::VectorXd tall =
      damped_solve((a.transpose() * a).eval(), (a.transpose() * b).eval(), 0.1);
  const Eigen::VectorXd wide = a.transpose() * damped_solve((a * a.transpose()).eval(), b, 0.1);
  EXPECT_LT((tall - wide).norm(), kRounding);
}

TEST(DampedSolve, MoreDampingIsAShorterStepAndASingularMatrixIsNoHindrance) {
  const Eigen::MatrixXd a = random_matrix(3, 6, 4);
  const Eigen::MatrixXd singular = a.transpose() * a;
  const Eigen::VectorXd right = a.transpose() * random_matrix(3, 1, 5);
  double before = std::numeric_limits<double>::infinity();
  for (const double damping : {1e-3, 1e-2, 1e-1, 1.0, 10.0}) {
    const double length = damped_solve(singular, right, damping).norm();
    EXPECT_LT(length, before);
    before = length;
  }
}

}  // namespace
}  // namespace limber
