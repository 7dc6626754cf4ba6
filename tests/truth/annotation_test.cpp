#include "truth/annotation.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "file/file_bytes.hpp"
#include "support/temporary_folder.hpp"

namespace facet {
namespace {

std::string file_with(const std::string& shapes, const std::string& flags = R"({"pixel_centres": true})") {
  return R"({"version": "5.4.1", "flags": )" + flags +
         R"(, "imageWidth": 64, "imageHeight": 48, "shapes": [)" + shapes + "]}";
}

const std::string good_surface = R"({"label": "surface/1", "group_id": 1, "shape_type": "polygon",
  "points": [[1, 1], [9, 1], [9, 9]], "flags": {"graspable": true}})";

std::vector<std::string> rules_broken_by(const std::string& shapes) {
  std::vector<std::string> rules;
  for (const auto& problem : parse_annotation(file_with(shapes), {64, 48}).problems)
    rules.push_back(problem.rule);
  return rules;
}

std::string edge(const std::string& flags, const std::string& label = "edge/1") {
  return R"({"label": ")" + label +
         R"(", "group_id": 1, "shape_type": "linestrip", "points": [[1, 1], [9, 1]],
    "flags": {)" +
         flags + "}}";
}

TEST(Annotation, PointsOfOtherToolsAreShiftedByHalfAPixelAndOursAreNot) {
  const auto ours = parse_annotation(file_with(good_surface), {64, 48});
  const auto others = parse_annotation(file_with(good_surface, "{}"), {64, 48});
  ASSERT_TRUE(ours.problems.empty());
  EXPECT_EQ(ours.truth.surfaces[0].parts[0].path[1], (ImagePoint{9, 1}));
  EXPECT_EQ(others.truth.surfaces[0].parts[0].path[1], (ImagePoint{8.5, 0.5}));
}

TEST(Annotation, PolygonsWithTheSameLabelAndGroupAreOneSurface) {
  const auto annotation = parse_annotation(file_with(good_surface + "," + good_surface), {64, 48});
  ASSERT_EQ(annotation.truth.surfaces.size(), 1u);
  EXPECT_EQ(annotation.truth.surfaces[0].parts.size(), 2u);
  EXPECT_TRUE(annotation.truth.surfaces[0].graspable);
}

TEST(Annotation, WhatIsWrittenReadsBackTheSame) {
  Truth truth{.size = {64, 48}};
  truth.surfaces.push_back({2, 7, true, true, {{{{1.25, 2}, {30, 2.5}, {30, 40.125}}, 0}}, "side"});
  truth.edges.push_back({5, 7, EdgeKind::convex, true, {{1, 2}, {30.1, 2.5}}, "rim"});
  truth.edges.push_back({6, 7, EdgeKind::concave, false, {{1, 2}, {3, 4}, {5, 7}}, ""});
  truth.support.push_back({{{-0.5, -0.5}, {63.5, -0.5}, {63.5, 47.5}}, 3});
  truth.ignore.push_back({{{5, 5}, {6, 5}, {6, 6}}, 4});
  const Annotation back = parse_annotation(annotation_text(truth, "frame.png"), {64, 48});
  ASSERT_TRUE(back.problems.empty());
  EXPECT_EQ(back.truth.surfaces[0].parts[0].path, truth.surfaces[0].parts[0].path);
  EXPECT_EQ(back.truth.surfaces[0].description, "side");
  EXPECT_TRUE(back.truth.surfaces[0].curved);
  EXPECT_EQ(back.truth.edges[1].line, truth.edges[1].line);
  EXPECT_EQ(back.truth.edges[0].kind, EdgeKind::convex);
  EXPECT_EQ(back.truth.edges[0].object, 7);
  EXPECT_EQ(back.truth.support[0].path, truth.support[0].path);
  EXPECT_EQ(back.truth.ignore[0].path, truth.ignore[0].path);
  EXPECT_EQ(annotation_text(back.truth, "frame.png"), annotation_text(truth, "frame.png"));
}

