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
                 "Stored motions of model and start, tried before searching; grown and written "
                 "here if there are none, or if they are of another model");
  app.add_flag("--build-forest", build_,
               "Grow the stored motions again. If --forest names no file, they are written to "
               "MODEL.forest, which --forest can name from then on");
  app.add_option("--forest-nodes", nodes_, "How many motions to grow")
      ->check(CLI::Range(1, 1 << 24))
      ->capture_default_str();
}

std::string ForestFlags::path_beside(const std::string& model_file) const {
  if (!file_.empty()) {
    return file_;
  }
  if (model_file.empty()) {
    throw InputError("--build-forest with --no-load: --forest has to name the file to write");
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
      throw InputError(path + ": no forest; only a forest can be replaced by a forest");
    }
    say(flags, "{}: growing it again, as asked for", path);
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
    say(flags, "{}: grown for another arm, model, valves or start; growing it again", path);
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
