#pragma once

#include <cstdint>
#include <optional>

#include "limber/arm/arm_description.hpp"
#include "limber/data/recording.hpp"
#include "limber/network/compensation_model.hpp"
#include "limber/sim/related_arms.hpp"
#include "limber/training/adaptation.hpp"

namespace limber {

/// Virtual arms that a family has not learnt from, each of which is known by some seconds of its
/// motion alone.
struct UnseenArms {
  PhysicsVariation variation = WidePhysics{};
  double seconds = 60.0;  ///< of identifying_schedule(), that e is fitted to
};

struct UnseenArm {
  ArmDescription arm;  ///< its physics among the virtual arm's parameters
  Adaptation adaptation;
};

/// Draws the arm, lets it move, and adapts the family to that: e alone, no weights. Of a family
/// with a tube, the model has one.
/// @param number  of the arm among those of `seed`; neither threads nor other arms matter
/// @param measures_errors  as of AdaptationSettings
UnseenArm unseen_arm(const ArmDescription& arm, const CompensationModel& family,
                     const UnseenArms& of, std::uint64_t seed, std::uint64_t number,
                     bool measures_errors = true);

/// limber's own family for arms with these dimensions, if it has one.
std::optional<CompensationModel> own_family(const ArmDescription& arm);

/// The first seconds of a run, all of it where it is shorter.
Episode first_seconds(const ArmDescription& arm, const Episode& run, double seconds);

/// An identifying run of a virtual arm, its first seconds.
Episode identifying_run(const ArmDescription& arm, double seconds, std::uint64_t seed,
                        std::uint64_t stream);

}  // namespace limber
