// The list of known mistakes, and the answers of a program that makes some of them. Of several mistakes made together those that
// change the question act first, then those of formulas, then those that change the answer. Read `answer_with_several` first; the
// makers of mistakes are in `mistake_definition.hpp`, the mistakes in `mistakes_of_input.cpp` and `mistakes_of_output.cpp`.
#include <algorithm>

#include "conformance/mistakes/mistake_definition.hpp"
#include "denhartog/number/errors.hpp"

namespace denhartog::conformance {

std::optional<Value> Answering::operator()(const ProtocolQuestion& q) const {
    const Answering* const only = this;
    return alone ? where_finite([&] { return alone(q); }) : answer_with_several({&only, 1}, q);
}

std::optional<Value> answer_with_several(std::span<const Answering* const> several, const ProtocolQuestion& q) {
    return where_finite([&] {
        std::vector<const Answering*> made;
        std::ranges::copy_if(several, std::back_inserter(made), [&](const auto* one) { return one->touches && one->touches(q); });
        if (made.empty()) return std::optional<Value>();
        ProtocolQuestion read = q;
        Choices c;
        bool formulas = false;
        for (const Answering* mistake : made) {
            formulas = formulas || mistake->choose;
            if (mistake->read) mistake->read(read);
            if (mistake->choose) mistake->choose(c, q);
        }
        std::optional<Value> value = formulas ? plain_answer(read, c) : plain_answer(read);
        for (const Answering* mistake : made)
            if (value && mistake->change) mistake->change(*value, q);
        return value;
    });
}

std::span<const Mistake> mistakes() {
    static const std::vector<Mistake> all = [] {
        std::vector<Mistake> list = mistakes_of_input();
        for (const auto& part : {mistakes_of_formulas(), mistakes_of_output()}) list.insert(list.end(), part.begin(), part.end());
        std::ranges::sort(list, {}, &Mistake::name);
        return list;
    }();
    return all;
}

std::optional<Value> answer_with_mistake(std::string_view name, const ProtocolQuestion& q) {
    const auto found = std::ranges::find(mistakes(), name, &Mistake::name);
    if (found == mistakes().end()) throw InputError("mistake", "must be one of the known ones", std::string(name));
    return found->answer(q);
}

} // namespace denhartog::conformance
