#include "limber/common/content_hash.hpp"

#include <fmt/format.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"

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

std::string file_hash(const fs::path& path) {
  XXH3_state_t state;
  XXH3_INITSTATE(&state);
  XXH3_128bits_reset(&state);
  read_blocks(path, [&](std::string_view block) {
    XXH3_128bits_update(&state, block.data(), block.size());
  });
  return digits_of(XXH3_128bits_digest(&state));
}

std::string add_different(std::map<std::string, std::string>& path_of_hash, const fs::path& path) {
  const auto [other, is_new] = path_of_hash.emplace(file_hash(path), path.string());
  if (!is_new) {
    throw InputError(
        fmt::format("{}: the same recording as {}; give it once", path.string(), other->second));
  }
  return other->first;
}

}  // namespace limber
