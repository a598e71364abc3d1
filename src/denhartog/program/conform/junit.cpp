#include <map>

#include "conformance/verdict.hpp"
#include "denhartog/program/conform/report.hpp"

namespace denhartog::program {
namespace {

using conformance::Judged;
using conformance::Verdict;

std::string escaped(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        switch (c) {
        case '&': safe += "&amp;"; break;
        case '<': safe += "&lt;"; break;
        case '>': safe += "&gt;"; break;
        case '"': safe += "&quot;"; break;
        case '\n': safe += "&#10;"; break;
        default: safe += static_cast<unsigned char>(c) < 0x20 ? '?' : c;
        }
    }
    return safe;
}

std::string attribute(const std::string& name, const std::string& text) { return " " + name + "=\"" + escaped(text) + "\""; }

bool is_error(Verdict verdict) { return verdict == Verdict::crash || verdict == Verdict::timeout || verdict == Verdict::stall; }

std::string case_of(const Judged& one) {
    const std::string start = "  <testcase" + attribute("name", one.vector->question.id) +
                              attribute("classname", one.vector->group + "." + one.vector->question.quantity);
    if (conformance::is_right(one.verdict)) return start + "/>\n";
    const std::string verdict(name(one.verdict));
    const std::string element = one.verdict == Verdict::skipped ? "skipped" : is_error(one.verdict) ? "error" : "failure";
    const std::string message = one.reason.empty() ? verdict : one.reason;
    if (element == "skipped") return start + ">\n   <skipped" + attribute("message", message) + "/>\n  </testcase>\n";
    return start + ">\n   <" + element + attribute("type", verdict) + attribute("message", message) + ">" +
           escaped(answer_text(one, "")) + "</" + element + ">\n  </testcase>\n";
}

} // namespace

std::string report_junit(const ConformReport& report) {
    struct Suite {
        std::size_t tests = 0, failures = 0, errors = 0, skipped = 0;
        std::string cases;
    };
    std::map<std::string, Suite> suites;
    Suite all;
    for (const Judged& one : report.judged) {
        const bool right = conformance::is_right(one.verdict), skipped = one.verdict == Verdict::skipped;
        for (Suite* suite : {&suites[one.vector->group], &all}) {
            ++suite->tests;
            if (skipped) ++suite->skipped;
            if (is_error(one.verdict)) ++suite->errors;
            if (!right && !skipped && !is_error(one.verdict)) ++suite->failures;
        }
        suites[one.vector->group].cases += case_of(one);
    }
    const auto counts = [](const Suite& s) {
        return attribute("tests", std::to_string(s.tests)) + attribute("failures", std::to_string(s.failures)) +
               attribute("errors", std::to_string(s.errors)) + attribute("skipped", std::to_string(s.skipped));
    };
    std::string text =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" + attribute("name", report.subject) + counts(all) + ">\n";
    for (const auto& [group, suite] : suites)
        text += " <testsuite" + attribute("name", group) + counts(suite) + ">\n" + suite.cases + " </testsuite>\n";
    return text + "</testsuites>\n";
}

} // namespace denhartog::program
