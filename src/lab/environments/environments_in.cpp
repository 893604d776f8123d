#include <algorithm>
#include <filesystem>

#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/utf8.hpp"
#include "limber/lab/planning_experiment.hpp"

namespace limber {

std::vector<EnvironmentCase> environments_in(const fs::path& folder, const ArmDescription& arm) {
  if (fs::is_regular_file(folder)) {
    return {{folder.stem().string(), load_environment(folder, arm)}};
  }
  refuse_if(!fs::is_directory(folder), "{}: no folder", folder.string());
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".yaml") {
      files.push_back(entry.path());
    }
  }
  refuse_if(files.empty(), "{}: no *.yaml in it", folder.string());
  std::sort(files.begin(), files.end());
  std::vector<EnvironmentCase> cases;
  for (const fs::path& file : files) {
    if (!is_utf8(file.string())) {
      throw InputError(file.string() + ": the name is not UTF-8; rename the file");
    }
    cases.push_back({file.stem().string(), load_environment(file, arm)});
  }
  return cases;
}

}  // namespace limber
