#include "limber/data/recording_export.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "limber/arm/names.hpp"
#include "limber/arm/pose_columns.hpp"
#include "limber/arm/space_pose.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/common/refuse_if.hpp"

namespace limber {

namespace {

constexpr double kPlateHeight_m = 0.05;   // above the floor of the motion capture
constexpr double kMarkerToSide_m = 0.02;  // from the plate's middle
constexpr double kMostRows = 1e8;         // of a log: weeks at any rate

/// Names of what is exported: what was measured, if anything was, and the set points.
std::vector<std::string> command_names(const Recording& recording) {
  return recording.setpoints_only()
             ? std::vector<std::string>{"setpoint"}
             : std::vector<std::string>{followed_name(recording.command), "setpoint"};
}

std::string command_header(const Recording& recording) {
  std::string text;
  for (const std::string& what : command_names(recording)) {
    for (int i = 0; i < recording.channel_count(); ++i) {
      text += "," + quantity_column(recording.command, what, i);
    }
  }
  return text;
}

std::string command_cells(const Episode& episode, Eigen::Index t) {
  std::string text;
  for (const FrameMatrix* values : {&episode.pressure_kpa, &episode.setpoint_kpa}) {
    if (episode.setpoints_only && values == &episode.pressure_kpa) {
      continue;
    }
    for (const float value : values->row(t)) {
      text += fmt::format(",{:.9g}", value);
    }
  }
  return text;
}

std::string command_mapping(const Recording& recording) {
  std::string text =
      recording.command.is_pressure_kpa() ? "pressures:\n  unit: kPa\n" : "commands:\n";
  const std::string& arm = recording.arm_description;
  if (!arm.empty() &&
      !read_arm_keys(arm, "arm_description", PolynomialsOf::characterisation).commands.empty()) {
    text += "  of: segments\n";
  }
  for (const std::string& what : command_names(recording)) {
    text += fmt::format("  {}: [", what == "setpoint" ? "setpoints" : "columns");
    for (int i = 0; i < recording.channel_count(); ++i) {
      text += (i > 0 ? ", " : "") + quantity_column(recording.command, what, i);
    }
    text += "]\n";
  }
  return text;
}

constexpr const char* kMappingHead =
    "# Written by limber export; docs/importing.md describes it.\n"
    "schema: limber/import/1\n"
    "time: {column: time_s, unit: s}\n";

/// The plates' columns in a table, and what a mapping says of them. Rotations that were made from
/// places are left out: an import makes them again.
class PlateColumns {
 public:
  explicit PlateColumns(const Recording& recording)
      : points_(recording.point_count),
        in_space_(recording.dimension == Dimension::space),
        keys_(pose_columns(recording.dimension)) {
    if (recording.lifted()) {
      keys_.resize(std::size_t(position_size(Dimension::space)));
    }
  }

  std::string header() const {
    std::string text;
    for (int p = 0; p < points_; ++p) {
      for (const auto& [key, unit] : keys_) {
        text += fmt::format(",{}_{}{}", key, p, unit);
      }
    }
    return text;
  }

  std::string cells(const Episode& episode, Eigen::Index t) const {
    std::string text;
    for (Eigen::Index p = 0; p < points_; ++p) {
      for (std::size_t i = 0; i < keys_.size(); ++i) {
        const float value = episode.backbone(t, pose_size(episode.dimension) * p + Eigen::Index(i));
        text += episode.was_tracked(int(t)) ? fmt::format(",{:.9g}", value) : std::string(",");
      }
    }
    return text;
  }

  std::string mapping() const {
    std::string text = in_space_ ? "  points:\n" : "  angle_unit: rad\n  points:\n";
    for (int p = 0; p < points_; ++p) {
      text += fmt::format("    - {{plate: {}", p);
      for (const auto& [key, unit] : keys_) {
        text += fmt::format(", {0}: {0}_{1}{2}", key, p, unit);
      }
      text += "}\n";
    }
    return text;
  }

