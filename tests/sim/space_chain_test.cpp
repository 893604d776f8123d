#include "src/sim/mujoco_chain.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include "limber/common/random_stream.hpp"
#include "space_arms.hpp"

namespace limber {
namespace {

mjModel* load(const std::string& xml) {
  mjVFS files;
  mj_defaultVFS(&files);
  mj_makeEmptyFileVFS(&files, "arm.xml", static_cast<int>(xml.size()));
  std::copy(xml.begin(), xml.end(), static_cast<char*>(files.filedata[0]));
  char message[200] = "";
  mjModel* model = mj_loadXML("arm.xml", &files, message, sizeof message);
  mj_deleteVFS(&files);
  EXPECT_NE(model, nullptr) << message;
  return model;
}

// (V12)
TEST(SpaceChain, PlatesLieWhereMujocoHasThem) {
  constexpr double kTolerance = 1e-12;  // rounding
  ArmDescription arm = own_space_arm("hanging_3x2");
  VirtualArmParameters physics = virtual_arm_parameters(arm);
  physics.base_misalignment_rad = 0.3;
  mjModel* model = load(chain_mjcf(arm, physics, 1e-3));
  mjData* data = mj_makeData(model);
  const std::vector<SpaceLink> links = space_chain_links(arm, physics);
  ASSERT_EQ(model->nv, static_cast<int>(kSpaceJoints * links.size()));
  RandomStream random(3, 0);
  for (int i = 0; i < model->nq; ++i) {
    data->qpos[i] = random.uniform(-1.0, 1.0) * (i % 4 == 0 ? 0.01 : 0.3);
  }
  mj_kinematics(model, data);
  SpaceBackboneD plates;
  write_space_plates(links, physics.base_misalignment_rad, data->qpos, plates);
  for (Eigen::Index plate = 0; plate < plates.rows(); ++plate) {
    const mjtNum* position = data->xpos + 3 * (plate + 1);  // body 0 is the world
    const mjtNum* rotation = data->xquat + 4 * (plate + 1);
    for (Eigen::Index i = 0; i < 3; ++i) {
      EXPECT_NEAR(plates(plate, i), position[i], kTolerance);
    }
    const double same = plates(plate, 6) * rotation[0] + plates(plate, 3) * rotation[1] +
                        plates(plate, 4) * rotation[2] + plates(plate, 5) * rotation[3];
    EXPECT_NEAR(std::abs(same), 1.0, kTolerance);
  }
  mj_deleteData(data);
  mj_deleteModel(model);
}

}  // namespace
}  // namespace limber
