#include "family_json.hpp"

#include <vector>

#include "limber/common/json.hpp"
#include "limber/network/arm_family.hpp"
#include "limber/network/physical_traits.hpp"

namespace limber {

namespace {

/// What e tells of arms: its value by e, the range over the arms that the family learnt from, and
/// how e changes along with it.
Json traits_to_json(const ArmFamily& family) {
  Json list = Json::array();
  for (const PhysicalTrait& trait : family.traits) {
    const TraitWords words = words_of_trait(trait.name);
    const auto in_words = [&](float value) { return words.per_si * double(value); };
    const Eigen::VectorXf told =
        (trait.slope.transpose() * family.arms).transpose().array() + trait.middle;
    const Eigen::VectorXf along = trait.along / float(words.per_si);
    const Eigen::VectorXf slope = float(words.per_si) * trait.slope;
    list.push_back({{"name", trait.name},
                    {"text", words.text},
                    {"unit", words.unit},
                    {"of_arm_file", in_words(trait.of_file)},
                    {"low", in_words(told.minCoeff())},
                    {"high", in_words(told.maxCoeff())},
                    {"middle", in_words(trait.middle)},
                    {"slope", std::vector<float>(slope.begin(), slope.end())},
                    {"along", std::vector<float>(along.begin(), along.end())}});
  }
  return list;
}

}  // namespace

Json family_to_json(const CompensationModel& model) {
  const Eigen::Index size = model.family ? model.family->size() : 0;
  const Eigen::VectorXf e =
      model.member_of_family ? model.member_of_family->e : Eigen::VectorXf::Zero(size);
  return {{"is_family", is_family(model)},
          {"e", std::vector<float>(e.begin(), e.end())},
          {"traits", model.family ? traits_to_json(*model.family) : Json::array()}};
}

}  // namespace limber
