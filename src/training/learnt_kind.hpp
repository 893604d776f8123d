#pragma once

#include <vector>

#include "limber/network/compensation_model.hpp"
#include "limber/training/trainer.hpp"

namespace limber {

/// Whether all episodes hold set points alone (Episode::setpoints_only).
/// @throws InputError if some do and others were measured: a network learns from one kind.
bool learns_from_setpoints(const TrainingData& data);

/// What training asks first of all of its episodes (require_episodes_of).
/// @throws InputError saying what the episodes are for.
void require_data_of(const TrainingData& data, const ArmDescription& arm);

/// @throws InputError unless the episodes are of the kind that the network learnt from.
void require_kind_learnt(const CompensationModel& network, const std::vector<Episode>& episodes);

}  // namespace limber
