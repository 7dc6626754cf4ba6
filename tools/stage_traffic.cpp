#include "stage_traffic.hpp"

namespace facet {

const std::vector<StageTraffic>& stage_traffic() {
  constexpr int idle = StageTraffic::idle;
  static const std::vector<StageTraffic> traffic{
      {StageId::temporal, {{"default", 32}, {"paper", 32}, {"naive", idle}}},
      {StageId::fill, {{"default", 12}, {"paper", 12}, {"naive", 1}}},
      {StageId::wiener, {{"default", 8}, {"paper", 36}, {"naive", idle}}},
      {StageId::gradient, {{"default", idle}, {"paper", 12}, {"naive", 12}}},
      {StageId::depth_strength, {{"default", 5}, {"paper", 17}, {"naive", 17}}},
      {StageId::depth_canny, {{"default", idle}, {"paper", 15}, {"naive", 8}}},
      {StageId::crease_strength, {{"default", 45}, {"paper", 41}, {"naive", 41}}},
      {StageId::crease_canny, {{"default", 54}, {"paper", 8}, {"naive", 8}}},
      {StageId::morphology, {{"default", 14}, {"paper", 43}, {"naive", 12}}},
      {StageId::labelling, {{"default", 31}, {"paper", 31}, {"naive", 31}}},
      {StageId::support, {{"default", 28}, {"paper", idle}, {"naive", idle}}},
      {StageId::contours, {{"default", 2}, {"paper", 16}, {"naive", 15}}},
      {StageId::validation, {{"default", 4}, {"paper", 4}, {"naive", 0}}},
      {StageId::pose, {{"default", 0}, {"paper", 0}, {"naive", 0}}},
      {StageId::grasps, {{"default", 0}, {"paper", 0}, {"naive", 0}}},
      {StageId::objects, {{"default", 3}, {"paper", idle}, {"naive", idle}}},
  };
  return traffic;
}

}  // namespace facet
