#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/run_report.hpp"

namespace facet {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

RunRecord timed_run(const std::string& backend) {
  RunRecord run;
  run.manifest.backend = backend;
  run.manifest.timing_threads = 1;
  run.timing.stages = {"fill"};
  TimingSample sample{"d", "f0", "m"};
  sample.stage_ms = {2};
  sample.total_ms = 2;
  run.timing.samples = {sample};
  return run;
}

TEST(TimingSection, NamesTheBackEndAndHowTimesOfADeviceWereTaken) {
  const auto notes = [](const std::string& backend) {
    return timing_section(timed_run(backend)).tables.at(0).notes;
  };
  EXPECT_THAT(notes("cpu"), Contains(HasSubstr("back end cpu")));
  EXPECT_THAT(notes("cpu"), Not(Contains(HasSubstr("by events"))));
  EXPECT_THAT(notes("cuda"), Contains(HasSubstr("back end cuda")));
  EXPECT_THAT(notes("cuda"), Contains(HasSubstr("timed on the device, by events")));
}

}  // namespace
}  // namespace facet
