#include <memory>

#include "conformance/diagnose.hpp"
#include "conformance/diagnosis/fitted.hpp"

namespace denhartog::conformance {

FittedMistakes fitted_mistakes(std::span<const Judged> judged) {
    FittedMistakes all = fitted_instants(judged);
    all.merge(fitted_transient(judged));
    return all;
}

Signatures signatures_with(FittedMistakes fitted,
                           std::function<std::optional<Value>(std::string_view, const ProtocolQuestion&)> answer) {
    const auto shared = std::make_shared<const FittedMistakes>(std::move(fitted));
    const auto found = [shared](std::string_view name) { return shared->find(std::string(name)); };
    return {mistakes(),
            [=, answer = std::move(answer)](std::string_view name, const ProtocolQuestion& q) {
                const auto of_name = found(name);
                return of_name == shared->end() ? answer(name, q) : of_name->second.answer(q);
            },
            [=](std::string_view name) {
                const auto of_name = found(name);
                return of_name == shared->end() ? std::string() : of_name->second.number;
            }};
}

Signatures known_signatures(std::span<const Judged> judged) {
    return signatures_with(fitted_mistakes(judged), answer_with_mistake);
}

} // namespace denhartog::conformance
