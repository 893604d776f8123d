#include "ensemble_pipeline.hpp"

#include <algorithm>

namespace limber {

namespace {

constexpr int kEnsembleTileQueries =
    64;  // all networks answer these before the next ones are asked

}  // namespace

EnsemblePipeline::EnsemblePipeline(const ArmDescription& arm, const CompensationModel* model,
                                   CpuLevel level)
    : numbers_(kPoseSize * arm.point_count()) {
  if (model == nullptr || model->asked_count() == 1) {
    members_.emplace_back(arm, model, level);
    return;
  }
  members_.reserve(static_cast<std::size_t>(model->asked_count()));
  for (int member = 0; member < model->asked_count(); ++member) {
    const CompensationModel alone = model->member(member);
    members_.emplace_back(arm, &alone, level);
  }
}

std::size_t EnsemblePipeline::scratch_size() const {
  const std::size_t one = members_.front().scratch_size();
  return members_.size() == 1 ? one
                              : one + static_cast<std::size_t>(3 * numbers_ * kEnsembleTileQueries);
}

void EnsemblePipeline::run(int count, const QueryColumns& queries, float* scratch) const {
  if (members_.size() == 1) {
    members_.front().run(count, queries, scratch);
    return;
  }
  for (int j = 0; j < count; j += kEnsembleTileQueries) {
    run_mean(std::min(kEnsembleTileQueries, count - j), queries.from(j), scratch);
  }
}

// As the first answer plus the mean of the others' differences from it: members that agree give
// their answer to the bit. `next` is written last, since it may be `previous`.
void EnsemblePipeline::run_mean(int count, const QueryColumns& queries, float* scratch) const {
  const int size = numbers_ * count;
  float* const first = scratch;
  float* const other = first + numbers_ * kEnsembleTileQueries;
  float* const sum = other + numbers_ * kEnsembleTileQueries;
  float* const rest = sum + numbers_ * kEnsembleTileQueries;
  QueryColumns asked = queries;
  asked.next = {first, numbers_};
  members_.front().run(count, asked, rest);
  std::fill_n(sum, size, 0.0F);
  asked.next = {other, numbers_};
  for (std::size_t member = 1; member < members_.size(); ++member) {
    members_[member].run(count, asked, rest);
    for (int i = 0; i < size; ++i) {
      sum[i] += other[i] - first[i];
    }
  }
  const float share = 1.0F / static_cast<float>(members_.size());
  for (int q = 0; q < count; ++q) {
    float* const next = queries.next.column(q);
    for (int i = 0; i < numbers_; ++i) {
      next[i] = first[q * numbers_ + i] + share * sum[q * numbers_ + i];
    }
  }
}

}  // namespace limber
