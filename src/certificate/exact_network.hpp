#pragma once

#include <array>
#include <vector>

#include "layer_of_two.hpp"
#include "limber/common/cpu_level.hpp"
#include "limber/network/compensation_model.hpp"

namespace limber {

/// The network's layers and normalisations in double precision, for two inputs at a time. Threads:
/// constant after construction.
class ExactNetwork {
 public:
  /// Two columns, and what lies between layers. Made by its first use, kept for the next.
  struct Workspace {
    std::array<std::vector<double>, 2> input;   ///< not normalised; written by the caller
    std::array<std::vector<double>, 2> output;  ///< as the network's file has it in metres and rad
    std::array<std::vector<Eight>, 2> now, next;
    std::vector<std::size_t> nonzero;
  };

  /// Copies what it needs: of an ensemble, its first member.
  explicit ExactNetwork(const CompensationModel& network, CpuLevel level = cpu_level());

  /// Of both inputs. Gates' arguments come behind the changes.
  void run(Workspace& workspace) const;

 private:
  struct PackedLayer {
    std::size_t rows = 0;
    std::size_t columns = 0;
    std::vector<Eight> weight;
    std::vector<Eight> bias;
  };
  struct Affine {
    std::vector<double> offset, scale;
  };
  static PackedLayer packed(const Layer& layer);
  static Affine in_double(const Normalisation& normalisation);

  std::vector<PackedLayer> layers_;
  Affine input_, output_;
  LayerOfTwoKernel kernel_;
};

}  // namespace limber
