#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/number_text.hpp"
#include "limber/common/utf8.hpp"
#include "limber/common/yaml_reader.hpp"
#include "limber/lab/campaign.hpp"

namespace limber {

namespace {

constexpr const char* kSchema = "limber/campaign/1";
constexpr std::array kVerbs = {"collect", "train", "evaluate", "experiment", "calibrate"};
constexpr int kMaxUnits = 1'000'000;  // folders of at most 1000 entries, two levels deep

/// What the campaign itself decides for its units, or what would make them depend on a clock.
struct KeptFlag {
  const char* name;
  const char* why;
};
constexpr KeptFlag kKeptFlags[] = {
    {"out", "each unit has files of its own"},
    {"folder", "each unit has files of its own"},
    {"plots", "each unit has files of its own"},
    {"predictions", "each unit has files of its own"},
    {"join", "--collect joins units"},
    {"json", "the campaign reads what units print"},
    {"quiet", "the campaign keeps what units print"},
    {"force", "the campaign starts over what was cut short"},
    {"resume", "the campaign starts over what was cut short"},
    {"jobs", "give --jobs to limber campaign"},
    {"dry-run", "give --dry-run to limber campaign"},
    {"driver", "units run on the virtual arm"},
    {"driver-log", "units run on the virtual arm"},
    {"help", "limber VERB --help shows it"},
    {"build-forest", "units would write one file; grow it first, limber plan --build-forest"},
    {"time-limit-s", "budgets are iterations, queries or epochs, so that units can be repeated"},
};

FlagValues values_of(const YamlReader& value) {
  FlagValues values;
  if (value.is_sequence()) {
    for (const YamlReader& element : value.elements()) {
      values.push_back(element.text());
    }
    value.refuse_if(values.empty(), "an empty list found; expected a value, or a list of values");
  } else {
    values.push_back(value.text());
  }
  return values;
}

void require_unit_flag(const YamlReader& value, const std::string& name) {
  value.refuse_if(
      name.empty() || name.front() == '-' ||
          name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_.-") != std::string::npos,
      "expected the name of a flag without its dashes, or arm.PARAMETER");
  for (const KeptFlag& kept : kKeptFlags) {
    value.refuse_if(name == kept.name, "not a flag of a unit: {}", kept.why);
  }
}

/// `files: FOLDER/*.EXTENSION`, in the order of their names.
std::vector<FlagValues> files_of(const YamlReader& value) {
  const fs::path pattern = value.text();
  const std::string name = pattern.filename().string();
  value.refuse_if(name.size() < 3 || name.compare(0, 2, "*.") != 0,
                  "'{}' found; expected FOLDER/*.EXTENSION", pattern.string());
  std::vector<FlagValues> files;
  std::error_code error;
  const fs::path folder = pattern.has_parent_path() ? pattern.parent_path() : fs::path(".");
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (entry.is_regular_file() && entry.path().extension() == name.substr(1)) {
      if (!is_utf8(entry.path().string())) {
        value.refuse(fmt::format("{}: the name is not UTF-8; rename the file",
                                 with_other_bytes_escaped(entry.path().string())));
      }
      files.push_back({entry.path().string()});
    }
  }
  value.refuse_if(files.empty(), "'{}': no such files", pattern.string());
  std::ranges::sort(files);
  return files;
}

CampaignFactor::Range range_of(const YamlReader& value) {
  using Scale = CampaignFactor::Range::Scale;
  value.refuse_unknown_keys({"from", "to", "scale"});
  CampaignFactor::Range range;
  range.from = value.at("from").number("a number");
  range.to = value.at("to").number("a number", range.from);
  const std::string scale = value.has("scale") ? value.at("scale").text() : "linear";
  if (scale == "logarithmic") {
    range.scale = Scale::logarithmic;
    value.at("from").positive("a number");
  } else if (scale == "integer") {
    range.scale = Scale::integer;
  } else if (scale != "linear") {
    value.at("scale").refuse(
        fmt::format("'{}' found; expected linear, logarithmic or integer", scale));
  }
  return range;
}

/// Units of a grid that say the same would be the same, to the byte.
void refuse_equal(const YamlReader& value, std::vector<FlagValues> choices) {
  std::ranges::sort(choices);
  if (const auto twice = std::ranges::adjacent_find(choices); twice != choices.end()) {
    value.refuse(fmt::format("'{}' found twice; units would be the same", as_text(*twice)));
  }
}

CampaignFactor factor_of(const YamlReader& value, const std::string& name, bool is_random) {
  require_unit_flag(value, name);
  CampaignFactor factor{name, {}, std::nullopt};
  if (value.is_sequence()) {
    for (const YamlReader& element : value.elements()) {
      factor.choices.push_back(values_of(element));
    }
    if (!is_random) {
      refuse_equal(value, factor.choices);
    }
  } else if (value.is_mapping() && value.has("files")) {
    value.refuse_unknown_keys({"files"});
    factor.choices = files_of(value.at("files"));
  } else if (value.is_mapping() && is_random) {
    factor.range = range_of(value);
  }
  if (factor.choices.empty() && !factor.range) {
    value.refuse(fmt::format("expected a list of values or {{files: FOLDER/*.EXTENSION}}{}",
                             is_random ? " or {from: LOW, to: HIGH}" : ""));
  }
  return factor;
}

void read_design(const YamlReader& root, Campaign& campaign) {
  const bool is_random = root.has("random");
  if (is_random && (root.has("grid") || root.has("repeat"))) {
    root.at("random").refuse("found beside grid or repeat; expected one design");
  }
  if (is_random) {
    const YamlReader random = root.at("random");
    campaign.random_count =
        std::size_t(random.at("count").integer("a number of units", 1, kMaxUnits));
  }
  if (root.has("repeat")) {
    campaign.repeat = std::size_t(root.at("repeat").integer("a number of units", 1, kMaxUnits));
  }
  const char* design = is_random ? "random" : "grid";
  if (root.has(design)) {
    for (const std::string& name : root.at(design).keys()) {
      if (!(is_random && name == "count")) {
        campaign.factors.push_back(factor_of(root.at(design).at(name), name, is_random));
      }
    }
  }
  double units = double(campaign.repeat);
  for (const CampaignFactor& factor : campaign.factors) {
    units *= double(std::max<std::size_t>(factor.choices.size(), 1));
  }
  root.refuse_if(!is_random && units > kMaxUnits, "{:.0f} units; expected at most {}", units,
                 kMaxUnits);
}

CpuLevel cpu_of(const YamlReader& value) {
  for (const CpuLevel level : {CpuLevel::baseline, CpuLevel::avx2, CpuLevel::avx512}) {
    if (value.text() == to_string(level)) {
      return level;
    }
  }
  value.refuse(fmt::format("'{}' found; expected baseline, avx2 or avx512", value.text()));
}

/// Whether units have the seed that the file gives them.
bool names_seed(const Campaign& campaign) {
  return values_in(campaign.flags, "seed") != nullptr ||
         std::ranges::find(campaign.factors, "seed", &CampaignFactor::name) !=
             campaign.factors.end();
}

bool asks_closed_loop(const std::string& name, const FlagValues& values) {
  const char* asking = name == "replan" ? "true" : name == "controller" ? "replan" : nullptr;
  return asking != nullptr && std::ranges::find(values, asking) != values.end();
}

/// Whether one unit or another executes plans in closed loop.
bool asks_closed_loop(const Campaign& campaign) {
  return std::ranges::any_of(
             campaign.flags,
             [](const auto& flag) { return asks_closed_loop(flag.first, flag.second); }) ||
         std::ranges::any_of(campaign.factors, [](const CampaignFactor& factor) {
           return std::ranges::any_of(factor.choices, [&](const FlagValues& values) {
             return asks_closed_loop(factor.name, values);
           });
         });
}

/// Units whose length nothing but a clock or the data would decide are refused.
void require_budget(const YamlReader& root, const Campaign& campaign) {
  const CampaignUnit first = campaign_unit(campaign, 0);
  const auto has = [&](const char* name) {
    return std::ranges::any_of(first.flags, [&](const auto& flag) { return flag.first == name; });
  };
  root.refuse_if(campaign.verb == "experiment" && !has("max-iterations") && !has("max-queries"),
                 "no budget: expected the flag max-iterations or max-queries");
  root.refuse_if(
      campaign.verb == "experiment" && asks_closed_loop(campaign) && !has("motion-queries"),
      "closed loop without the flag motion-queries: expected a number, as a clock would choose "
      "it, on each machine another");
  root.refuse_if(campaign.verb == "train" && !has("epochs"), "no budget: expected the flag epochs");
}

}  // namespace