 private:
  Eigen::Index points_;
  bool in_space_;
  std::vector<std::pair<std::string, std::string>> keys_;
};

fs::path write(const fs::path& path, const std::string& text) {
  write_file_atomically(path, text);
  return path;
}

/// The motion of one episode as a tracker would log it.
class MotionLog {
 public:
  MotionLog(const Recording& recording, std::size_t index, const LogExportSettings& settings)
      : recording_(recording),
        episode_(recording.episodes[index]),
        settings_(settings),
        in_space_(recording.dimension == Dimension::space),
        rate_hz_(settings.rate_hz > 0.0 ? settings.rate_hz : recording.rate_hz),
        length_s_(episode_.time_s.tail<1>()[0] - episode_.time_s[0]),
        random_(settings.seed, index) {
    for (int k = 0; k < settings.occlusions; ++k) {
      const double from = episode_.time_s[0] + random_.uniform() * length_s_;
      const int plate = int(random_.index(std::uint32_t(recording.point_count)));
      hidden_.push_back({plate, from, from + settings.occlusion_s});
    }
  }

  std::string text() {
    std::string text = head();
    refuse_if(
        !(length_s_ * rate_hz_ <= kMostRows),
        "an episode lasts {:.4g} s by its times, {:.4g} rows at {:.4g} Hz; expected at most {}. "
        "Is there a gap in it?",
        length_s_, length_s_ * rate_hz_, rate_hz_, kMostRows);
    const auto rows = Eigen::Index(length_s_ * rate_hz_ + 1e-6) + 1;
    for (Eigen::Index k = 0; k < rows; ++k) {
      throw_if_interrupted();
      const double time_s = episode_.time_s[0] + double(k) / rate_hz_;
      text += fmt::format("{},{:.6f}{}\n", k, time_s, cells(time_s));
    }
    return text;
  }

 private:
  struct Hidden {
    int plate;
    double from_s;
    double to_s;
  };

  std::string head() const {
    using Columns = std::vector<std::pair<const char*, const char*>>;
    const Columns place = {{"Position", "X"}, {"Position", "Y"}, {"Position", "Z"}};
    const Columns pose = {{"Rotation", "X"}, {"Rotation", "Y"}, {"Rotation", "Z"},
                          {"Rotation", "W"}, {"Position", "X"}, {"Position", "Y"},
                          {"Position", "Z"}};
    std::string types, names, ids, components, axes;
    const auto object = [&](const std::string& type, const std::string& name, int number,
                            const Columns& columns) {
      for (const auto& [component, axis] : columns) {
        types += "," + type;
        names += "," + name;
        ids += fmt::format(",{}", number);
        components += fmt::format(",{}", component);
        axes += fmt::format(",{}", axis);
      }
    };
    for (int p = 0; p < recording_.point_count; ++p) {
      if (settings_.markers && in_space_) {
        object("Marker", fmt::format("Arm:Plate{:02}", p), p, place);
      } else if (settings_.markers) {
        for (const char* side : {"Right", "Left"}) {
          object("Marker", fmt::format("Arm:{}{:02}", side, p), 2 * p + (side[0] == 'L'), place);
        }
      } else {
        object("Rigid Body", fmt::format("Plate{:02}", p), p, pose);
      }
    }
    return fmt::format(
        "Format Version,1.23,Take Name,{0},Capture Frame Rate,{1:.6f},Export Frame Rate,{1:.6f},"
        "Rotation Type,Quaternion,Length Units,Meters,Coordinate "
        "Space,Global\n\n,{2}\n,{3}\n,{4}\n,{5}\nFrame,Time (Seconds){6}\n",
        "limber export", rate_hz_, types, names, ids, components, axes);
  }

  bool is_hidden(int plate, double time_s) const {
    return std::any_of(hidden_.begin(), hidden_.end(), [&](const Hidden& h) {
      return h.plate == plate && time_s >= h.from_s && time_s < h.to_s;
    });
  }

