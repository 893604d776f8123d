#include "limber/training/episode_slices.hpp"

#include <algorithm>
#include <numeric>

#include "limber/common/random_stream.hpp"
#include "shuffle.hpp"

namespace limber {

namespace {

constexpr std::uint64_t kSliceStreams = 1ULL << 35;  // of the seed, far from those of the trainer

}  // namespace

std::vector<std::vector<int>> slices_of(const SlicedEpisodes& episodes, std::uint64_t seed,
                                        int epoch) {
  const std::vector<int>& counts = episodes.frame_counts;
  const auto frames = std::reduce(counts.begin(), counts.end(), std::int64_t{0});
  const auto wanted = (frames + episodes.slice_frames - 1) / episodes.slice_frames;
  std::vector<std::vector<int>> slices(std::size_t(std::max<std::int64_t>(wanted, 1)));
  std::vector<int> order(counts.size());
  std::iota(order.begin(), order.end(), 0);
  RandomStream random(seed, kSliceStreams + std::uint64_t(epoch));
  shuffle(random, order);
  std::int64_t before = 0;
  for (const int episode : order) {
    slices[before * wanted / frames].push_back(episode);
    before += counts[episode];
  }
  std::erase_if(slices, [&](const auto& slice) { return slice.empty() && !order.empty(); });
  for (std::vector<int>& slice : slices) {
    std::ranges::sort(slice);
  }
  return slices;
}

std::vector<Episode> training_sample(const TrainingData& data) {
  return data.slices.frame_counts.empty() ? data.training
                                          : data.slices.read(slices_of(data.slices, 0, 0).front());
}

}  // namespace limber
