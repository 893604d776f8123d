#include "limber/lab/speed_benchmark.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "limber/common/cpu_level.hpp"
#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/common/seconds_since.hpp"
#include "limber/common/statistics.hpp"
#include "limber/forward/forward_model.hpp"
#include "limber/forward/rollout_batch.hpp"
#include "limber/network/packed_network.hpp"
#include "limber/network/past_commands.hpp"
#include "limber/network/untrained_model.hpp"
#include "network_peer.hpp"

namespace limber {

namespace {

using Eigen::MatrixXf;

constexpr int kInputs = 1024;                           // different queries, asked again and again
constexpr std::int64_t kMinPasses = 10;                 // of a measurement; the median counts
constexpr std::chrono::seconds kLongestMeasurement{4};  // a slow peer's; a million take limber one
constexpr int kBatchSizes[] = {1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024};
constexpr int kParallelBatch = 16384;  // split over threads
// The system wakes a thread where the one that woke it runs, and takes some hundredths of a second
// to move it to an idle core.
constexpr std::int64_t kMinParallelQueries = 64 * kParallelBatch;
constexpr int kTile = 64;              // queries at a time while the layers are timed
constexpr long kPeakRounds = 200'000;  // 0.3 ms at 4 GHz
constexpr long kPeakPasses = 40;
constexpr double kSteadyPeak = 0.05;  // largest relative difference of the peak, before and after
constexpr int kPeakAttempts = 5;
constexpr double kPeerAgreement = 1e-4;  // [m, rad] between limber's answers and a peer's, float32

double seconds_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return seconds_since(start);
}

// Queries per second from the median pass, where `pass` asks `queries_per_pass`. Passes take less
// than a millisecond, so that on a busy machine most of them run without being interrupted.
double rate_of(std::int64_t queries, std::int64_t queries_per_pass,
               const std::function<void()>& pass) {
  pass();
  const std::int64_t passes = std::max(kMinPasses, queries / queries_per_pass);
  const auto start = std::chrono::steady_clock::now();
  std::vector<double> seconds;
  for (std::int64_t k = 0; k < passes; ++k) {
    throw_if_interrupted();
    seconds.push_back(seconds_of(pass));
    if (k + 1 >= kMinPasses && std::chrono::steady_clock::now() - start > kLongestMeasurement) {
      break;
    }
  }
  return double(queries_per_pass) / median(std::move(seconds));
}

struct Queries {
  MatrixXf previous_kpa;
  MatrixXf current_kpa;
  MatrixXf previous;
  MatrixXf next;
};

// Random pressures; backbones as the unloaded arm has them at others.
// With commands of frames ago for whichever network reads them.
Queries random_queries(const ArmDescription& arm, int count, std::uint64_t seed) {
  RandomStream random(seed, 1);
  const auto pressures = [&](int rows) {
    return MatrixXf(MatrixXf::NullaryExpr(rows, count, [&](Eigen::Index i, Eigen::Index) {
      const PressureLimits& limits = arm.limits_of_channel(int(i) % arm.channel_count());
      return float(random.uniform(limits.lower_kpa, limits.upper_kpa));
    }));
  };
  const int commands = arm.channel_count() * (1 + int(default_past_commands(arm).size()));
  const MatrixXf before = pressures(arm.channel_count());
  const MatrixXf zero = MatrixXf::Zero(pose_size(arm.dimension) * arm.point_count(), count);
  Queries queries{pressures(commands), pressures(commands), zero, zero};
  ForwardModel::Workspace workspace;
  ForwardModel(arm).step_batch(before, before, queries.next, queries.previous, workspace);
  return queries;
}

double batch_rate(const ForwardModel& model, Queries& queries, int size, std::int64_t count) {
  ForwardModel::Workspace workspace;
  const int commands = model.command_size();
  return rate_of(count, queries.next.cols(), [&] {
    for (Eigen::Index j = 0; j < queries.next.cols(); j += size) {
      model.step_batch(queries.previous_kpa.block(0, j, commands, size),
                       queries.current_kpa.block(0, j, commands, size),
                       queries.previous.middleCols(j, size), queries.next.middleCols(j, size),
                       workspace);
    }
  });
}

double single_rate(const ForwardModel& model, Queries& queries, std::int64_t count) {
  if (model.dimension() == Dimension::space) {
    return batch_rate(model, queries, 1, count);
  }
  ForwardModel::Workspace workspace;
  const int points = model.point_count();
  return rate_of(count, queries.next.cols(), [&] {
    for (Eigen::Index j = 0; j < queries.next.cols(); ++j) {
      model.step(queries.previous_kpa.col(j), queries.current_kpa.col(j),
                 Eigen::Map<const Backbone>(queries.previous.col(j).data(), points, kPoseSize),
                 Eigen::Map<Backbone>(queries.next.col(j).data(), points, kPoseSize), workspace);
    }
  });
}

double fma_peak_gmac_per_s() {
  const GemmKernels& kernels = gemm_kernels();
  volatile float keep = 0.0F;
  const double rounds_per_s = rate_of(kPeakPasses * kPeakRounds, kPeakRounds,
                                      [&] { keep = kernels.multiply_add(kPeakRounds); });
  return rounds_per_s * kernels.multiply_adds_per_round / 1e9;
}

// From a chain of operations, each of which takes a cycle and waits for the one before. They are
// exclusive ors of two registers, because some CPUs execute additions of small constants early.
double clock_ghz() {
  constexpr long kRounds = 100'000;
  constexpr int kOperations = 8;
  return 1e-9 * kOperations * rate_of(kPeakPasses * kRounds, kRounds, [] {
           long value = 0;
           const long other = 0x5555;
           for (long r = 0; r < kRounds; ++r) {
#if defined(__x86_64__)
             asm volatile(
                 "xor %1, %0; xor %1, %0; xor %1, %0; xor %1, %0;"
                 "xor %1, %0; xor %1, %0; xor %1, %0; xor %1, %0"
                 : "+r"(value)
                 : "r"(other));
#elif defined(__aarch64__)
             asm volatile(
                 "eor %0, %0, %1; eor %0, %0, %1; eor %0, %0, %1; eor %0, %0, %1;"
                 "eor %0, %0, %1; eor %0, %0, %1; eor %0, %0, %1; eor %0, %0, %1"
                 : "+r"(value)
                 : "r"(other));
#endif
           }
         });
}

struct PeakShare {
  double peak_gmac_per_s = 0.0;
  double difference = 1.0;  // relative, between before and after
  double fraction = 0.0;
};

// The hidden layers' multiply-adds over the peak, both taken within the same tenth of a second.
PeakShare hidden_layer_share(const PackedNetwork& network, const Queries& queries,
                             std::uint64_t seed) {
  RandomStream random(seed, 2);
  AlignedFloats input(std::size_t(network.input_size()) * kTile);
  std::generate(input.begin(), input.end(), [&] { return float(random.uniform(-1.0, 1.0)); });
  AlignedFloats scratch(2 * std::size_t(network.padded_width()) * kTile);
  const int hidden = network.layer_count() - 1;
  PeakShare best;
  for (int attempt = 0; attempt < kPeakAttempts && best.difference > kSteadyPeak; ++attempt) {
    const double before = fma_peak_gmac_per_s();
    const double tiles_per_s =
        rate_of(
            50 * queries.next.cols(), kTile,
            [&] { network.evaluate_layers_of_rows(hidden, kTile, input.data(), scratch.data()); }) /
        kTile;
    const double after = fma_peak_gmac_per_s();
    const double peak = 0.5 * (before + after);
    const double difference = std::abs(after - before) / peak;
    if (difference < best.difference) {
      const double gmac_per_s = tiles_per_s * kTile * double(network.multiply_adds(hidden)) / 1e9;
      best = {peak, difference, gmac_per_s / peak};
    }
  }
  return best;
}

class SpeedMeasurement {
 public:
  SpeedMeasurement(const ArmDescription& arm, const SpeedSettings& settings, int networks,
                   int peers)
      : arm_(arm),
        settings_(settings),
        queries_(random_queries(arm, kInputs, settings.seed)),
        progress_("bench", "measurements",
                  std::uint64_t(2 + networks * kPerNetwork + peers * kPerPeer), settings.progress) {
  }

