#include "limber/lab/campaign_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/large_file.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/number_text.hpp"
#include "limber/data/recording_part.hpp"
#include "limber/plot/chart.hpp"
#include "limber/report/report_page.hpp"

namespace limber {

namespace {
using Row = std::map<std::string, std::string>;

// Half of kMaxFile: the units' own bytes are an estimate of what they take together.
constexpr std::uintmax_t kLargestJoined = kMaxFile / 2;
constexpr std::size_t kMaxElements = 16;  // of a list whose elements become columns
// What a clock says, which is another time another.
constexpr std::array<std::string_view, 6> kTimes = {
    "wall_time_s",         "first_solution_s", "first_candidate_s",
    "first_certificate_s", "time_s",           "first_solution_s_median"};

/// Numbers and truths below `value`, by their path: "network.open_loop.position_error_cm.mean".
void add_numbers(const nlohmann::json& value, const std::string& path, Row& row) {
  if (value.is_number() || value.is_boolean()) {
    row[path] = value.dump();
  }
  if (value.is_object() || (value.is_array() && value.size() <= kMaxElements)) {
    std::size_t element = 0;
    for (const auto& [key, inner] : value.items()) {
      const std::string name = value.is_object() ? key : std::to_string(element++);
      if (std::ranges::find(kTimes, name) == kTimes.end()) {
        add_numbers(inner, path.empty() ? name : path + "." + name, row);
      }
    }
  }
}

Row result_row(CampaignFolder& folder, const CampaignUnit& unit) {
  Row row;
  add_numbers(folder.result(unit).at("result"), "", row);
  return row;
}

std::string quoted(const std::string& cell) {
  if (cell.find_first_of(",\"\n") == std::string::npos) {
    return cell;
  }
  std::string text = "\"";
  for (const char c : cell) {
    text += c == '"' ? "\"\"" : std::string(1, c);
  }
  return text + "\"";
}

/// A chart's figures: of every x, how many, their mean and spread.
class ChartData {
 public:
  explicit ChartData(CampaignChart chart) : chart_(std::move(chart)) {}

  void add(const Row& row) {
    const auto x = row.find(chart_.x);
    const auto y = row.find(chart_.y);
    const std::optional<double> value =
        x != row.end() && y != row.end() ? number_in(y->second) : std::nullopt;
    if (value && std::isfinite(*value)) {
      const auto [place, is_new] = places_.try_emplace(x->second, groups_.size());
      if (is_new) {
        groups_.push_back({x->second});
      }
      Group& group = groups_[place->second];
      const double step = *value - group.mean;
      group.mean += step / ++group.count;
      group.squares += step * (*value - group.mean);
    }
  }

  bool is_empty() const { return groups_.empty(); }
  std::string title() const { return fmt::format("{} over {}", chart_.y, chart_.x); }

  std::string svg() const {
    std::vector<std::string> names;
    std::vector<double> x;
    std::vector<double> mean;
    std::vector<double> deviation;
    std::vector<Group> groups = groups_;
    const bool has_numbers =
        std::ranges::all_of(groups, [](const Group& g) { return number_in(g.x).has_value(); });
    if (has_numbers) {
      std::ranges::sort(groups, {}, [](const Group& g) { return *number_in(g.x); });
    }
    for (const Group& group : groups) {
      names.push_back(group.x);
      x.push_back(number_in(group.x).value_or(0.0));
      mean.push_back(group.mean);
      deviation.push_back(group.count > 1 ? std::sqrt(group.squares / (group.count - 1)) : 0.0);
    }
    Chart chart(title());
    chart.x_axis(chart_.x).y_axis(chart_.y).without_legend();
    if (!has_numbers) {
      chart.bars(names, chart_.y, mean, deviation);
    } else if (std::ranges::any_of(groups, [](const Group& g) { return g.count > 1; })) {
      chart.mean_band(chart_.y, x, mean, deviation);
    } else {
      chart.points(chart_.y, x, mean);
    }
    return chart.svg();
  }

 private:
  struct Group {
    std::string x;
    double count = 0.0;
    double mean = 0.0;
    double squares = 0.0;  ///< of deviations from the mean
  };

