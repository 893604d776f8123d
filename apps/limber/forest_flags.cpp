#include "forest_flags.hpp"

#include <filesystem>

#include "file_kind.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"

namespace limber {

void ForestFlags::add_to(CLI::App& app) {
  app.add_option("--forest", file_,
                 "Stored motions of model and start, looked through before much is searched; "
                 "grown and written here where there are none, or those of another model");
  app.add_flag("--build-forest", build_,
               "Grow them anew; as MODEL.forest, to be named by --forest from then on, where "
               "--forest names no file");
  app.add_option("--forest-nodes", nodes_, "How many, where they are grown")
      ->check(CLI::Range(1, 1 << 24))
      ->capture_default_str();
}

std::string ForestFlags::path_beside(const std::string& model_file) const {
  if (!file_.empty()) {
    return file_;
  }
  if (model_file.empty()) {
    throw InputError("--build-forest with --no-load: --forest has to say where to");
  }
  return std::filesystem::path(model_file).replace_extension(".forest").string();
}

std::optional<Forest> ForestFlags::forest(const ArmDescription& arm, const MotionModel& model,
                                          const std::string& model_file, const ArmStart& start,
                                          const CommonFlags& flags) const {
  const std::string path = path_beside(model_file);
  const ForestKey key =
      forest_key(arm, model_file.empty() ? "" : content_hash(read_file(model_file)),
                 model.valves().parameters(), start);
  std::error_code error;
  if (std::filesystem::exists(path, error) && build_) {
    if (kind_of(read_file(path)) != FileKind::forest) {
      throw InputError(path + ": no forest; only a forest is replaced by another");
    }
    say(flags, "{}: asked for; growing it anew", path);
  } else if (std::filesystem::exists(path, error)) {
    Forest stored = read_forest(path);
    if (is_grown_for(stored, arm, key)) {
      try {
        require_forest_of(stored, arm, model.valves().parameters(), start);
      } catch (const InputError& refusal) {
        throw InputError(fmt::format("{}: {}", path, refusal.what()));
      }
      return stored;
    }
    say(flags, "{}: grown for another arm, model, valves or start; growing it anew", path);
  }
  refuse_to_overwrite(path, true);
  ForestSettings settings;
  settings.nodes = nodes_;
  settings.seed = flags.seed;
  settings.jobs = flags.jobs;
  Progress progress("forest", "nodes", std::uint64_t(nodes_), flags.progress());
  std::optional<Forest> grown = grow_forest(arm, model, key, start, settings, [&](int nodes) {
    progress.update(std::uint64_t(nodes));
    return !interrupt_requested();
  });
  progress.finish();
  if (grown) {
    write_forest(path, *grown);
    say(flags, "{}: {} motions from the start", path, grown->size());
  }
  return grown;
}

}  // namespace limber
