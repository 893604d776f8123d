#pragma once
// For those who ask a model where the arm goes.

#include <cstdint>
#include <filesystem>
#include <string>

#include "limber/network/compensation_model.hpp"

namespace limber {

/// Versions of ONNX's format and of protobuf that this program was built with, "IR 8, protobuf
/// 3021012"; empty if it was built without.
std::string onnx_version();

/// Writes the network with its normalisation as ONNX (docs/formats.md): input `query`
/// [batch, inputs] and output `answer` [batch, outputs], both in limber's units and in the order of
/// the model's layout and form. Of an ensemble, the best member. A model with bounds, and
/// with its arm's description, has a second output, `next`: B_t in the layout's numbers, composed
/// and kept within the bounds.
/// @throws InputError if the program was built without ONNX (what to install in the message).
void write_onnx(const std::filesystem::path& path, const CompensationModel& model);

/// `count` seeded queries, up to a range away from where the model's normalisation has 0, and the
/// network's answers to them, to compare another program with: CSV columns query_0 …, answer_0 …,
/// nine digits.
std::string reference_queries_csv(const CompensationModel& model, int count, std::uint64_t seed);

}  // namespace limber
