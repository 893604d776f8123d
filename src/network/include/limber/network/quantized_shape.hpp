#pragma once
// For those who plan.

#include <cstdint>

#include <Eigen/Core>

#include "limber/arm/backbone.hpp"

namespace limber {

/// Backbones in 16 bits per number, one per column. Every plate but the first has its pose as seen
/// from the plate before it, (Δx, Δy) in 1/32767 of the arm's length and Δθ in 1/32767 of π. Errors
/// add up along the arm, to some tenths of a millimetre at the tip of one metre. So quantized
/// shapes may propose motions, but never judge them.
using QuantizedShapes = Eigen::Matrix<std::int16_t, Eigen::Dynamic, Eigen::Dynamic>;
using QuantizedShapeRef = Eigen::Ref<const Eigen::Matrix<std::int16_t, Eigen::Dynamic, 1>>;

/// @param backbone  m×3
/// @param shape     size 3(m−1); what does not fit is cut off
void round_shape(const Eigen::Ref<const Backbone>& backbone, double arm_length_m,
                 Eigen::Ref<Eigen::Matrix<std::int16_t, Eigen::Dynamic, 1>> shape);

/// The backbone between two shapes, at a fraction of the change; every gap bends evenly.
/// @param fraction  in [0, 1]
/// @param backbone  m×3, of which the first row, the base, is given
void blend_shapes(const QuantizedShapeRef& from, const QuantizedShapeRef& to, float fraction,
                  double arm_length_m, Eigen::Ref<Backbone> backbone);

}  // namespace limber
