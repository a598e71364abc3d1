// A first look at an implementation: does it keep to the protocol? Every quantity of the paper is asked once, then a quantity
// that does not exist and a scene that breaks a rule; no value is judged. Read `smoke`.
#include "conformance/session/session.hpp"

#include <string_view>

#include "denhartog/number/legible.hpp"
#include "denhartog/number/number_text.hpp"

namespace denhartog::conformance {
namespace {

constexpr int samples = 8;

// Two masses that differ in everything; the contact slides throughout, but for the quantities of a contact that stops or rests.
ProtocolQuestion question_about(const Quantity& asked) {
    ProtocolQuestion q;
    q.id = "smoke-" + std::string(asked.name);
    for (char& c : q.id)
        if (c == '_') c = '-';
    q.quantity = asked.name;
    q.mass_ratios = {1, 2.5};
    q.stiffness_ratios = {1, 0.625};
    q.damping_ratios = {0.0625, 0.125};
    q.contact = 2;
    q.load = asked.name == "beta_lim_high_frequency" ? 2 : 1;
    q.mu = 1.25;
    q.r = 0.75;
    q.beta = asked.name == "rest_interval"                                         ? 8
             : asked.shape == Shape::durations || asked.name == "stops_per_period" ? 0.5
                                                                                   : 0.0625;
    q.mass = asked.of_mass ? 1 : 0;
    q.tau = asked.name == "displacement" ? 0.5 : 0;
    q.samples = asked.shape == Shape::samples ? samples : 0;
    return q;
}

std::string fault_of(const Quantity& asked, const ProtocolQuestion& q, const Value& value) {
    if (asked.shape == Shape::word) return value.word.empty() ? "must be the name of a regime" : "";
    if (!value.word.empty()) return "must be numbers, but is " + value.word;
    const std::size_t count = asked.shape == Shape::modes     ? q.mass_ratios.size()
                              : asked.shape == Shape::complex ? 2
                              : asked.shape == Shape::samples ? static_cast<std::size_t>(q.samples)
                                                              : 1;
    if (asked.shape == Shape::durations || value.numbers.size() == count) return "";
    return "must be as many numbers as the protocol has, " + std::to_string(count) + ", but is " +
           std::to_string(value.numbers.size());
}

SmokeCheck check_of(const Quantity& asked, const ProtocolQuestion& q, const Answer& answer) {
    const std::string what(asked.name);
    if (const auto* skipped = std::get_if<Skipped>(&answer)) return {what, "skipped: " + legible(skipped->reason), true};
    if (const auto* rejected = std::get_if<Rejected>(&answer))
        return {what, "rejected, but the question keeps all rules: " + legible(rejected->reason), false};
    if (const auto* unusable = std::get_if<Unusable>(&answer)) return {what, legible(unusable->reason), false};
    const auto& value = std::get<Value>(answer);
    const std::string fault = fault_of(asked, q, value);
    if (!fault.empty()) return {what, fault, false};
    std::string shown = value.word;
    for (const double x : value.numbers) shown += (shown.empty() ? "" : " ") + number_to_text(x);
    return {what, legible(shown), true};
}

// A question about a quantity that there is not: one that is known, with its name replaced in the line.
std::string line_about_nothing(const Partner& partner, const ProtocolQuestion& known) {
    std::string line = line_for(partner, known);
    const std::string quoted = partner.dialect == "plain" ? " H_j " : "\"H_j\"";
    const std::string other = partner.dialect == "plain" ? " no_such_quantity " : "\"no_such_quantity\"";
    return line.replace(line.find(quoted), quoted.size(), other);
}

} // namespace

Smoke smoke(const RunSettings& settings) {
    const WithoutBrokenPipeSignal guard;
    const Partner partner = shake_hands(settings);
    Smoke found{{{"handshake", partner.dialect + ", " + partner.name, true}}};
    const auto look = [&](const std::string& what, const std::string& line, const std::string& id, const auto& check) {
        if (found.broken) return;
        const Reply reply = partner.process->ask(line, settings.seconds);
        found.broken = reply.trouble.has_value();
        found.checks.push_back(found.broken ? SmokeCheck{what, reply.told, false} : check(answer_in(partner, reply.line, id)));
    };
    for (const Quantity& asked : quantities()) {
        if (asked.absolute) continue; // of systems beyond the paper
        const ProtocolQuestion q = question_about(asked);
        look(q.quantity, line_for(partner, q), q.id, [&](const Answer& answer) { return check_of(asked, q, answer); });
    }
    ProtocolQuestion q = question_about(quantity("H_j"));
    q.id = "smoke-unknown";
    look("unknown quantity", line_about_nothing(partner, q), q.id, [](const Answer& answer) {
        const bool good = std::holds_alternative<Skipped>(answer);
        return SmokeCheck{"unknown quantity", good ? "skipped" : "must be skipped", good};
    });
    q.id = "smoke-rejected";
    q.mass_ratios.back() = -1;
    look("negative mass", line_for(partner, q), q.id, [](const Answer& answer) {
        const bool good = std::holds_alternative<Rejected>(answer) || std::holds_alternative<Skipped>(answer);
        return SmokeCheck{"negative mass", good ? "rejected or skipped" : "must be rejected", good,
                          std::holds_alternative<Value>(answer)};
    });
    if (found.broken) return found;
    const std::string end = partner.process->finish(settings.seconds);
    found.checks.push_back({"end", end.empty() ? "status 0 when its standard input was closed" : end, end.empty()});
    const Unasked& unasked = partner.process->unasked();
    if (unasked.lines > 0)
        found.checks.push_back(
            {"nothing unasked", std::to_string(unasked.lines) + " lines, the first " + legible(unasked.first), false});
    return found;
}

} // namespace denhartog::conformance
