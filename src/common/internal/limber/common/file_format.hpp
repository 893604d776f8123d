#pragma once

#include <string>
#include <string_view>

namespace limber {

inline constexpr std::string_view kHdf5Format = "HDF5";
inline constexpr std::string_view kSafetensorsFormat = "safetensors";

/// One of these two, by a file's first nine bytes; empty of a file of any other format.
std::string_view binary_format(std::string_view head);

/// Tells a wrong file from a damaged one, which readers would call it.
/// @param expected  one of the two, or a format of text
/// @throws InputError beginning with `where` and saying what the file holds, where `content` is of
/// the other one of the two, or of either of them in place of text.
void refuse_other_format(std::string_view content, std::string_view expected,
                         const std::string& where);

}  // namespace limber
