#pragma once

#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include <fmt/format.h>

#include "limber/arm/space_pose.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/logs/log_import.hpp"
#include "support/temporary_folder.hpp"

namespace limber {

inline ArmDescription space_arm() {
  ArmDescription arm;
  arm.name = "space2";
  arm.dimension = Dimension::space;
  arm.no_load = NoLoadKind::straight;
  arm.pressure_rate_limit_kpa_per_s = 100.0;
  for (const double length_m : {0.2, 0.15}) {
    Segment segment;
    segment.length_m = length_m;
    segment.width_m = 0.04;
    segment.gaps = 2;
    segment.chambers.resize(3);
    for (Chamber& chamber : segment.chambers) {
      chamber.limit_kpa = {0.0, 100.0};
    }
    arm.segments.push_back(segment);
  }
  return arm;
}

/// An arm of arcs that moves in space before a tracker that stands anywhere, and its log.
class SpaceImport : public ::testing::Test {
 protected:
  SpaceImport() {
    X_LB_.position_m = {0.3, -1.2, 2.1};
    X_LB_.rotation = rotation_of_vector<double>(Eigen::Vector3d(0.4, -1.3, 0.9));
  }

  /// Plates in frame B.
  std::vector<SpacePose> truth(double time_s) const {
    const double t = std::max(0.0, time_s - rests_s_);
    std::vector<SpacePose> plates(1);
    for (std::size_t i = 0; i < arm_.segments.size(); ++i) {
      const double phase = double(i);
      const double size = time_s < rests_s_ ? 0.0 : 1.0;
      const Eigen::Vector3d omega = size * Eigen::Vector3d(0.0, 0.8 * std::sin(1.1 * t + phase),
                                                           0.6 * std::cos(0.7 * t - phase));
      const int gaps = arm_.segments[i].gaps;
      const double stretch = 1.0 + size * 0.05 * std::sin(1.7 * t + phase);
      for (int g = 0; g < gaps; ++g) {
        plates.push_back(
            compose(plates.back(), element<double>(stretch * arm_.segments[i].length_m / gaps,
                                                   Eigen::Vector3d(omega / gaps))));
      }
    }
    return plates;
  }

  static double command(double time_s, int channel) {
    return 50.0 + 45.0 * std::sin(0.9 * time_s + channel);
  }

  /// What the tracker sees of a body: turned in its plate by `body_turn_`, with noise and signs.
  SpacePose seen(const SpacePose& plate, std::size_t point) {
    SpacePose pose = compose(X_LB_, plate);
    if (point < body_turns_.size()) {
      pose.rotation = pose.rotation * body_turns_[point];
    }
    std::normal_distribution<double> normal;
    const auto three = [&] {
      return Eigen::Vector3d(normal(random_), normal(random_), normal(random_));
    };
    pose.position_m += noise_m_ * three();
    pose.rotation =
        pose.rotation * rotation_of_vector<double>(Eigen::Vector3d(noise_rad_ * three()));
    if (sign_flips_ && random_() % 3 == 0) {
      pose.rotation.coeffs() *= -1.0;
    }
    return pose;
  }

  std::string rotation_cells(const Eigen::Quaterniond& q) const {
    if (!euler_.empty()) {
      // Eigen's own decomposition: AngleAxis(a0, order[0]) AngleAxis(a1, order[1]) …
      const Eigen::Vector3d angles =
          q.toRotationMatrix().eulerAngles(euler_[0] - 'x', euler_[1] - 'x', euler_[2] - 'x');
      const Eigen::Vector3d degrees = angles * 180.0 / M_PI;
      return fmt::format(",{:.9f},{:.9f},{:.9f}", degrees[0], degrees[1], degrees[2]);
    }
    return rotations_ ? fmt::format(",{:.9f},{:.9f},{:.9f},{:.9f}", q.x(), q.y(), q.z(), q.w())
                      : std::string();
  }

  std::string log() {
    std::string text = "t";
    for (int k = 0; k < arm_.channel_count(); ++k) {
      text += fmt::format(",p{}", k);
    }
    for (const int p : plates_) {
      text += fmt::format(",x{0},y{0},z{0}", p);
      text += !euler_.empty() ? fmt::format(",a{0},b{0},c{0}", p)
              : rotations_    ? fmt::format(",qx{0},qy{0},qz{0},qw{0}", p)
                              : std::string();
    }
    text += "\n";
    for (int row = 0; row < rows_; ++row) {
      const double t = row / rate_hz_;
      std::string cells;
      for (int k = 0; k < arm_.channel_count(); ++k) {
        cells += fmt::format(",{:.6f}", command(t, k));
      }
      const std::vector<SpacePose> plates = truth(t);
      for (std::size_t i = 0; i < plates_.size(); ++i) {
        SpacePose pose = seen(plates[std::size_t(plates_[i])], i);
        if (mistake_) {
          mistake_(row, plates_[i], pose);
        }
        cells += fmt::format(",{:.9f},{:.9f},{:.9f}", pose.position_m.x(), pose.position_m.y(),
                             pose.position_m.z()) +
                 rotation_cells(pose.rotation);
      }
      text += fmt::format("{:.4f}{}\n", t, cells);
      if (repeat_every_ > 0 && row % repeat_every_ == 0) {
        text += fmt::format("{:.4f}{}\n", t + 0.2 / rate_hz_, cells);
      }
    }
    return text;
  }

