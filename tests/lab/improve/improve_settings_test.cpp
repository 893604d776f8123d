#include "src/lab/improve/improve_settings.hpp"

#include <functional>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/training/fine_tuning.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

ImproveSettings usable() {
  ImproveSettings settings;
  settings.data_files = {"train.h5"};
  settings.training = fine_tuning_of(best_preset());
  return settings;
}

TEST(ImproveSettings, DefaultsAreUsable) {
  EXPECT_NO_THROW(require_usable(usable()));
}

TEST(ImproveSettings, RefusalsNameTheFlagAndWhatIsAllowed) {
  const std::pair<std::function<void(ImproveSettings&)>, const char*> wrong[] = {
      {[](ImproveSettings& s) { s.rounds = 0; }, "--rounds 0: expected 1 to"},
      {[](ImproveSettings& s) { s.round_min = 0.0; }, "--round-min 0: expected minutes, over 0"},
      {[](ImproveSettings& s) { s.plan_share = -0.1; }, "--plan-share -0.1: expected 0 to 1"},
      {[](ImproveSettings& s) { s.selection = 1; }, "--selection 1: expected 2 to"},
      {[](ImproveSettings& s) { s.reported = 1; }, "--reported 1: expected 2 to"},
      {[](ImproveSettings& s) { s.training.replay_share = 2.0; }, "replay_share"},
      {[](ImproveSettings& s) { s.data_files.clear(); }, "--data: missing"},
  };
  for (const auto& [break_it, message] : wrong) {
    ImproveSettings settings = usable();
    break_it(settings);
    EXPECT_THAT([&] { require_usable(settings); }, ThrowsMessage<InputError>(HasSubstr(message)));
  }
}

TEST(ImproveSettings, AnotherRunIsNamedByWhatDiffers) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "improve.json";
  const nlohmann::ordered_json there = {{"seed", 1}, {"round_min", 10.0}, {"rounds", 3}};
  write_file_atomically(file, there.dump());
  EXPECT_NO_THROW(require_same_run(file, {{"seed", 1}, {"round_min", 10.0}}));
  EXPECT_THAT(
      [&] {
        require_same_run(file, {{"seed", 1}, {"round_min", 5.0}});
      },
      ThrowsMessage<InputError>(
          AllOf(HasSubstr("round_min = 10.0; this run has 5.0"), HasSubstr("--resume"))));
}

}  // namespace
}  // namespace limber
