#include "further_plans.hpp"

#include "limber/common/content_hash.hpp"
#include "limber/common/filesystem.hpp"

namespace limber {

void FurtherPlans::add_to(CLI::App& app) {
  app.add_option("--plans-out", out_,
                 "With --replan: folder to write, each plan after the first as 01.json, 02.json, "
                 "…, and as 01.yaml, … what it was certified for: limber verify repeats that");
}

void FurtherPlans::prepare(const std::vector<fs::path>& inputs, const CommonFlags& flags) {
  if (are_asked_for()) {
    folder_.emplace(out_, "execute", OutputFolder::start(false, flags.force), inputs);
  }
}

void FurtherPlans::take(const ClosedLoop& loop) {
  if (folder_) {
    plans_ = loop.further_plans();
  }
}

void FurtherPlans::write(const std::string& model_file) {
  if (!folder_) {
    return;
  }
  const std::string model_hash = file_hash(model_file);
  std::size_t number = 0;
  for (FollowedPlan& followed : plans_) {
    const std::string name = fmt::format("{:02}", ++number);
    folder_->write(name + ".yaml", environment_to_yaml(followed.environment));
    followed.plan.model_hash = model_hash;
    const std::string file = name + ".json";
    folder_->write_with({file}, [&] { write_plan(folder_->path() / file, followed.plan); });
  }
}

}  // namespace limber
