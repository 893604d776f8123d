#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "limber/arm/arm_description.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/json.hpp"
#include "limber/common/number_text.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/lab/campaign.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"

namespace limber {

namespace {

constexpr std::uint64_t kDesignStream = 0x63616d70ULL << 32U;  // apart from all others of a seed
constexpr std::uint64_t kSeedStream = 0x63736565ULL << 32U;
constexpr int kSeedBits = 52;  // so many that units share none, and JSON's numbers hold it
constexpr const char* kSeed = "seed";

std::string unit_seed(std::uint64_t seed, std::uint64_t number) {
  RandomStream random(seed, kSeedStream + number);
  return fmt::format("{:.0f}", std::floor(std::ldexp(random.uniform(), kSeedBits)));
}

std::string drawn(const CampaignFactor::Range& range, RandomStream& random) {
  using Scale = CampaignFactor::Range::Scale;
  switch (range.scale) {
    case Scale::logarithmic:
      return fmt::format("{}", std::exp(random.uniform(std::log(range.from), std::log(range.to))));
    case Scale::integer:
      return fmt::format("{:.0f}", std::floor(random.uniform(range.from, range.to + 1.0)));
    case Scale::linear:
      break;
  }
  return fmt::format("{}", random.uniform(range.from, range.to));
}

/// Every combination, the last factor fastest, and each of them `repeat` times.
Flags grid_flags(const Campaign& campaign, std::size_t index) {
  Flags varied(campaign.factors.size());
  index /= campaign.repeat;
  for (std::size_t k = campaign.factors.size(); k-- > 0;) {
    const CampaignFactor& factor = campaign.factors[k];
    varied[k] = {factor.name, factor.choices[index % factor.choices.size()]};
    index /= factor.choices.size();
  }
  return varied;
}

Flags random_flags(const Campaign& campaign, std::size_t index) {
  RandomStream random(campaign.seed, kDesignStream + index);
  Flags varied;
  for (const CampaignFactor& factor : campaign.factors) {
    const auto choices = std::uint32_t(factor.choices.size());
    varied.emplace_back(factor.name, factor.range ? FlagValues{drawn(*factor.range, random)}
                                                  : factor.choices[random.index(choices)]);
  }
  return varied;
}

double flag_number(const Flags& flags, const char* name, double otherwise) {
  const FlagValues* values = values_in(flags, name);
  return values != nullptr ? number_in(values->front()).value_or(otherwise) : otherwise;
}

double megabytes(const Flags& flags, const char* name) {
  double bytes = 0.0;
  if (const FlagValues* files = values_in(flags, name)) {
    for (const std::string& file : *files) {
      std::error_code error;
      const auto size = fs::file_size(file, error);
      bytes += error ? 0.0 : double(size);
    }
  }
  constexpr double kMegabyte = 1e6;
  return std::max(bytes / kMegabyte, 1e-3);
}

/// About the multiplications of a network's inner layers, in those of the default's.
double network_size(const Flags& flags) {
  constexpr double kUnits = 100.0;  // of each layer, and about those of input and output
  double before = kUnits;
  double weights = 0.0;
  const FlagValues usual(3, "100");
  const FlagValues* hidden = values_in(flags, "hidden");
  for (const std::string& layer : hidden != nullptr ? *hidden : usual) {
    const double units = number_in(layer).value_or(kUnits);
    weights += before * units;
    before = units;
  }
  return (weights + before * kUnits) / (4.0 * kUnits * kUnits);
}

double cost(const std::string& verb, const Flags& flags) {
  if (verb == "collect") {
    constexpr double kAllTransitions = 729.0;
    return std::max(flag_number(flags, "episodes", 1.0), 1.0) *
           flag_number(flags, "count", kAllTransitions) * flag_number(flags, "hold-s", 3.0);
  }
  if (verb == "train") {
    return flag_number(flags, "epochs", 1.0) * network_size(flags) *
           flag_number(flags, "ensemble", 1.0) * megabytes(flags, "data");
  }
  if (verb == "experiment") {
    return flag_number(flags, "trials", 20.0) *
           flag_number(flags, "max-queries", flag_number(flags, "max-iterations", 1.0));
  }
  if (verb == "calibrate") {
    return flag_number(flags, "max-queries", 20'000.0) * flag_number(flags, "check", 1000.0);
  }
  return megabytes(flags, "data");
}

}  // namespace

const FlagValues* values_in(const Flags& flags, const char* name) {
  const auto found = std::ranges::find(flags, name, &Flags::value_type::first);
  return found == flags.end() ? nullptr : &found->second;
}

std::size_t unit_count(const Campaign& campaign) {
  if (campaign.random_count > 0) {
    return campaign.random_count;
  }
  std::size_t count = campaign.repeat;
  for (const CampaignFactor& factor : campaign.factors) {
    count *= factor.choices.size();
  }
  return count;
}

CampaignUnit campaign_unit(const Campaign& campaign, std::size_t index) {
  const bool is_random = campaign.random_count > 0;
  CampaignUnit unit;
  unit.index = index;
  unit.varied = is_random ? random_flags(campaign, index) : grid_flags(campaign, index);
  unit.flags = campaign.flags;
  if (values_in(unit.flags, kSeed) == nullptr && values_in(unit.varied, kSeed) == nullptr) {
    const std::size_t number = is_random ? index : index % campaign.repeat;
    const bool differs = is_random || campaign.repeat > 1;
    const std::string seed =
        differs ? unit_seed(campaign.seed, number) : std::to_string(campaign.seed);
    (differs ? unit.varied : unit.flags).emplace_back(kSeed, FlagValues{seed});
  }
  unit.flags.insert(unit.flags.end(), unit.varied.begin(), unit.varied.end());
  unit.cost = cost(campaign.verb, unit.flags);
  return unit;
}

std::string arm_of(const CampaignUnit& unit) {
  const FlagValues* arm = values_in(unit.flags, "arm");
  return arm != nullptr ? arm->front() : "three_segment";
}

const char* cost_unit(const std::string& verb) {
  if (verb == "collect") {
    return "seconds of arm time";
  }
  if (verb == "train") {
    return "epochs of the default network on a megabyte";
  }
  return verb == "evaluate" ? "megabytes of recording" : "queries";
}

std::string as_text(const FlagValues& values) {
  return fmt::format("{}", fmt::join(values, " "));
}

Json flags_to_json(const Flags& flags) {
  Json json = Json::object();
  for (const auto& [name, values] : flags) {
    json[name] = as_text(values);
  }
  return json;
}

std::string arm_with(const fs::path& arm_file, const Flags& parameters) {
  ArmDescription arm = load_arm(arm_file, PolynomialsOf::characterisation);
  const std::string where = fmt::format("arm.PARAMETER of {}", arm_file.string());
  std::vector<std::string> texts;
  for (const auto& [name, values] : parameters) {
    texts.push_back(values.size() == 1 ? fmt::format("{}: {}", name, values.front())
                                       : fmt::format("{}: [{}]", name, fmt::join(values, ", ")));
  }
  change_virtual_arm(arm, [&](VirtualArmParameters& physics) {
    physics = with_differences(physics, fmt::format("{{{}}}", fmt::join(texts, ", ")),
                               arm.dimension, where);
  });
  return virtual_arm_to_yaml(arm);
}

}  // namespace limber
