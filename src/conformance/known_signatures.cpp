#include "conformance/diagnose.hpp"
#include "conformance/fitted.hpp"

namespace denhartog::conformance {

Signatures known_signatures(std::span<const Judged> judged) {
    return {mistakes(), [fitted = fitted_answers(judged)](std::string_view name, const Question& q) {
                const auto found = fitted.find(std::string(name));
                return found == fitted.end() ? answer_with_mistake(name, q) : found->second(q);
            }};
}

} // namespace denhartog::conformance