  std::string cells(double time_s) {
    const double* begin = episode_.time_s.data();
    const Eigen::Index last = episode_.time_s.size() - 1;
    const auto after =
        std::clamp<Eigen::Index>(std::upper_bound(begin, begin + last + 1, time_s) - begin,
                                 std::min<Eigen::Index>(1, last), last);
    const Eigen::Index before = std::max<Eigen::Index>(after - 1, 0);
    const double step = episode_.time_s[after] - episode_.time_s[before];
    const double part = step > 0.0 ? (time_s - episode_.time_s[before]) / step : 0.0;
    constexpr double kOnFrame = 1e-9;
    const bool tracked = (part > 1.0 - kOnFrame || episode_.was_tracked(int(before))) &&
                         (part < kOnFrame || episode_.was_tracked(int(after)));
    const Eigen::RowVectorXd poses = (1.0 - part) * episode_.backbone.row(before).cast<double>() +
                                     part * episode_.backbone.row(after).cast<double>();
    std::string text;
    for (int p = 0; p < recording_.point_count; ++p) {
      // Drawn whether hidden or not, so that an occlusion changes nothing else.
      if (in_space_) {
        const SpacePose pose = noisy(poses.segment<kSpacePoseSize>(kSpacePoseSize * p).transpose());
        text += plate_cells(pose, tracked && !is_hidden(p, time_s));
        continue;
      }
      const double x = poses[kPoseSize * p] + settings_.noise_m * random_.normal();
      const double y = poses[kPoseSize * p + 1] + settings_.noise_m * random_.normal();
      const double theta = poses[kPoseSize * p + 2] + settings_.noise_rad * random_.normal();
      text += plate_cells(x, y, theta, tracked && !is_hidden(p, time_s));
    }
    return text;
  }

  SpacePose noisy(const Eigen::Matrix<double, kSpacePoseSize, 1>& numbers) {
    const auto normal = [&](double deviation) -> Eigen::Vector3d {
      const double x = random_.normal();
      const double y = random_.normal();
      return deviation * Eigen::Vector3d(x, y, random_.normal());
    };
    SpacePose pose = space_pose_of(numbers);
    pose.position_m += normal(settings_.noise_m);
    pose.rotation = pose.rotation.normalized() * rotation_of_vector(normal(settings_.noise_rad));
    return pose;
  }

  /// In space as it is, in frame B.
  std::string plate_cells(const SpacePose& pose, bool tracked) const {
    if (!tracked) {
      return settings_.markers ? ",,," : ",,,,,,,";
    }
    const Eigen::Vector4d& q = pose.rotation.coeffs();
    const Eigen::Vector3d& at = pose.position_m;
    return (settings_.markers
                ? std::string()
                : fmt::format(",{:.7f},{:.7f},{:.7f},{:.7f}", q[0], q[1], q[2], q[3])) +
           fmt::format(",{:.7f},{:.7f},{:.7f}", at[0], at[1], at[2]);
  }

  /// Motive's own axes, y up: a point (x, y) of the plane lies at (x, height, −y).
  std::string plate_cells(double x, double y, double theta, bool tracked) const {
    if (settings_.markers) {
      std::string text;
      for (const double side : {-kMarkerToSide_m, kMarkerToSide_m}) {
        text += tracked ? fmt::format(",{:.7f},{:.7f},{:.7f}", x - side * std::sin(theta),
                                      kPlateHeight_m, -(y + side * std::cos(theta)))
                        : ",,,";
      }
      return text;
    }
    return tracked ? fmt::format(",0,{:.7f},0,{:.7f},{:.7f},{:.7f},{:.7f}", std::sin(0.5 * theta),
                                 std::cos(0.5 * theta), x, kPlateHeight_m, -y)
                   : ",,,,,,,";
  }