Campaign read_campaign(const fs::path& path) {
  const YamlReader root = YamlReader::from_file(path);
  root.require_schema(kSchema);
  root.refuse_unknown_keys(
      {"schema", "verb", "seed", "cpu", "flags", "grid", "repeat", "random", "charts"});
  Campaign campaign;
  campaign.verb = root.at("verb").text();
  if (std::ranges::find(kVerbs, campaign.verb) == kVerbs.end()) {
    root.at("verb").refuse(
        fmt::format("'{}' found; expected one of {}", campaign.verb, fmt::join(kVerbs, ", ")));
  }
  if (root.has("seed")) {
    const auto seed = number_in<std::uint64_t>(root.at("seed").text());
    if (!seed) {
      root.at("seed").refuse(
          fmt::format("{} found; expected a whole number, at least 0", root.at("seed").found()));
    }
    campaign.seed = *seed;
  }
  if (root.has("cpu")) {
    campaign.cpu = cpu_of(root.at("cpu"));
  }
  if (root.has("flags")) {
    for (const std::string& name : root.at("flags").keys()) {
      const YamlReader value = root.at("flags").at(name);
      require_unit_flag(value, name);
      campaign.flags.emplace_back(name, values_of(value));
    }
  }
  read_design(root, campaign);
  if (campaign.repeat > 1 && names_seed(campaign)) {
    root.at("repeat").refuse("found beside the flag seed, with which each repetition is the same");
  }
  for (const CampaignFactor& factor : campaign.factors) {
    if (values_in(campaign.flags, factor.name.c_str()) != nullptr) {
      root.at("flags").at(factor.name).refuse("varies between units too; expected one of the two");
    }
  }
  if (root.has("charts")) {
    for (const YamlReader& chart : root.at("charts").elements()) {
      chart.refuse_unknown_keys({"x", "y"});
      campaign.charts.push_back({chart.at("x").text(), chart.at("y").text()});
    }
  }
  require_budget(root, campaign);
  return campaign;
}

}  // namespace limber
