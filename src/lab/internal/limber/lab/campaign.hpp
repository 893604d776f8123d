#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "limber/common/cpu_level.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/json.hpp"

namespace limber {

/// The texts that a flag is given, which is named before each; of a switch, "true".
using FlagValues = std::vector<std::string>;
using Flags = std::vector<std::pair<std::string, FlagValues>>;
/// Null where they are not among them.
const FlagValues* values_in(const Flags& flags, const char* name);

/// A flag that differs between units. A name `arm.KEY` is a parameter of the arm file's virtual
/// arm.
struct CampaignFactor {
  struct Range {
    enum class Scale { linear, logarithmic, integer };
    double from = 0.0;
    double to = 0.0;  ///< integers: the last
    Scale scale = Scale::linear;
  };
  std::string name;
  std::vector<FlagValues> choices;  ///< a grid takes each, a random design draws one
  std::optional<Range> range;       ///< of random designs, instead of choices
};

/// One of the report's charts: figures of units over each other, by their column in the table.
struct CampaignChart {
  std::string x;
  std::string y;
};

/// docs/cluster.md, schema limber/campaign/1: runs of one verb that differ in some flags.
struct Campaign {
  std::string verb;
  std::uint64_t seed = 1;
  CpuLevel cpu = CpuLevel::baseline;
  Flags flags;                          ///< of every unit
  std::vector<CampaignFactor> factors;  ///< of a grid, the last is the fastest
  std::size_t repeat = 1;               ///< of a grid: units of each combination
  std::size_t random_count = 0;         ///< units of a random design; 0: a grid
  std::vector<CampaignChart> charts;
};

/// @throws InputError naming file, line and key: what is no campaign, has no budget, or one in
/// seconds.
Campaign read_campaign(const fs::path& path);

std::size_t unit_count(const Campaign& campaign);

/// A run of the verb. It depends on the campaign's file and the index alone.
struct CampaignUnit {
  std::size_t index = 0;
  Flags flags;      ///< those that every unit has, and `varied`
  Flags varied;     ///< with the seed, where units differ in it
  double cost = 0;  ///< estimated, in `cost_unit`
};

/// @pre index < unit_count
CampaignUnit campaign_unit(const Campaign& campaign, std::size_t index);

/// The arm file or name that it is given, or the verbs' default.
std::string arm_of(const CampaignUnit& unit);

/// "seconds of arm time": what the costs of a verb's units count.
const char* cost_unit(const std::string& verb);

/// A flag's values joined by spaces: a cell of a table.
std::string as_text(const FlagValues& values);
Json flags_to_json(const Flags& flags);

/// Text of an arm file with other parameters of its virtual arm. @throws InputError
std::string arm_with(const fs::path& arm_file, const Flags& parameters);

}  // namespace limber