  const Recording& recording_;
  const Episode& episode_;
  const LogExportSettings& settings_;
  bool in_space_;
  double rate_hz_;
  double length_s_;
  RandomStream random_;
  std::vector<Hidden> hidden_;
};

std::string pressure_log(const Recording& recording, const Episode& episode, double offset_s) {
  std::string text = "time_s" + command_header(recording) + "\n";
  for (Eigen::Index t = 0; t < episode.time_s.size(); ++t) {
    throw_if_interrupted();
    text += fmt::format("{:.6f}{}\n", episode.time_s[t] - offset_s, command_cells(episode, t));
  }
  return text;
}

void require_valid(const Recording& recording, const LogExportSettings& settings) {
  const auto require = [](bool holds, const char* name, double value, const std::string& allowed) {
    refuse_if(!holds, "{} {}; expected {}", name, value, allowed);
  };
  const double max_hz = std::max(LogExportSettings::kMaxRateHz, recording.rate_hz);
  require(settings.rate_hz == 0.0 ||
              (settings.rate_hz >= recording.rate_hz && settings.rate_hz <= max_hz),
          "rate_hz", settings.rate_hz,
          fmt::format("the recording's rate, {} Hz, to {} Hz", recording.rate_hz, max_hz));
  require(std::abs(settings.time_offset_s) <= LogExportSettings::kMaxOffsetS, "time_offset_s",
          settings.time_offset_s, fmt::format("at most ± {} s", LogExportSettings::kMaxOffsetS));
  require(settings.noise_m >= 0.0 && settings.noise_m < 1.0, "noise_m", settings.noise_m,
          "0 to 1 m");
  require(settings.noise_rad >= 0.0 && settings.noise_rad < 1.0, "noise_rad", settings.noise_rad,
          "0 to 1 rad");
  require(settings.occlusions >= 0 && settings.occlusions <= LogExportSettings::kMaxOcclusions,
          "occlusions", settings.occlusions,
          fmt::format("0 to {}", LogExportSettings::kMaxOcclusions));
  require(settings.occlusion_s > 0.0 && std::isfinite(settings.occlusion_s), "occlusion_s",
          settings.occlusion_s, "a time > 0 s");
}

}  // namespace

std::vector<fs::path> export_csv(const Recording& recording, const fs::path& folder) {
  std::vector<fs::path> files;
  const PlateColumns columns(recording);
  const std::string header = "time_s" + command_header(recording) + columns.header() + ",motion\n";
  for (std::size_t e = 0; e < recording.episodes.size(); ++e) {
    const Episode& episode = recording.episodes[e];
    std::string text = header;
    for (Eigen::Index t = 0; t < episode.time_s.size(); ++t) {
      throw_if_interrupted();
      text += fmt::format("{}{}", episode.time_s[t], command_cells(episode, t));
      text += columns.cells(episode, t);
      text += fmt::format(",{}\n", episode.motion_index[t]);
    }
    files.push_back(write(folder / fmt::format("episode_{:03}.csv", e), text));
  }
  files.push_back(write(folder / "mapping.yaml",
                        fmt::format("{}motion: motion\n{}backbone:\n  unit: m\n{}alignment: none\n",
                                    kMappingHead, command_mapping(recording), columns.mapping())));
  return files;
}

std::vector<fs::path> export_motive(const Recording& recording, const fs::path& folder,
                                    const LogExportSettings& settings) {
  require_valid(recording, settings);
  std::vector<fs::path> files;
  for (std::size_t e = 0; e < recording.episodes.size(); ++e) {
    files.push_back(write(folder / fmt::format("episode_{:03}_motive.csv", e),
                          MotionLog(recording, e, settings).text()));
    files.push_back(write(folder / fmt::format("episode_{:03}_pressures.csv", e),
                          pressure_log(recording, recording.episodes[e], settings.time_offset_s)));
  }
  const bool in_space = recording.dimension == Dimension::space;
  std::string points = in_space ? "" : "  up: y\n";
  points += recording.lifted() ? "  headings: tangent\n  points:\n" : "  points:\n";
  for (int p = 0; p < recording.point_count; ++p) {
    points += !settings.markers ? fmt::format("    - {{plate: {0}, body: Plate{0:02}}}\n", p)
              : in_space ? fmt::format("    - {{plate: {0}, marker: 'Arm:Plate{0:02}'}}\n", p)
                         : fmt::format(
                               "    - {{plate: {0}, right: 'Arm:Right{0:02}', left: "
                               "'Arm:Left{0:02}'}}\n",
                               p);
  }
  files.push_back(write(folder / "mapping.yaml",
                        fmt::format("{}{}backbone:\n{}{}", kMappingHead, command_mapping(recording),
                                    points, in_space ? "alignment: none\n" : "")));
  return files;
}

}  // namespace limber
