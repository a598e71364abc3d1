// Statements that are false by a sign or by a branch: the base refuses each, and its reduction alone does not prove one either.
#include <cmath>
#include <set>
#include <stdexcept>

#include "derivation/algebra/symbols.hpp"
#include "tests/catch.hpp"

using namespace denhartog::derivation;
using GiNaC::ex;
using GiNaC::numeric;

namespace {

struct FalseStatement {
    const char* what;
    ex left, right;
};

/// True if the reduction alone, without any sample, proves a statement.
bool reduction_proves(const FalseStatement& f) {
    try {
        return remainder(f.left - f.right, domain_of({f.left, f.right})).is_zero();
    } catch (const std::domain_error&) {
        return false;
    }
}

std::vector<FalseStatement> false_statements() {
    const Symbols& s = symbols();
    const ex phi = s.phi_j, x = s.V_jr, y = s.V_ji, a = s.psi_ji, b = s.psi_li, R = s.R;
    const ex rho = sqrt(x * x + y * y), arc = atan2(y, x), tau = s.tau;
    return {
        {"root of the square of a sine", sqrt(pow(sin(phi), 2)), sin(phi)},
        {"root of the square of a cosine", sqrt(pow(cos(phi), 2)), cos(phi)},
        {"root of one less the square of a sine", sqrt(1 - pow(sin(phi), 2)), cos(phi)},
        {"root of the square of a symbol", sqrt(x * x), x},
        {"root of the square of a symbol, its sign changed", sqrt(x * x), -x},
        {"root of the square of a product", sqrt(a * a * b * b), a * b},
        {"root of the square of a difference", sqrt(pow(1 - R, 2)), 1 - R},
        {"root of the square of a hyperbolic sine", sqrt(pow(cosh(x), 2) - 1), sinh(x)},
        {"sign lost in a quotient of roots", sqrt(a * a / (b * b)), a / b},
        {"sign lost in a root over a symbol", sqrt(1 + a * a / (b * b)), sqrt(a * a + b * b) / b},
        {"product of the roots of two negative numbers", sqrt(a) * sqrt(b), sqrt(a * b)},
        {"root of a quotient of numbers of any sign", b * sqrt(a / b), sqrt(a * b)},
        {"cosine of half an arc without the half", cos(arc / 2), x / rho},
        {"sine of half an arc without the half", sin(arc / 2), y / rho},
        {"sine of half an arc without its sign", sin(arc / 2), sqrt((1 - x / rho) / 2)},
        {"cosine of half an angle beyond a half turn", cos(phi), sqrt((1 + cos(2 * phi)) / 2)},
        {"arc of twice an angle", atan2(sin(2 * phi), cos(2 * phi)), 2 * phi},
        {"half the arc of the opposite point", cos(atan2(-y, -x) / 2), -sin(arc / 2)},
        {"half of an arc that has gone round", cos(atan2(sin(2 * phi), cos(2 * phi)) / 2), cos(phi)},
        {"half the arc of a square", cos(atan2(2 * x * y, x * x - y * y) / 2), x / rho},
        {"sign of an arc under a root", y / rho * sqrt(x * x), x / rho * sqrt(y * y)},
        {"sine from a cosine, in time and phase", sin(phi + tau), sqrt(1 - pow(cos(phi + tau), 2))},
    };
}

} // namespace

TEST_CASE("what is false by a sign or by a branch is refuted, and not proved by the reduction alone", "[zero_test]") {
    for (const FalseStatement& f : false_statements()) {
        CAPTURE(f.what);
        CHECK(decide_equal(f.left, f.right, domain_of({f.left, f.right})).verdict == Verdict::refuted);
        CHECK_FALSE(reduction_proves(f));
    }
}

TEST_CASE("with the sign certain, or left standing, the same statements are proved", "[zero_test]") {
    const Symbols& s = symbols();
    const ex phi = s.phi_j, x = s.V_jr, y = s.V_ji, R = s.R, rho = sqrt(x * x + y * y), arc = atan2(y, x);
    const auto proved = [](const ex& left, const ex& right) {
        return decide_equal(left, right, domain_of({left, right})).verdict == Verdict::proved;
    };
    CHECK(proved(sqrt(pow(sin(phi), 2)), sqrt(1 - pow(cos(phi), 2))));
    CHECK(proved(sqrt(R * R * s.zeta), R * sqrt(s.zeta)));
    CHECK(proved(sqrt((x * x + y * y) / (R * R)), rho / R));
    CHECK(proved(cos(arc / 2), sqrt((1 + x / rho) / 2)));
    CHECK(proved(sin(arc / 2) * cos(arc / 2), y / (2 * rho)));
    CHECK(proved(cos(3 * arc / 2) + cos(arc / 2), 2 * x / rho * cos(arc / 2)));
    CHECK(proved(sqrt(1 - s.zeta) * sqrt(1 + s.zeta), s.w));
    CHECK(proved(s.w / sqrt(1 - s.zeta), sqrt(1 + s.zeta)));
}

