// Certificates: an identity becomes a lemma that the kernel of Coq accepts, a near-identity one that it refuses.
#include "derivation/kernel/certificate.hpp"

#include <cstdlib>
#include <fstream>

#include "denhartog/formulas/mode.hpp"
#include "derivation/algebra/symbols.hpp"
#include "derivation/kernel/coq_text.hpp"
#include "derivation/kernel/kernel_check.hpp"
#include "tests/unit/ledger_fixtures.hpp"

using namespace denhartog::derivation;
using GiNaC::ex;

namespace {

Certificate certificate(const ex& left, const ex& right, const LeftOut& left_out = {}) {
    return certificate_of(in_generators(left, right, domain_of({left, right}), roots_in({right})), "lemma", left_out);
}

/// Coq's verdict on a certificate, and on its lemma about the functions if there is one.
Compiled said_of(const Certificate& c) {
    const denhartog::tests::Folder folder;
    const std::string file =
        folder.write("lemma.v", certificate_prelude() + functions_prelude() + c.statement + c.proof + c.in_functions);
    return compile_with_coq(file, "coqc");
}

/// Whether Coq is there; if not the case is counted as skipped.
bool coq_is_there() {
    const bool found = std::system("command -v coqc >/dev/null 2>&1") == 0;
    if (!found) SKIPPED("coqc is not installed");
    return found;
}

void check_accepted(const Certificate& c) {
    if (coq_is_there()) CHECK(said_of(c).message == "");
}

void check_refused(const Certificate& c) {
    if (!coq_is_there()) return;
    const Compiled said = said_of(c);
    CHECK_FALSE(said.accepted);
    CHECK(finds_no_proof(said.message));
}

const ex& R() { return symbols().R; }
const ex& zeta() { return symbols().zeta; }
ex w() { return GiNaC::sqrt(1 - zeta() * zeta()); }
ex theta() { return GiNaC::Pi * w() / R(); }

/// (28) over the exponentials of delta, with the sign of the cosine.
ex first_function_by_exponentials(int sign) {
    const ex delta = GiNaC::Pi * zeta() / R();
    return 2 * w() * GiNaC::sin(theta()) /
           (R() * (1 - zeta() * zeta()) * (GiNaC::exp(delta) + GiNaC::exp(-delta) + sign * 2 * GiNaC::cos(theta())));
}

ex shipped_first_function() { return denhartog::paper::first_damping_function(Symbolic(R()), Symbolic(zeta())).expression(); }

} // namespace

TEST_CASE("a formula and its form in exponentials have a certificate, of the generators and of the functions",
          "[kernel][eq:28]") {
    const Certificate c = certificate(shipped_first_function(), first_function_by_exponentials(1));
    CHECK(c.holds);
    CHECK(c.statement.find("root_1_squared : root_1 ^ 2 = 1 - zeta ^ 2") != std::string::npos);
    CHECK(c.proof.find("by_relation _ _ _ (2 * exp_1 * sin_1) root_1_squared") != std::string::npos);
    CHECK(c.in_functions.find("cos (PI * sqrt (1 - zeta ^ 2) / R_) + cosh (PI * zeta / R_) <> 0") != std::string::npos);
    check_accepted(c);
}

TEST_CASE("a sign that is changed in a formula leaves a rest, and the kernel refuses it", "[kernel][eq:28]") {
    const Certificate c = certificate(shipped_first_function(), first_function_by_exponentials(-1));
    CHECK_FALSE(c.holds);
    CHECK(c.in_functions.empty());
    check_refused(c);
}

TEST_CASE("without a relation or a condition that it needs, a certificate is refused", "[kernel]") {
    const ex left = shipped_first_function(), right = first_function_by_exponentials(1);
    CHECK(certificate(left, right, {.relation = true}).statement.find("root_1_squared") == std::string::npos);
    CHECK(certificate(left, right, {.divisor = true}).statement.find("divisor_1_not_zero") == std::string::npos);
    for (const LeftOut& left_out : {LeftOut{.relation = true}, LeftOut{.divisor = true}})
        check_refused(certificate(left, right, left_out));
}

TEST_CASE("what a proof does without cannot be left out of it", "[kernel]") {
    // the sides are the same polynomial once the quotient is cleared: no relation is used, and nothing divides
    const ex s = GiNaC::sin(theta()), c = GiNaC::cos(theta());
    const Certificate sums = certificate((s + c) * (s - c), s * s - c * c, {.relation = true, .divisor = true});
    CHECK(sums.holds);
    CHECK_FALSE(sums.lacks);
    CHECK_FALSE(certificate(s * s + c * c, 1).lacks);
    CHECK(certificate(s * s + c * c, 1, {.relation = true}).lacks);
}

