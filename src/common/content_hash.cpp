#include "limber/common/content_hash.hpp"

#include <fmt/format.h>

#include "limber/common/atomic_file.hpp"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace limber {

namespace {

std::string digits_of(const XXH128_hash_t& hash) {
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

}  // namespace

std::string content_hash(std::string_view content) {
  return digits_of(XXH3_128bits(content.data(), content.size()));
}

std::string file_hash(const std::filesystem::path& path) {
  XXH3_state_t state;
  XXH3_INITSTATE(&state);
  XXH3_128bits_reset(&state);
  read_blocks(path, [&](std::string_view block) {
    XXH3_128bits_update(&state, block.data(), block.size());
  });
  return digits_of(XXH3_128bits_digest(&state));
}

}  // namespace limber