TEST(Annotation, EveryBrokenRuleIsNamed) {
  struct Case {
    std::string shape, rule;
  };
  const std::string line = R"("shape_type": "linestrip", "points": [[1, 1], [9, 1]])";
  const std::string polygon = R"("shape_type": "polygon", "points": [[1, 1], [9, 1], [9, 9]])";
  const std::vector<Case> cases{
      {R"({"label": "face/1", "group_id": 1, )" + polygon + "}", "unknown label 'face/1'"},
      {R"({"label": "surface/x", "group_id": 1, )" + polygon + "}", "unknown label 'surface/x'"},
      {R"({"label": "support/3", "group_id": 0, )" + polygon + "}", "unknown label 'support/3'"},
      {R"({"label": "support/0", "group_id": 2, )" + polygon + "}", "has the group_id 2, expected 0"},
      {R"({"label": "surface/1", )" + polygon + "}", "surface/1 has no group_id"},
      {R"({"label": "surface/1", "group_id": 0, )" + polygon + "}", "expected an object id >= 1"},
      {R"({"label": "surface/1", "group_id": 1, )" + line + "}", "must be a polygon, not 'linestrip'"},
      {R"({"label": "edge/1", "group_id": 1, "flags": {"depth": true}, )" + polygon + "}",
       "must be a linestrip"},
      {edge(""), "exactly one of depth, convex, concave; 0 are set"},
      {edge(R"("depth": true, "convex": true)"), "exactly one of depth, convex, concave; 2 are set"},
      {edge(R"("concave": true, "graspable": true)"), "a concave edge cannot be graspable"},
      {edge(R"("depth": true, "sharp": true)"), "unknown flag 'sharp'"},
      {edge(R"("depth": 1)"), "flag 'depth' must be true or false"},
      {R"({"label": "ignore/1", "shape_type": "polygon", "points": [[1, 1], [64, 1], [9, 9]]})",
       "(64.0, 1.0) outside"},
      {R"({"label": "ignore/1", "shape_type": "polygon", "points": [[1, 1], [9, 9]]})",
       "fewer than 3 points"},
      {R"({"label": "ignore/1", "shape_type": "polygon", "points": [[1, 1], [2], [3, 4], [9, 9]]})",
       "two numbers"},
      {R"({"label": "ignore/1", "shape_type": "polygon"})", "no list 'points'"},
      {"7", "not an object"}};
  for (const Case& c : cases) {
    const auto rules = rules_broken_by(c.shape);
    ASSERT_FALSE(rules.empty()) << c.rule;
    EXPECT_NE(rules[0].find(c.rule), std::string::npos) << rules[0];
  }
}

TEST(Annotation, RepeatedEdgeLabelsAndPartsThatDisagreeAreNamed) {
  EXPECT_EQ(rules_broken_by(edge(R"("depth": true)") + "," + edge(R"("convex": true)")),
            std::vector<std::string>{"repeated label edge/1"});
  const std::string other = R"({"label": "surface/1", "group_id": 1, "shape_type": "polygon",
    "points": [[1, 1], [9, 1], [9, 9]]})";
  EXPECT_EQ(rules_broken_by(good_surface + "," + other),
            std::vector<std::string>{"parts of surface/1 have different flags"});
}

TEST(Annotation, AllProblemsOfAFileAreReportedAtOnceWithTheirShapes) {
  const TemporaryFolder folder;
  write_file_atomically(folder.path() / "frame.json",
                        file_with(good_surface + "," + edge("") + "," + R"({"label": "x"})"));
  try {
    read_annotation(folder.path() / "frame.json", {640, 480});
    FAIL() << "must throw";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::data);
    const std::string message = error.what();
    EXPECT_NE(message.find("frame.json: 3 broken rules"), std::string::npos) << message;
    EXPECT_NE(message.find("the frame has 640 x 480"), std::string::npos);
    EXPECT_NE(message.find("shape 1: an edge must have"), std::string::npos);
    EXPECT_NE(message.find("shape 2: unknown label 'x'"), std::string::npos);
  }
}

TEST(Annotation, TextThatIsNoLabelMeFileIsAProblemNotACrash) {
  for (const char* text : {"", "{", "[]", "{}", R"({"shapes": 3})"}) {
    EXPECT_EQ(parse_annotation(text, {64, 48}).problems.size(), 1u) << text;
  }
}

}  // namespace
}  // namespace facet
