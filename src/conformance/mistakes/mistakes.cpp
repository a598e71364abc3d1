// The list of known mistakes, and the makers of their answers: the plain closed form with other choices, another question in the
// place of the one asked, or a right answer that is changed. Several mistakes made together act in this order. Read
// `answer_with_several` first; the mistakes themselves are in the three files beside this one.
#include <algorithm>

#include "conformance/mistakes/mistake_definition.hpp"
#include "denhartog/number/errors.hpp"

namespace denhartog::conformance {

namespace {

// Whether a question is about one of some quantities; about any if there are none.
std::function<bool(const ProtocolQuestion&)> about(Names touched) {
    return [touched = std::move(touched)](const ProtocolQuestion& q) {
        return touched.empty() || std::ranges::find(touched, q.quantity) != touched.end();
    };
}

// The answers of a mistake alone follow from its change.
Answering of_changes(Answering mistake) {
    mistake.alone = [parts = mistake](const ProtocolQuestion& q) {
        const Answering* const only = &parts;
        return answer_with_several({&only, 1}, q);
    };
    return mistake;
}

} // namespace

std::optional<Value> answer_with_several(std::span<const Answering* const> several, const ProtocolQuestion& q) {
    return where_finite([&] {
        ProtocolQuestion read = q;
        Choices c;
        std::vector<const Answering*> made;
        for (const Answering* mistake : several)
            if (mistake->touches && mistake->touches(q)) made.push_back(mistake);
        for (const Answering* mistake : made) {
            if (mistake->read) mistake->read(read);
            if (mistake->choose) mistake->choose(c, q);
        }
        if (made.empty()) return std::optional<Value>();
        const bool formulas = std::ranges::any_of(made, [](const Answering* mistake) { return bool(mistake->choose); });
        std::optional<Value> value = formulas ? plain_answer(read, c) : plain_answer(read);
        for (const Answering* mistake : made)
            if (value && mistake->change) mistake->change(*value, q);
        return value;
    });
}

Answering by_formulas_of(Names touched, std::function<void(Choices&, const ProtocolQuestion&)> choose) {
    Answering mistake;
    mistake.touches = about(std::move(touched));
    mistake.choose = std::move(choose);
    return of_changes(std::move(mistake));
}

Answering by_formulas(Names touched, std::function<void(Choices&)> choose) {
    return by_formulas_of(std::move(touched), [choose = std::move(choose)](Choices& c, const ProtocolQuestion&) { choose(c); });
}

Answering by_formulas(Names touched, bool Choices::*choice) {
    return by_formulas(std::move(touched), [choice](Choices& c) { c.*choice = true; });
}

Answering changed(Names touched, std::function<void(Value& value, const ProtocolQuestion& q)> change) {
    Answering mistake;
    mistake.touches = about(std::move(touched));
    mistake.change = std::move(change);
    return of_changes(std::move(mistake));
}

Answering each_changed(Names touched, std::function<double(double x, const ProtocolQuestion& q)> change) {
    return changed(std::move(touched), [change = std::move(change)](Value& value, const ProtocolQuestion& q) {
        for (double& x : value.numbers) x = change(x, q);
    });
}

Answering where_modes_vibrate(Answering mistake) {
    mistake.touches = [touches = std::move(mistake.touches)](const ProtocolQuestion& q) {
        return !is_overdamped(q) && touches(q);
    };
    return of_changes(std::move(mistake));
}

Answering reading(std::function<void(ProtocolQuestion&)> change) {
    Answering mistake;
    mistake.touches = [change](const ProtocolQuestion& q) {
        ProtocolQuestion other = q;
        change(other);
        return other != q;
    };
    mistake.read = std::move(change);
    return of_changes(std::move(mistake));
}

std::span<const Mistake> mistakes() {
    static const std::vector<Mistake> all = [] {
        std::vector<Mistake> list;
        for (auto part : {mistakes_of_input(), mistakes_of_formulas(), mistakes_of_output()})
            for (Mistake& mistake : part) {
                // none for a place beyond the chain, or a motion that is none
                mistake.answer.alone = [answer = std::move(mistake.answer.alone)](const ProtocolQuestion& q) {
                    return where_finite([&] { return answer(q); });
                };
                list.push_back(std::move(mistake));
            }
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
