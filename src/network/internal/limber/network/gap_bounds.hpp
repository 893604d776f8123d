#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "limber/common/json.hpp"
#include "limber/network/compensation_model.hpp"

namespace limber {

/// @throws InputError beginning with `where` and naming the tensor, unless there is one number for
/// every gap, all are finite, lengths are > 0 and no smallest exceeds its largest.
void validate(const GapBounds& bounds, Dimension dimension, int point_count,
              const std::string& where);

/// Bounds that hold both.
GapBounds joined(const GapBounds& a, const GapBounds& b);

/// @throws InputError if the model has no bounds, which planning asks for: without them, small
/// errors of lengths can add up along a motion. Names the command that adds them.
/// @param file  the model's, for the message
void require_bounded(const CompensationModel& model, const std::string& file);

/// The object `bounds` of `train` and `inspect` with --json.
Json to_json(const GapBounds& bounds);
/// One line for people: the range over all gaps.
std::string to_text(const GapBounds& bounds);

}  // namespace limber
