#include "src/sim/mujoco_chain.hpp"

#include <array>
#include <cstring>
#include <memory>
#include <vector>

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include "limber/common/random_stream.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"
#include "support/sample_arm.hpp"

namespace limber {
namespace {

constexpr double kRounding = 1e-12;

/// MuJoCo's own kinematics of the same chain, as oracle.
struct Oracle {
  explicit Oracle(const ArmDescription& arm) {
    const std::string xml = chain_mjcf(arm, virtual_arm_parameters(arm), 1e-3);
    const auto files = std::make_unique<mjVFS>();
    mj_defaultVFS(files.get());
    mj_makeEmptyFileVFS(files.get(), "arm.xml", static_cast<int>(xml.size()));
    std::memcpy(files->filedata[0], xml.data(), xml.size());
    std::array<char, 1000> message{};
    model = mj_loadXML("arm.xml", files.get(), message.data(), static_cast<int>(message.size()));
    mj_deleteVFS(files.get());
    EXPECT_NE(model, nullptr) << message.data();
    data = mj_makeData(model);
  }
  Oracle(const Oracle&) = delete;
  Oracle& operator=(const Oracle&) = delete;
  ~Oracle() {
    mj_deleteData(data);
    mj_deleteModel(model);
  }
  int body(std::size_t plate) const {
    return mj_name2id(model, mjOBJ_BODY, ("plate_" + std::to_string(plate)).c_str());
  }
  mjModel* model = nullptr;
  mjData* data = nullptr;
};

class PlaneKinematicsOf : public testing::TestWithParam<int> {
 protected:
  PlaneKinematicsOf()
      : arm(make_arm()),
        oracle(arm),
        kinematics(chain_links(arm, virtual_arm_parameters(arm)),
                   virtual_arm_parameters(arm).base_misalignment_rad) {
    RandomStream random(5, 0);
    for (int joint = 0; joint < oracle.model->nv; ++joint) {
      oracle.data->qpos[joint] = joint % 2 == 0 ? 0.01 * random.normal() : 0.4 * random.normal();
      oracle.data->qvel[joint] = random.normal();
    }
    mj_forward(oracle.model, oracle.data);
    kinematics.update(oracle.data->qpos, oracle.data->qvel);
  }
  static ArmDescription make_arm() {
    ArmDescription arm = sample_arm(GetParam());
    change_virtual_arm(arm, [&](VirtualArmParameters& p) { p.base_misalignment_rad = 0.2; });
    return arm;
  }
  ArmDescription arm;
  Oracle oracle;
  PlaneKinematics kinematics;
};

TEST_P(PlaneKinematicsOf, PlacesAndMovesPlatesAsMujocoDoes) {
  for (std::size_t plate = 1; plate < kinematics.plates().size(); ++plate) {
    const int body = oracle.body(plate);
    const PlaneKinematics::Plate& own = kinematics.plates()[plate];
    EXPECT_NEAR(own.position.x(), oracle.data->xpos[3 * body], kRounding);
    EXPECT_NEAR(own.position.y(), oracle.data->xpos[3 * body + 1], kRounding);
    EXPECT_NEAR(own.axis.x(), oracle.data->xmat[9 * body], kRounding);
    EXPECT_NEAR(own.axis.y(), oracle.data->xmat[9 * body + 3], kRounding);
    std::array<double, 6> velocity{};  // rotation, then translation
    mj_objectVelocity(oracle.model, oracle.data, mjOBJ_XBODY, body, velocity.data(), 0);
    EXPECT_NEAR(own.rate_rad_per_s, velocity[2], 1e-10);
    EXPECT_NEAR(own.velocity.x(), velocity[3], 1e-10);
    EXPECT_NEAR(own.velocity.y(), velocity[4], 1e-10);
  }
}

TEST_P(PlaneKinematicsOf, SharesForcesAmongJointsAsMujocoDoes) {
  RandomStream random(6, 0);
  std::vector<PlaneKinematics::Load> loads(kinematics.plates().size() - 1);
  std::vector<double> expected(static_cast<std::size_t>(oracle.model->nv));
  for (std::size_t i = 0; i < loads.size(); ++i) {
    loads[i] = {{random.normal(), random.normal()}, random.normal()};
    const std::array force = {loads[i].force_n.x(), loads[i].force_n.y(), 0.0};
    const std::array torque = {0.0, 0.0, loads[i].torque_n_m};
    const int body = oracle.body(i + 1);
    mj_applyFT(oracle.model, oracle.data, force.data(), torque.data(), oracle.data->xpos + 3 * body,
               body, expected.data());
  }
  std::vector<double> own(expected.size());
  kinematics.add_joint_forces(loads, own.data());
  for (std::size_t joint = 0; joint < own.size(); ++joint) {
    EXPECT_NEAR(own[joint], expected[joint], 1e-10) << "joint " << joint;
  }
}

INSTANTIATE_TEST_SUITE_P(Segments, PlaneKinematicsOf, testing::Values(1, 3, 5));

}  // namespace
}  // namespace limber
