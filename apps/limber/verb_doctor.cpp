#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <thread>

#include <oneapi/tbb/version.h>
#include <Eigen/Core>

#include "limber/common/cpu_level.hpp"
#include "limber/common/data_folder.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/json.hpp"
#include "limber/common/version.hpp"
#include "limber/data/hdf5_version.hpp"
#include "limber/lab/rank_work.hpp"
#include "limber/lab/speed_peers.hpp"
#include "limber/network/onnx_export.hpp"
#include "limber/planning/ompl_planner.hpp"
#include "limber/sim/mujoco_version.hpp"
#include "verbs.hpp"

namespace limber {

namespace {

/// Whether the python3 that scripts would run finds them.
bool python_has_modules() {
  return std::system("python3 -c 'import h5py, numpy' >/dev/null 2>&1") == 0;
}

bool on_path(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    std::error_code ignored;
    if (!folder.empty() && fs::exists(folder + "/" + program, ignored)) {
      return true;
    }
  }
  return false;
}

class DoctorVerb final : public Verb {
 public:
  DoctorVerb()
      : Verb("doctor", "Versions, CPU features, and which optional parts are present",
             "limber doctor --json") {}
  void add_flags(CLI::App&) override {}

  int run(const CommonFlags& flags) override {
    const Json result = examine();
    print_result(flags, result, describe(result));
    return kExitDone;
  }

 private:
  static Json examine() {
    Json result;
    result["limber"] = version();
    result["compiler"] = __VERSION__;
    result["data_folder"] = data_folder().string();
    result["cpu"] = cpu_name();
    result["threads"] = std::thread::hardware_concurrency();
    result["kernels"] = to_string(cpu_level());
    for (const CpuLevel level : available_cpu_levels()) {
      result["kernels_available"].push_back(to_string(level));
    }
    result["eigen"] =
        fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION);
    result["mujoco"] = mujoco_version();
    result["hdf5"] = hdf5_version();
    result["yaml-cpp"] = LIMBER_YAML_CPP_VERSION;
    result["onetbb"] = TBB_runtime_version();
    const std::string onnx = onnx_version();
    result["onnx"] = onnx.empty() ? "missing: 'limber export --onnx' needs it; apt install "
                                    "libonnx-dev libprotobuf-dev, and build limber again"
                                  : onnx;
    result["optional"] = Json::array();
    const auto add = [&](const std::string& name, bool present, const std::string& use,
                         const std::string& how_to_get) {
      result["optional"].push_back(
          {{"name", name}, {"present", present}, {"use", use}, {"how_to_get", how_to_get}});
    };
    add("python3", python_has_modules(), "recordings and models in scripts, with h5py and numpy",
        "apt install python3-h5py python3-numpy; a python3 earlier on PATH may not see them");
    add("rsvg-convert", on_path("rsvg-convert"), "limber's SVG pictures as PNG or PDF",
        "apt install librsvg2-bin");
    for (const OptionalPeer& peer : optional_peers()) {
      add(peer.library, peer.present, "a peer in limber bench", peer.how_to_get);
    }
    add("MPI", has_ranks(), "limber campaign over ranks",
        "apt install libopenmpi-dev, then build again");
    add("OMPL", !ompl_planner_names().empty(), "planners ompl:…, to compare with",
        "apt install libompl-dev, then build again");
    return result;
  }

  static std::string describe(const Json& result) {
    std::string text;
    for (const auto& [key, value] : result.items()) {
      if (value.is_string()) {
        text += fmt::format("{:<18} {}\n", key, value.get<std::string>());
      } else if (key == "kernels_available") {
        text += fmt::format("{:<18} {}; LIMBER_CPU=… forces one\n", key, value.dump());
      } else if (key != "optional") {
        text += fmt::format("{:<18} {}\n", key, value.dump());
      }
    }
    text += "\nOptional:\n";
    for (const auto& program : result["optional"]) {
      const bool present = program["present"];
      text += fmt::format("{:<18} {}: {}{}\n", program["name"].get<std::string>(),
                          present ? "present" : "missing", program["use"].get<std::string>(),
                          present ? "" : "; " + program["how_to_get"].get<std::string>());
    }
    text.pop_back();
    return text;
  }
};

}  // namespace

std::unique_ptr<Verb> make_doctor_verb() {
  return std::make_unique<DoctorVerb>();
}

}  // namespace limber
