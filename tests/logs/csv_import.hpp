#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/logs/log_import.hpp"
#include "support/log_truth.hpp"
#include "support/sample_arm.hpp"
#include "support/temporary_folder.hpp"

namespace limber {

/// A folder with a generic CSV of a three-segment arm and its mapping, both open to changes.
class CsvImport : public ::testing::Test {
 protected:
  explicit CsvImport(int segments = 3) : truth_(sample_arm(segments)) {
    rows_ = 600;
    rate_hz_ = 100.0;
    for (int p = 0; p < truth_.arm().point_count(); ++p) {
      plates_.push_back(p);
    }
  }

  std::string pose_cells(double time_s) const {
    const BackboneD b = truth_.backbone(time_s);
    const double c = std::cos(turn_rad_);
    const double s = std::sin(turn_rad_);
    std::string text;
    for (const int p : plates_) {
      text +=
          fmt::format(",{:.8f},{:.8f}", length_scale_ * (shift_m_[0] + c * b(p, 0) - s * b(p, 1)),
                      length_scale_ * (shift_m_[1] + s * b(p, 0) + c * b(p, 1)));
      if (headings_) {
        // As trackers give it: wrapped.
        text += fmt::format(
            ",{:.8f}",
            std::remainder(b(p, 2) + turn_rad_ + heading_off_rad_ +
                               (heading_mistake_rad_ ? heading_mistake_rad_(time_s, p) : 0.0),
                           2.0 * M_PI));
      }
    }
    return text;
  }

  std::string header() const {
    std::string text = "time_s" + truth_.pressure_names();
    for (const int p : plates_) {
      text += fmt::format(",x{0},y{0}{1}", p, headings_ ? fmt::format(",theta{}", p) : "");
    }
    return text;
  }

  std::string log() const {
    return LogTruth::table(header(), rows_, rate_hz_, [&](double t) {
      return truth_.pressure_cells(t, pressure_scale_) + pose_cells(t);
    });
  }

  /// The same with a column of each side: r1, l1, r2, …
  std::string log_of_sides() const {
    std::string names = "time_s";
    for (int i = 1; i <= truth_.arm().segment_count(); ++i) {
      names += fmt::format(",r{0},l{0}", i);
    }
    names += header().substr(header().find(",x0"));
    return LogTruth::table(names, rows_, rate_hz_, [&](double t) {
      std::string text;
      for (const double p : truth_.pressures(t)) {
        text += fmt::format(",{:.6f},{:.6f}", std::max(p, 0.0), std::max(-p, 0.0));
      }
      return text + pose_cells(t);
    });
  }

  std::string mapping() const {
    std::string text = "schema: limber/import/1\ntime: {column: time_s}\npressures:\n  columns: [";
    for (int i = 1; i <= truth_.arm().segment_count(); ++i) {
      text += fmt::format("{}pressure_{}_kpa", i > 1 ? ", " : "", i);
    }
    text += "]\nbackbone:\n  points:\n";
    for (const int p : plates_) {
      text += fmt::format("    - {{plate: {0}, x: x{0}, y: y{0}{1}}}\n", p,
                          headings_ ? fmt::format(", theta: theta{}", p) : "");
    }
    return text;
  }

  ImportResult import(const std::string& log_text, const std::string& mapping_text) const {
    write_file_atomically(folder_.path() / "run.csv", log_text);
    write_file_atomically(folder_.path() / "map.yaml", mapping_text);
    ImportOptions options;
    options.mapping = read_import_mapping(folder_.path() / "map.yaml", truth_.arm());
    return import_csv({folder_.path() / "run.csv"}, options, truth_.arm());
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

  /// Largest difference of a frame's numbers from the truth: {position, heading}.
  std::pair<double, double> errors(const Episode& episode) const {
    double position = 0.0;
    double heading = 0.0;
    for (Eigen::Index t = 0; t < episode.time_s.size(); ++t) {
      const BackboneD b = truth_.backbone(episode.time_s[t]);
      for (Eigen::Index p = 0; p < b.rows(); ++p) {
        const auto pose = episode.backbone.row(t).segment<3>(3 * p).cast<double>();
        position = std::max(position, (pose.head<2>() - b.row(p).head<2>()).norm());
        heading = std::max(heading, std::abs(pose[2] - b(p, 2)));
      }
    }
    return {position, heading};
  }

  static std::string without_line(std::string text, const std::string& beginning) {
    const std::size_t begin = text.find("\n" + beginning) + 1;
    return text.erase(begin, text.find('\n', begin) + 1 - begin);
  }

  static std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    return text.replace(place, from.size(), to);
  }

  static const ImportNote* note(const ImportResult& result, const std::string& part) {
    for (const ImportNote& found : result.report.runs.front().notes) {
      if (found.what.find(part) != std::string::npos) {
        return &found;
      }
    }
    return nullptr;
  }

  TemporaryFolder folder_;
  LogTruth truth_;
  int rows_;
  double rate_hz_;
  std::vector<int> plates_;
  bool headings_ = true;
  double length_scale_ = 1.0;
  double pressure_scale_ = 1.0;
  double turn_rad_ = 0.0;
  double heading_off_rad_ = 0.0;
  std::function<double(double time_s, int plate)> heading_mistake_rad_;
  Eigen::Vector2d shift_m_ = Eigen::Vector2d::Zero();
};

/// The log with the cells of one column emptied in rows [from, to), or with `written` in them.
inline std::string hidden(const std::string& text, std::size_t column, int from, int to,
                          const std::string& written = {}) {
  std::string result;
  std::size_t begin = 0;
  for (int row = -1; begin < text.size(); ++row) {
    const std::size_t end = text.find('\n', begin);
    std::string line = text.substr(begin, end - begin);
    if (row >= from && row < to) {
      std::size_t place = 0;
      for (std::size_t c = 0; c < column; ++c) {
        place = line.find(',', place) + 1;
      }
      line.replace(place, line.find(',', place) - place, written);
    }
    result += line + "\n";
    begin = end + 1;
  }
  return result;
}

}  // namespace limber