  CampaignChart chart_;
  std::vector<Group> groups_;
  std::map<std::string, std::size_t> places_;
};

/// Where the campaign's file names none: a verb's foremost figure over all that varies.
std::vector<CampaignChart> charts_of(const Campaign& campaign) {
  if (!campaign.charts.empty()) {
    return campaign.charts;
  }
  const std::map<std::string, std::string> figures = {
      {"collect", "frames"},
      {"train", "validation_position_error_cm"},
      {"evaluate", "network.open_loop.position_error_cm.mean"},
      {"experiment", "table.1.distance_to_goal_cm.mean"},
      {"calibrate", "coverage.share"}};
  return mapped<CampaignChart>(campaign.factors, [&](const CampaignFactor& factor) {
    return CampaignChart{factor.name, figures.at(campaign.verb)};
  });
}

void write_page(const Campaign& campaign, const fs::path& path, std::size_t done,
                const std::vector<ChartData>& charts) {
  ReportPage page(
      "limber campaign",
      fmt::format("{} of {} units of limber {}, CPU level {}, seed {}", done, unit_count(campaign),
                  campaign.verb, to_string(campaign.cpu), campaign.seed));
  page.heading("Charts").paragraph(
      "Each point is the mean of the units that share a value of x, the band or bar one standard "
      "deviation of them. Every figure is a column of table.csv.");
  for (const ChartData& chart : charts) {
    if (chart.is_empty()) {
      page.remark(chart.title() + ": no unit has both; see the columns of table.csv");
    } else {
      page.figure({chart.svg(), chart.title()});
    }
  }
  write_file_atomically(path, page.html());
}

/// Calls `use` for each finished unit, in their order.
template <class Use>
void for_each_done(const Campaign& campaign, CampaignFolder& folder, Use use) {
  for (std::size_t i = 0; i < unit_count(campaign); ++i) {
    const CampaignUnit unit = campaign_unit(campaign, i);
    if (folder.state(unit) == UnitState::done) {
      use(unit);
    }
  }
}

std::string joined_name(std::size_t part) {
  return fmt::format("recording_{:03}.h5", part);
}

/// Those of fewer or more units: beside the new ones they would be learnt from twice, or instead.
void remove_joined_before(const fs::path& folder, const std::vector<fs::path>& joined) {
  const auto remove = [&](const std::string& name) {
    const fs::path path = folder / name;
    return std::ranges::find(joined, path) == joined.end() && fs::remove(path);
  };
  remove("recording.h5");
  for (std::size_t part = joined.size() > 1 ? joined.size() : 0; remove(joined_name(part));
       ++part) {
  }
}

}  // namespace

std::size_t write_campaign_table(const Campaign& campaign, CampaignFolder& folder) {
  std::set<std::string> columns;
  std::size_t done = 0;
  for_each_done(campaign, folder, [&](const CampaignUnit& unit) {
    for (const auto& [name, text] : result_row(folder, unit)) {
      columns.insert(name);
    }
    ++done;
  });
  for (const auto& [name, values] : campaign_unit(campaign, 0).varied) {
    columns.erase(name);  // it has a column already
  }
  auto charts = mapped<ChartData>(charts_of(campaign),
                                  [&](const CampaignChart& chart) { return ChartData(chart); });
  make_file_atomically(folder.path() / "table.csv", [&](const fs::path& temporary) {
    std::ofstream file(temporary, std::ios::binary);
    file << "unit,folder";
    for (const auto& [name, values] : campaign_unit(campaign, 0).varied) {
      file << ',' << quoted(name);
    }
    for (const std::string& name : columns) {
      file << ',' << quoted(name);
    }
    file << '\n';
    for_each_done(campaign, folder, [&](const CampaignUnit& unit) {
      Row row = result_row(folder, unit);
      file << unit.index << ','
           << quoted(folder.unit_folder(unit.index).lexically_relative(folder.path()).string());
      for (const auto& [name, values] : unit.varied) {
        file << ',' << quoted(as_text(values));
      }
      for (const std::string& name : columns) {
        file << ',' << row[name];
      }
      file << '\n';
      for (const auto& [name, values] : unit.varied) {
        row[name] = as_text(values);
      }
      std::ranges::for_each(charts, [&](ChartData& chart) { chart.add(row); });
    });
    file.close();
    if (!file) {
      throw SystemFault(fmt::format("{}/table.csv: can't be written", folder.path().string()));
    }
    sync_file(temporary);
  });
  write_page(campaign, folder.path() / "report.html", done, charts);
  return done;
}

std::vector<fs::path> join_campaign_recordings(const Campaign& campaign, CampaignFolder& folder) {
  std::vector<std::vector<fs::path>> files(1);
  std::uintmax_t bytes = 0;
  for_each_done(campaign, folder, [&](const CampaignUnit& unit) {
    const fs::path file = folder.unit_folder(unit.index) / kUnitRecording;
    const std::uintmax_t size = fs::file_size(file);
    if (bytes + size > kLargestJoined && !files.back().empty()) {
      files.emplace_back();
      bytes = 0;
    }
    files.back().push_back(file);
    bytes += size;
  });
  std::vector<fs::path> joined;
  for (std::size_t i = 0; i < files.size() && !files[i].empty(); ++i) {
    joined.push_back(folder.path() /
                     (files.size() == 1 ? std::string("recording.h5") : joined_name(i)));
    join_recordings(joined.back(), files[i], campaign.seed);
  }
  remove_joined_before(folder.path(), joined);
  return joined;
}

}  // namespace limber