  void measure_no_load(SpeedReport& report) {
    const ForwardModel model(arm_);
    report.no_load_single = {1, 1, single_rate(model, queries_, settings_.queries)};
    progress_.advance();
    report.no_load_batch = {kInputs, 1, batch_rate(model, queries_, kInputs, settings_.queries)};
    progress_.advance();
  }

  NetworkSpeed measure_network(const CompensationModel& compensation, SpeedReport& report) {
    const ForwardModel model(arm_, compensation);
    NetworkSpeed speed;
    speed.shape = compensation.shape();
    speed.layout = to_string(compensation.layout);
    speed.single = {1, 1, single_rate(model, queries_, settings_.queries)};
    progress_.advance();
    for (const int size : kBatchSizes) {
      speed.batches.push_back({size, 1, batch_rate(model, queries_, size, settings_.queries)});
      progress_.advance();
    }
    speed.batch = fastest_batch(speed.batches);
    measure_threads(model, speed);
    const PeakShare share =
        hidden_layer_share(PackedNetwork(compensation, cpu_level()), queries_, settings_.seed);
    progress_.advance();
    speed.fraction_of_fma_peak = share.fraction;
    report.fma_peak_gmac_per_s = share.peak_gmac_per_s;
    report.fma_peak_difference = share.difference;
    return speed;
  }

  PeerSpeed measure_peer(const PeerMaker& maker, const CompensationModel& compensation);

 private:
  void require_agreement(const std::string& peer, const CompensationModel& compensation);

  static constexpr int kPerNetwork = 1 + int(std::size(kBatchSizes)) + 1 + 1;
  static constexpr int kPerPeer = int(std::size(kBatchSizes));