TEST_CASE("an angle that is halved outside an angle it stands in is not taken for its double", "[zero_test]") {
    const ex phi = symbols().phi_j, left = cos(cos(phi)) + cos(phi / 2), right = cos(cos(2 * phi)) + cos(phi / 2);
    CHECK(decide_equal(left, right, domain_of({left, right})).verdict == Verdict::refuted);
    CHECK(decide_equal(left, left, domain_of({left})).verdict != Verdict::refuted);
}

TEST_CASE("a proof says on what the signs of its roots rest", "[zero_test]") {
    const Symbols& s = symbols();
    const ex rho = sqrt(s.V_jr * s.V_jr + s.V_ji * s.V_ji), uncertain = sqrt(s.V_jr - s.psi_ji);
    const Decision decision = decide_equal(rho * uncertain, uncertain * rho, domain_of({rho, uncertain}));
    REQUIRE(decision.roots.size() == 2);
    for (const RootReason& root : decision.roots)
        CHECK(root.reason ==
              (root.radicand.degree(s.V_jr) == 2 ? "the bounds of its terms" : "the statement is made where the root is real"));
    const ex square_less_one = (uncertain + 1) * (uncertain - 1), without_root = s.V_jr - s.psi_ji - 1;
    CHECK(decide_equal(square_less_one, without_root, domain_of({uncertain})).verdict != Verdict::proved);
    CHECK(decide_equal(square_less_one, without_root, domain_of({uncertain}), {uncertain}).verdict == Verdict::proved);
}

TEST_CASE("polynomials that are never negative are told from those that may be", "[zero_test]") {
    const Symbols& s = symbols();
    KnownBounds known;
    for (const Range& range : domain_of({s.R, s.zeta, s.V_jr, s.beta})) known[range.symbol] = range.bounds;
    const ex R = s.R, zeta = s.zeta, V = s.V_jr;
    const auto certain = [&known](const ex& e) { return !why_not_negative(e, known).empty(); };
    CHECK(certain(1 - zeta * zeta));
    CHECK(certain(R * zeta + V * V));
    CHECK(certain(pow(1 - R * R, 2) + 4 * zeta * zeta * R * R));
    CHECK(certain(pow(V - R, 2)));
    CHECK(certain((zeta - 1) * (zeta - 2)));
    CHECK(certain(V * V + 2 * V * R + 2 * R * R));
    CHECK_FALSE(certain(V));
    CHECK_FALSE(certain(1 - R));
    CHECK_FALSE(certain(zeta * zeta - 1));
    CHECK_FALSE(certain(V * V + 3 * V * R + 2 * R * R));
    CHECK_FALSE(certain(V * V - zeta));
    CHECK_FALSE(certain(pow(1 - R * R, 2) - zeta * R));
    CHECK_FALSE(certain(s.psi_ji * R + 1)); // a symbol without bounds
}

TEST_CASE("sample points take every combination of signs in turn", "[zero_test]") {
    const Symbols& s = symbols();
    std::set<std::vector<bool>> patterns;
    std::set<int> quadrants;
    for (const Point& point : sample_points(domain_of({s.psi_ji, s.psi_li, s.V_ji, s.phi_j}), 32)) {
        std::vector<bool> signs;
        for (const auto& [symbol, value] : point) {
            signs.push_back(value.is_negative());
            if (symbol.is_equal(s.phi_j)) quadrants.insert(static_cast<int>(std::floor(value.to_double() / 1.5708)));
        }
        patterns.insert(signs);
    }
    CHECK(patterns.size() == 16);
    CHECK(quadrants.size() == 4);
}

TEST_CASE("what has a value at few points only is not proved", "[zero_test]") {
    const ex x = symbols().V_jr, root = sqrt(x * x * x * x - numeric(255, 16)); // real next to |x| = 2 alone
    const Decision decision = decide_equal(root, root, domain_of({root}));
    CHECK(decision.verdict == Verdict::unknown);
    CHECK(decision.reason.find("points of the domain have values") != std::string::npos);
}
