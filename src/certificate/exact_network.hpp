#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "limber/common/cpu_level.hpp"
#include "limber/network/compensation_model.hpp"

namespace limber {

/// Eight rows of a column, which are computed together.
struct alignas(64) Eight {
  double value[8] = {};
};

/// One layer of a network for two inputs at once, so that its weights are read once. A row's sum
/// starts with its bias and grows in the order of the columns, without fused multiply-adds: the
/// result is the same to the bit on every CPU.
struct LayerOfTwo {
  const Eight* weight;  ///< all columns of the first eight rows, then those of the next eight, …
  const Eight* bias;    ///< one value per row
  std::size_t eights;   ///< rows, in eights
  std::size_t columns;
  bool with_relu;
};

/// @param nonzero  the columns where either input is not 0; the others add nothing
/// @param x        the two inputs
/// @param y        the two results, `eights` each, overwritten
using LayerOfTwoKernel = void (*)(const LayerOfTwo& layer, const std::size_t* nonzero,
                                  std::size_t nonzero_count, const double* const (&x)[2],
                                  Eight* const (&y)[2]);

LayerOfTwoKernel layer_of_two_kernel(CpuLevel level);

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
