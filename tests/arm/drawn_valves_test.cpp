// Laws of valves drawn by a number.
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "arm/random_valves.hpp"
#include "limber/arm/valve_model.hpp"
#include "limber/common/yaml_reader.hpp"
#include "support/drawn_arm.hpp"
#include "support/property.hpp"

namespace limber {
namespace {

constexpr float kRoundingKpa = 1e-4F;  // float32 over ± 150

struct Drawn {
  RandomStream random;
  ArmDescription arm;
  ValveParameters valves;

  explicit Drawn(std::uint64_t number)
      : random(number, 0),
        arm(drawn::chance(random, 0.5) ? drawn::arm(number, random)
                                       : drawn::space_arm(number, random)) {
    valves.has_sides =
        arm.is_spatial() ? drawn::chance(random, 0.5) : arm.command.is_pressure_kpa();
    for (int i = 0; i < arm.channel_count(); ++i) {
      valves.segments.push_back(random_valves(random));
    }
  }

  ValveErrors errors() {
    return {random.uniform(0.0, 1.0), random.uniform(1.0, 3.0), random.uniform(3.0, 90.0),
            1 + std::int64_t(random.index(1'000'000))};
  }
};

bool are_equal(const ValveErrors& a, const ValveErrors& b) {
  return a.mean_kpa == b.mean_kpa && a.p95_kpa == b.p95_kpa && a.max_kpa == b.max_kpa &&
         a.frames == b.frames;
}

TEST(DrawnValves, FilesComeBackExactly) {
  expect_law("valves that are written and read are the valves", [] {
    Drawn drawn(drawn_number());
    IdentifiedValves written{drawn.valves, {}};
    written.findings.source = drawn_text();
    if (drawn::chance(drawn.random, 0.5)) {
      written.findings.held_back = drawn.errors();
      written.findings.from_setpoints = drawn.errors();
    }
    written.findings.reason = drawn_text();
    written.findings.warnings = {drawn_text(), drawn_text()};
    for (const std::string& text : {valves_to_yaml(written), to_json(written).dump()}) {
      const IdentifiedValves read = read_valves(YamlReader::from_text(text, "again.yaml"));
      RC_ASSERT(read.parameters == written.parameters);
      RC_ASSERT(read.parameters.hash() == written.parameters.hash());
      RC_ASSERT(read.findings.source == written.findings.source);
      RC_ASSERT(read.findings.reason == written.findings.reason);
      RC_ASSERT(read.findings.warnings == written.findings.warnings);
      RC_ASSERT(are_equal(read.findings.held_back, written.findings.held_back));
      RC_ASSERT(are_equal(read.findings.from_setpoints, written.findings.from_setpoints));
      RC_ASSERT(valves_to_yaml(read) == valves_to_yaml(written));
    }
  });
}

// Also in space, where every chamber has valves of its own.
TEST(DrawnValves, PressuresStayBetweenWhatTheyWereAndWhatIsAskedFor) {
  expect_law("no valve overshoots", [] {
    Drawn drawn(drawn_number());
    const ValveModel model(drawn.arm, drawn.valves);
    Eigen::VectorXf state = model.settled_state(drawn::pressures(drawn.arm, drawn.random));
    const int n = drawn.arm.channel_count();
    Pressures low = state.head(n);
    Pressures high = low;
    for (int k = 0; k < 30; ++k) {
      const Pressures setpoint = drawn::pressures(drawn.arm, drawn.random);
      low = low.cwiseMin(setpoint);
      high = high.cwiseMax(setpoint);
      model.step(setpoint, state);
      RC_ASSERT((state.head(n).array() >= low.array() - kRoundingKpa).all());
      RC_ASSERT((state.head(n).array() <= high.array() + kRoundingKpa).all());
    }
  });
}

}  // namespace
}  // namespace limber
