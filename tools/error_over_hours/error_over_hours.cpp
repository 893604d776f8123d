// error_over_hours FIGURES.json OUT.svg: error of the tip over hours of arm time, from the rows of
// tools/accuracy_figures.py that learnt from the three-segment arm with the best preset.
#include <cstdio>
#include <exception>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/common/atomic_file.hpp"
#include "limber/plot/chart.hpp"

namespace limber {
namespace {

struct Mean {
  double sum = 0.0;
  int count = 0;
};

/// Hours of arm time → mean over the runs with that many.
using Curve = std::map<double, Mean>;

std::string draw(const nlohmann::json& figures) {
  const std::map<std::string, std::string> kinds = {{"open_loop", "open loop, 300 s"},
                                                    {"per_motion", "per motion, 3 s"},
                                                    {"window_32", "32 frames, 1.6 s"},
                                                    {"one_step", "one step, 0.05 s"}};
  Chart chart("Error of the tip over hours of arm time");
  chart.x_axis("hours of arm time learnt from").y_axis("position error [cm]").logarithmic_y();
  for (const char* kind : {"open_loop", "per_motion", "window_32", "one_step"}) {
    Curve curve;
    for (const nlohmann::json& row : figures.at("rows")) {
      if (row.at("curve").get<bool>()) {
        Mean& mean = curve[row.at("hours")];
        mean.sum += row.at("network").at(kind).at("position_error_cm").at("mean").get<double>();
        ++mean.count;
      }
    }
    std::vector<double> hours;
    std::vector<double> error_cm;
    for (const auto& [at, mean] : curve) {
      hours.push_back(at);
      error_cm.push_back(mean.sum / mean.count);
    }
    chart.line(kinds.at(kind), hours, error_cm);
  }
  return ChartGrid(1).add(chart).svg();
}

int run(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: error_over_hours FIGURES.json OUT.svg\n");
    return 2;
  }
  write_file_atomically(argv[2], draw(nlohmann::json::parse(read_file(argv[1]))));
  return 0;
}

}  // namespace
}  // namespace limber

int main(int argc, char** argv) {
  try {
    return limber::run(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return 3;
  }
}
