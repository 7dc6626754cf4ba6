#include "experiment/run_description.hpp"

#include <gtest/gtest.h>

#include "experiment/build_info.hpp"

namespace facet {
namespace {

TEST(RunDescription, RowsOfAnotherBackEndAreNotTakenForThisOnes) {
  Plan plan;
  plan.backend = {Backend::cpu, ""};
  const RunIdentity cpu = make_identity({}, {}, plan);
  plan.backend = {Backend::cuda, ""};
  const RunIdentity cuda = make_identity({}, {}, plan);
  EXPECT_EQ(cpu.config_hash, cuda.config_hash);
  EXPECT_EQ(cpu.build, build_identity());
  EXPECT_EQ(cuda.build, build_identity() + "+cuda");
}

TEST(RunDescription, TheManifestNamesTheBackEnd) {
  Plan plan;
  plan.backend = {Backend::cuda, ""};
  EXPECT_EQ(make_manifest({}, {}, plan, {}).backend, "cuda");
  plan.backend = {Backend::cpu, ""};
  EXPECT_EQ(make_manifest({}, {}, plan, {}).backend, "cpu");
}

}  // namespace
}  // namespace facet
