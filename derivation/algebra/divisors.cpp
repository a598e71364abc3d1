#include "derivation/algebra/divisors.hpp"

#include <stdexcept>

namespace denhartog::derivation {

using GiNaC::ex;
using GiNaC::numeric;
using GiNaC::symbol;

ex Divisors::without_quotients(const ex& e) {
    if (GiNaC::is_a<GiNaC::power>(e)) {
        if (!e.op(1).info(GiNaC::info_flags::integer)) throw std::domain_error("the root of a number");
        const numeric n = GiNaC::ex_to<numeric>(e.op(1));
        const ex base = without_quotients(e.op(0));
        return n.is_negative() ? ex(GiNaC::pow(inverse(base), -n)) : ex(GiNaC::pow(base, n));
    }
    if (GiNaC::is_a<GiNaC::add>(e) || GiNaC::is_a<GiNaC::mul>(e)) {
        ex result = GiNaC::is_a<GiNaC::add>(e) ? 0 : 1;
        for (const ex& part : e)
            result = GiNaC::is_a<GiNaC::add>(e) ? result + without_quotients(part) : result * without_quotients(part);
        return result;
    }
    return e;
}

std::pair<ex, ex> Divisors::cleared(const ex& polynomial) const {
    ex numerator = polynomial, factor = 1;
    for (const Divisor& d : all) {
        const int most = numerator.degree(d.inverse);
        if (most <= 0) continue;
        ex next = 0;
        for (int k = 0; k <= most; ++k) next += numerator.coeff(d.inverse, k) * GiNaC::pow(shown(d), most - k);
        numerator = next.expand();
        factor *= GiNaC::pow(shown(d), most);
    }
    return {numerator, factor};
}

ex Divisors::with_polynomials(const ex& e) const {
    GiNaC::exmap meaning;
    for (const Divisor& d : all)
        if (!d.plain) meaning[d.named] = d.polynomial;
    return e.subs(meaning);
}

void Divisors::add(const ex& polynomial) {
    const bool plain = GiNaC::is_a<symbol>(polynomial) || polynomial.is_equal(GiNaC::Pi);
    all.push_back({polynomial, symbol("inverse"), symbol("divisor"), plain, {}, {}, {polynomial}});
}

ex Divisors::inverse(const ex& base) {
    if (GiNaC::is_a<numeric>(base)) return 1 / base;
    if (GiNaC::is_a<GiNaC::mul>(base)) {
        ex product = 1;
        for (const ex& factor : base) product *= inverse(factor);
        return product;
    }
    if (GiNaC::is_a<GiNaC::power>(base)) return GiNaC::pow(inverse(base.op(0)), base.op(1));
    for (const Divisor& d : all)
        if (base.is_equal(d.inverse)) return shown(d);
    const auto [polynomial, factor] = cleared(base.expand());
    if (!factor.is_equal(1)) return with_polynomials(factor) * inverse(factored_content(with_polynomials(polynomial)));
    for (Divisor& d : all)
        for (const int sign : {1, -1})
            if ((d.polynomial - sign * base).expand().is_zero()) {
                d.seen.push_back(base);
                return sign * d.inverse;
            }
    add(base);
    return all.back().inverse;
}

} // namespace denhartog::derivation
