#pragma once

#include <Eigen/Core>

#include "limber/network/compensation_model.hpp"
#include "limber/training/parameter_layout.hpp"

namespace limber {

/// The family that such a network and its arms' vectors are, in a scale in which these have mean 0
/// and unit covariance.
void make_family(const ParameterLayout& layout, const Eigen::VectorXf& parameters,
                 CompensationModel& model);

}  // namespace limber
