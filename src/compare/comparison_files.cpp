#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>
#include <tinyxml2.h>

#include "compare/comparison_report.hpp"

namespace facet {
namespace {

using Json = nlohmann::ordered_json;

template <class T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json json_of(const ComparedValue& value) {
  Json json;
  json["kind"] = value.kind == MeasuredKind::latency ? "latency" : "accuracy";
  json["method"] = value.method;
  json["dataset"] = value.dataset;
  json["name"] = value.name;
  json["before"] = or_null(value.before);
  json["after"] = or_null(value.after);
  json["change"] = or_null(value.change);
  json["lo"] = value.interval ? Json(value.interval->lo) : Json(nullptr);
  json["hi"] = value.interval ? Json(value.interval->hi) : Json(nullptr);
  json["p"] = or_null(value.p);
  json["n"] = value.n;
  json["verdict"] = std::string(verdict_name(value.verdict));
  json["reason"] = value.reason;
  return json;
}

void add_case(tinyxml2::XMLElement& suite, const ComparedValue& value) {
  tinyxml2::XMLElement* test = suite.InsertNewChildElement("testcase");
  test->SetAttribute("name", value.name.c_str());
  test->SetAttribute("classname", fmt::format("{}.{}", value.method, value.dataset).c_str());
  const std::string text = describe(value);
  const bool failed = value.verdict == Verdict::regressed || (value.vanished && value.rule.required);
  const char* kind = failed && value.rule.hard                                            ? "failure"
                     : value.verdict == Verdict::ok || value.verdict == Verdict::improved ? nullptr
                                                                                          : "skipped";
  if (kind != nullptr) test->InsertNewChildElement(kind)->SetAttribute("message", text.c_str());
  test->InsertNewChildElement("system-out")->SetText(text.c_str());
}

}  // namespace

std::string comparison_json(const Comparison& comparison, const GateDecision& decision,
                            const ComparedNames& names) {
  Json json;
  json["schema_version"] = 1;
  json["before"] = names.before;
  json["after"] = names.after;
  json["passed"] = decision.result == GateResult::passed;
  json["failures"] = decision.failures;
  json["warnings"] = decision.warnings;
  json["vanished"] = comparison.vanished;
  json["notes"] = comparison.notes;
  json["values"] = Json::array();
  for (const ComparedValue& value : comparison.values) json["values"].push_back(json_of(value));
  return json.dump(2) + '\n';
}

std::string junit_xml(const Comparison& comparison, const GateDecision& decision) {
  tinyxml2::XMLDocument document;
  document.InsertEndChild(document.NewDeclaration());
  tinyxml2::XMLElement* root = document.NewElement("testsuites");
  document.InsertEndChild(root);
  std::map<MethodOnDataset, tinyxml2::XMLElement*> suites;
  for (const ComparedValue& value : comparison.values) {
    tinyxml2::XMLElement*& suite = suites[{value.method, value.dataset}];
    if (suite == nullptr) {
      suite = root->InsertNewChildElement("testsuite");
      suite->SetAttribute("name", fmt::format("{} on {}", value.method, value.dataset).c_str());
    }
    add_case(*suite, value);
  }
  tinyxml2::XMLElement* whole = root->InsertNewChildElement("testsuite");
  whole->SetAttribute("name", "gate");
  tinyxml2::XMLElement* test = whole->InsertNewChildElement("testcase");
  test->SetAttribute("name", "decision");
  test->SetAttribute("classname", "gate");
  for (const std::string& failure : decision.failures)
    test->InsertNewChildElement("failure")->SetAttribute("message", failure.c_str());
  tinyxml2::XMLPrinter printer;
  document.Print(&printer);
  return printer.CStr();
}

}  // namespace facet