TEST_CASE("sums and multiples of angles are taken apart before the kernel's eyes", "[kernel]") {
    const ex phi = symbols().phi_j, half = theta() / 2;
    const Certificate c =
        certificate(GiNaC::sin(theta() + phi - GiNaC::Pi / 2), 2 * GiNaC::sin(phi) * GiNaC::sin(half) * GiNaC::cos(half) -
                                                                   GiNaC::cos(phi) * (2 * GiNaC::pow(GiNaC::cos(half), 2) - 1));
    CHECK(c.holds);
    CHECK_FALSE(c.in_functions.empty());
    check_accepted(c);
}

TEST_CASE("a root of a product and a sum in an angle that shows by squares are proved; a wrong sign or factor is refused",
          "[kernel]") {
    const ex z = zeta(), product = GiNaC::sqrt((1 + z) * (1 - z));
    const auto angle = [&](int sign) { return GiNaC::Pi * (1 - sign * z * z / (1 + w())) / R(); };
    const Certificate c = certificate(product * GiNaC::cos(angle(1)), w() * GiNaC::cos(theta()));
    CHECK(c.holds);
    CHECK_FALSE(c.in_functions.empty());
    const Certificate wrong = certificate(product * GiNaC::cos(angle(-1)), w() * GiNaC::cos(theta()));
    CHECK_FALSE(wrong.holds);
    CHECK(wrong.in_functions.empty());
    if (!coq_is_there()) return;
    CHECK(said_of(c).message == "");
    const std::string value = " = (sqrt (1 - zeta ^ 2))) by (apply root_is";
    const std::size_t at = c.in_functions.find(value);
    REQUIRE(at != std::string::npos);
    for (const char* altered :
         {" = (- sqrt (1 - zeta ^ 2))) by (apply root_is", " = (2 * sqrt (1 - zeta ^ 2))) by (apply root_is"}) {
        Certificate twin = c;
        twin.in_functions.replace(at, value.size(), altered);
        const Compiled said = said_of(twin);
        CHECK_FALSE(said.accepted);
        CHECK(can_be_read(said.message));
    }
}

TEST_CASE("the record says for how many lemmas of a claim the functions are not stated, and why", "[kernel]") {
    const nlohmann::json stated{{"in_functions", "Lemma"}, {"why_no_functions", ""}};
    const nlohmann::json point{{"in_functions", ""}, {"why_no_functions", "the angle of a point"}};
    const nlohmann::json polynomial{{"in_functions", ""}, {"why_no_functions", ""}};
    CHECK(why_not_in_functions({{"lemmas", {stated}}}) == "");
    CHECK(why_not_in_functions({{"lemmas", {stated, point, polynomial, point}}}) == "2 of 4: the angle of a point");
}

TEST_CASE("quotients within quotients are cleared, and each divisor is named once whatever its sign", "[kernel]") {
    const ex a = symbols().U_k, b = symbols().U_j;
    const Certificate c = certificate(1 / (1 + a / (R() + b)) + a / (a - b) + b / (b - a), (R() + b) / (R() + a + b) + 1);
    CHECK(c.holds);
    CHECK(c.statement.find("divisor_3") != std::string::npos);
    CHECK(c.statement.find("divisor_4") == std::string::npos);
    check_accepted(c);
}

TEST_CASE("an expression reads the same in Coq however it was put together", "[kernel]") {
    const ex a = symbols().tau, b = symbols().mu;
    CHECK(coq_text(b - 3 * a * a / (2 * b)) == "mu - 3 * tau ^ 2 / (2 * mu)");
    CHECK(coq_text(-3 * a * a / (2 * b) + b) == "mu - 3 * tau ^ 2 / (2 * mu)");
    CHECK(coq_text(-a) == "- tau");
    CHECK(coq_text(1 / GiNaC::sqrt(a)) == "1 / sqrt (tau)");
    CHECK(coq_text(GiNaC::cos(GiNaC::Pi * R())) == "cos (PI * R_)");
    CHECK_THROWS_AS(coq_text(GiNaC::I * a), std::domain_error);
}

TEST_CASE("names that the real numbers of Coq have already are not taken", "[kernel]") {
    CHECK(coq_name("R") == "R_");
    CHECK(coq_name("R1") == "R_1");
    CHECK(coq_name("zeta") == "zeta");
    CHECK(coq_name("psi_11'") == "psi_11_");
    CHECK(coq_comment("f(*) is \"so\"") == "f( * ) is 'so'");
}

TEST_CASE("only a tactic that finds no proof counts as a rejection", "[kernel]") {
    CHECK(finds_no_proof("Error: Tactic failure: not a valid ring equation."));
    CHECK_FALSE(finds_no_proof("Error: Syntax error: '.' expected after [gallina] (in [vernac_aux])."));
    CHECK_FALSE(finds_no_proof("longer than two minutes"));
    CHECK(can_be_read("longer than two minutes"));
    CHECK(can_be_read("Error: Tactic failure: not a valid field equation."));
    CHECK_FALSE(can_be_read("Error: Syntax error: [bindings] expected after 'with' (in [simple_tactic])."));
    CHECK_FALSE(can_be_read("Error: The reference same_sides was not found in the current environment."));
}
