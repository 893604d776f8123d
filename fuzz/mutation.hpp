#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "limber/common/random_stream.hpp"

namespace limber::fuzz {

/// The words of a dictionary as libFuzzer reads it: "…" of each line, \\, \" and \xNN within.
std::vector<std::string> dictionary_words(std::string_view text);

/// One of `inputs` changed in one to four places: bits, bytes, pieces left out, doubled or taken
/// from another input, words of the dictionary, numbers. What libFuzzer does without its eye for
/// coverage, for machines without clang. Depends on the stream alone.
/// @pre inputs are not empty
std::string mutant(const std::vector<std::string>& inputs, const std::vector<std::string>& words,
                   RandomStream& random);

}  // namespace limber::fuzz
