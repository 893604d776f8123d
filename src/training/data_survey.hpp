#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/network/compensation_model.hpp"
#include "limber/training/trainer.hpp"

namespace limber {

/// What all data for training have together; where they come in slices, each is read once.
struct DataSurvey {
  GapBounds bounds;  ///< and those of the model that training starts from
  bool from_setpoints = false;
  std::string content;  ///< hash of the slices; empty where there are none
};

/// @param on_slice  is given every slice of the first epoch, and its episodes
/// @throws InputError if they don't fit the arm or each other.
DataSurvey survey_of(
    const ArmDescription& arm, const TrainingData& data, std::uint64_t seed,
    const CompensationModel* start,
    const std::function<void(const std::vector<int>&, const std::vector<Episode>&)>& on_slice);

/// Of everything in them that training, validation and errors are made of.
std::string hash_of(const std::vector<Episode>& episodes);

/// The numbers of a matrix of floats as they lie in memory, for hashes.
template <class Matrix>
std::string_view number_bytes(const Matrix& matrix) {
  return {reinterpret_cast<const char*>(matrix.data()),
          std::size_t(matrix.size()) * sizeof(typename Matrix::Scalar)};
}

}  // namespace limber