  void measure_threads(const ForwardModel& model, NetworkSpeed& speed) {
    Queries many = random_queries(arm_, kParallelBatch, settings_.seed);
    const std::int64_t queries = std::max(settings_.queries, kMinParallelQueries);
    for (const int jobs : {1, settings_.jobs}) {
      ParallelForward parallel(jobs);
      speed.batches.push_back(
          {kParallelBatch, parallel.jobs(), rate_of(queries, kParallelBatch, [&] {
             parallel.step_batch(model, many.previous_kpa, many.current_kpa, many.previous,
                                 many.next);
           })});
    }
    progress_.advance();
  }

  const ArmDescription& arm_;
  SpeedSettings settings_;
  Queries queries_;
  Progress progress_;
};

// The paper's layout with another library for the network. B̃ comes from limber, so that the
// network alone makes the difference.
PeerSpeed SpeedMeasurement::measure_peer(const PeerMaker& maker,
                                         const CompensationModel& compensation) {
  const std::vector<Layer> layers = folded_layers(compensation);
  auto peer_layers = mapped<PeerLayer>(layers, [&](const Layer& layer) {
    return PeerLayer{int(layer.weight.cols()), int(layer.weight.rows()), layer.weight.data(),
                     layer.bias.data()};
  });
  const ForwardModel no_load(arm_);
  ForwardModel::Workspace workspace;
  const int n = arm_.channel_count();
  const int size = kPoseSize * arm_.point_count();
  PeerSpeed speed{maker.name, {}, {}};
  for (const int batch : kBatchSizes) {
    MatrixXf input(2 * n + 2 * size, batch);
    MatrixXf unloaded = MatrixXf::Zero(size, batch);
    MatrixXf output(size, batch);
    const std::unique_ptr<NetworkPeer> peer(
        maker.make(peer_layers.data(), int(peer_layers.size()), batch));
    queries_.next.setConstant(std::numeric_limits<float>::quiet_NaN());
    const double rate = rate_of(settings_.queries, kInputs, [&] {
      for (int j = 0; j < kInputs; j += batch) {
        const auto current = queries_.current_kpa.middleCols(j, batch);
        no_load.step_batch(current, current, unloaded, unloaded, workspace);
        input.topRows(n) = queries_.previous_kpa.middleCols(j, batch);
        input.middleRows(n, n) = current;
        input.middleRows(2 * n, size) = queries_.previous.middleCols(j, batch);
        input.bottomRows(size) = unloaded;
        peer->evaluate(input.data(), output.data());
        queries_.next.middleCols(j, batch) = unloaded + output;
      }
    });
    require_agreement(maker.name, compensation);
    speed.batches.push_back({batch, 1, rate});
    progress_.advance();
  }
  speed.single = speed.batches.front();
  return speed;
}

// A peer that computes something else would prove nothing. Its answers are in queries_.next.
void SpeedMeasurement::require_agreement(const std::string& peer,
                                         const CompensationModel& compensation) {
  ForwardModel::Workspace workspace;
  const MatrixXf peer_answers = queries_.next;
  ForwardModel(arm_, compensation)
      .step_batch(queries_.previous_kpa, queries_.current_kpa, queries_.previous, queries_.next,
                  workspace);
  const double difference = (peer_answers - queries_.next).cwiseAbs().maxCoeff();
  if (!(difference < kPeerAgreement) || !peer_answers.allFinite()) {
    throw SystemFault(fmt::format(
        "bench: the {} peer's answers are {:.2g} off limber's; expected less than {:.0e}", peer,
        difference, kPeerAgreement));
  }
}

}  // namespace

SpeedReport measure_speed(const ArmDescription& arm, const CompensationModel* model,
                          const SpeedSettings& settings) {
  // In space there are gap poses alone, of the default's form; and no peer that knows them.
  CompensationModel paper =
      arm.is_spatial()
          ? untrained_model(arm, BackboneLayout::gap_poses, {100, 100, 100}, settings.seed,
                            OutputForm::gated_change, true, default_past_commands(arm))
          : untrained_model(arm, BackboneLayout::base_poses, {100, 100, 100}, settings.seed);
  const bool model_differs =
      model != nullptr && (model->layout != paper.layout || model->shape() != paper.shape());
  if (model != nullptr && !model_differs) {
    paper = *model;
  }
  SpeedReport report;
  report.cpu = cpu_name();
  report.cpu_level = to_string(cpu_level());
  report.queries = settings.queries;
  report.lanes = gemm_kernels().lanes;
  report.clock_ghz = clock_ghz();
  const std::vector<PeerMaker> makers =
      arm.is_spatial() ? std::vector<PeerMaker>() : peer_makers(settings.optional_peers);
  SpeedMeasurement measurement(arm, settings, model_differs ? 2 : 1, int(makers.size()));
  measurement.measure_no_load(report);
  if (model_differs) {
    report.model.push_back(measurement.measure_network(*model, report));
  }
  report.paper_shape = measurement.measure_network(paper, report);
  report.threads = report.paper_shape.batches.back().threads;
  for (const PeerMaker& maker : makers) {
    report.peers.push_back(measurement.measure_peer(maker, paper));
  }
  return report;
}

}  // namespace limber