  std::string mapping(const std::string& alignment = {}) const {
    std::string text = "schema: limber/import/1\ntime: {column: t}\npressures:\n  columns: [";
    for (int k = 0; k < arm_.channel_count(); ++k) {
      text += fmt::format("{}p{}", k > 0 ? ", " : "", k);
    }
    text += "]\nbackbone:\n";
    if (!euler_.empty()) {
      text += fmt::format("  euler: {{order: {}, unit: deg}}\n", euler_);
    }
    text += "  points:\n";
    for (const int p : plates_) {
      const char* turns = !euler_.empty() ? ", euler: [a{0}, b{0}, c{0}]"
                          : rotations_    ? ", qx: qx{0}, qy: qy{0}, qz: qz{0}, qw: qw{0}"
                                          : "";
      text += fmt::format("    - {{plate: {0}, x: x{0}, y: y{0}, z: z{0}{1}}}\n", p,
                          fmt::format(fmt::runtime(turns), p));
    }
    return text + alignment;
  }

  /// Frame B as a mapping says it.
  std::string axes(bool with_position = true) const {
    const Eigen::Matrix3d R = X_LB_.rotation.toRotationMatrix();
    const auto three = [](const Eigen::Vector3d& v) {
      return fmt::format("[{:.12f}, {:.12f}, {:.12f}]", v.x(), v.y(), v.z());
    };
    return fmt::format(
        "alignment: {{{}x_axis: {}, y_axis: {}}}\n",
        with_position ? "position_m: " + three(X_LB_.position_m) + ", " : std::string(),
        three(R.col(0)), three(R.col(1)));
  }

  ImportResult import(const std::string& log_text, const std::string& mapping_text) const {
    write_file_atomically(folder_.path() / "run.csv", log_text);
    write_file_atomically(folder_.path() / "map.yaml", mapping_text);
    ImportOptions options;
    options.mapping = read_import_mapping(folder_.path() / "map.yaml", arm_);
    return import_csv({folder_.path() / "run.csv"}, options, arm_);
  }

  void expect_refusal(const std::string& log_text, const std::string& mapping_text,
                      const std::vector<std::string>& parts) const {
    try {
      import(log_text, mapping_text);
      ADD_FAILURE() << "nothing was refused; expected: " << parts.front();
    } catch (const InputError& error) {
      for (const std::string& part : parts) {
        EXPECT_THAT(error.what(), ::testing::HasSubstr(part));
      }
    }
  }

  struct Errors {
    double position_m = 0.0;
    double rotation_rad = 0.0;
  };

  /// Largest difference of a frame's poses from the truth.
  Errors errors(const Episode& episode) const {
    Errors largest;
    for (Eigen::Index t = 0; t < episode.time_s.size(); ++t) {
      const std::vector<SpacePose> plates = truth(episode.time_s[t]);
      for (std::size_t p = 0; p < plates.size(); ++p) {
        const SpacePose found =
            space_pose_of(episode.backbone.row(t)
                              .segment<kSpacePoseSize>(kSpacePoseSize * Eigen::Index(p))
                              .cast<double>());
        largest.position_m =
            std::max(largest.position_m, (found.position_m - plates[p].position_m).norm());
        largest.rotation_rad =
            std::max(largest.rotation_rad, found.rotation.angularDistance(plates[p].rotation));
      }
    }
    return largest;
  }

  static std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    return text.replace(place, from.size(), to);
  }

  TemporaryFolder folder_;
  ArmDescription arm_ = space_arm();
  SpacePose X_LB_;
  std::vector<int> plates_ = {0, 1, 2, 3, 4};
  std::vector<Eigen::Quaterniond> body_turns_;
  std::function<void(int row, int plate, SpacePose& pose)> mistake_;
  std::mt19937 random_{47};
  std::string euler_;
  bool rotations_ = true;
  bool sign_flips_ = false;
  int rows_ = 600;
  double rate_hz_ = 100.0;
  double noise_m_ = 0.0;
  double noise_rad_ = 0.0;
  double rests_s_ = 0.0;  // at the beginning, straight
  int repeat_every_ = 0;
};

}  // namespace limber
