// LaTeX of expressions: known expressions give known text; a form in groups is taken only where it is proved; two runs write the
// same bytes.
#include "derivation/typeset/latex.hpp"

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <unistd.h>

#include "derivation/algebra/symbols.hpp"
#include "derivation/claims/claim.hpp"
#include "derivation/paper/derived.hpp"
#include "derivation/typeset/readable.hpp"
#include "derivation/typeset/typeset.hpp"
#include "tests/catch.hpp"

using namespace denhartog::derivation;
using GiNaC::ex;
using GiNaC::numeric;

namespace {

/// Claims whose steps are compared from run to run: of one mode, of two, with matrices, refuted ones.
const std::vector<std::string> compared{"A.5/constants", "A.7/printed",  "A.13/cosine", "23/complex-response", "38/amplitude",
                                        "46/printed",    "57/integrand", "42/mass/N=2", "17/orthonormal/N=2"};

std::string output_of_this_program(const std::string& arguments) {
    std::FILE* pipe = ::popen(("/proc/" + std::to_string(::getpid()) + "/exe " + arguments).c_str(), "r");
    REQUIRE(pipe != nullptr);
    std::string output;
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) output += static_cast<char>(c);
    REQUIRE(::pclose(pipe) == 0);
    return output.substr(0, output.find("====="));
}

} // namespace

TEST_CASE("known expressions have known LaTeX", "[latex]") {
    const Symbols& s = symbols();
    CHECK(latex_line(s.beta * s.psi_ji * s.R * s.R * s.g) == "\\psi_{ji}R_i^2g_i\\beta");
    CHECK(latex_line(-s.tau + s.beta) == "\\beta - \\tau");
    CHECK(latex_line(-s.tau - s.beta) == "-\\beta - \\tau");
    CHECK(latex_line(s.beta / 2) == "\\frac{\\beta}{2}");
    CHECK(latex_line(s.beta / (2 * s.R)) == "\\frac{\\beta}{2R_i}");
    CHECK(latex_line(numeric(-1, 3)) == "-\\frac{1}{3}");
    CHECK(latex_line(cos(s.tau / s.R) * s.beta) == "\\beta\\cos\\frac{\\tau}{R_i}");
    CHECK(latex_line(pow(sin(s.tau + s.phi_j), 2)) == "\\sin^2\\left(\\tau + \\phi_j\\right)");
    CHECK(latex_line(exp(-s.zeta * s.tau / s.R)) == "e^{-\\zeta_i\\tau/R_i}");
    CHECK(latex_line(sqrt(1 - s.zeta * s.zeta)) == "\\sqrt{1 - \\zeta_i^2}");
    CHECK(latex_line(GiNaC::abs(s.psi_ji - s.psi_li)) == "\\left|\\psi_{ji} - \\psi_{li}\\right|");
    CHECK(latex_line(atan2(s.V_ji, s.V_jr)) == "\\operatorname{atan2}\\left(V_{ji},\\,V_{jr}\\right)");
    CHECK(latex_line(-s.psi_ji * (s.beta - cos(s.tau))) == "\\psi_{ji}\\left(\\cos\\tau - \\beta\\right)");
    CHECK(latex_line(pow(s.c_phi, 2) + pow(s.eta_prime_0, 2)) == "{\\eta'_{i0}}^2 + \\cos^2\\phi_j");
}

TEST_CASE("the derivation's expressions take the paper's form", "[latex]") {
    const auto latex = [](const ex& e) { return latex_line(readable(e)); };
    CHECK(latex(derived_complex_response().first) == "\\frac{1 - R_i^2}{4\\zeta_i^2R_i^2 + \\left(1 - R_i^2\\right)^2}");
    CHECK(latex(derived_constants().first) == "\\eta_{i0} - \\psi_{ji}R_i^2\\beta - \\psi_{li}R_i^2[v_{di}\\cos\\phi_j]");
    CHECK(
        latex(derived_first_damping_function()) ==
        "\\frac{\\sin\\frac{\\pi w_i}{R_i}}{R_iw_i\\left(\\cosh\\frac{\\pi\\zeta_i}{R_i} + \\cos\\frac{\\pi w_i}{R_i}\\right)}");
    const std::string displacement = latex(derived_modal_displacement());
    CHECK(displacement.find("u_{di}\\left(\\sin\\tau - R_iq_i(\\tau)\\right)") != std::string::npos);
    CHECK(legend_of(displacement).find("w_i &= \\sqrt{1 - \\zeta_i^2}") != std::string::npos);
    CHECK(legend_of("\\eta_i").empty());
}

TEST_CASE("a form in groups stands for its expression, an altered one does not", "[latex]") {
    const Symbols& s = symbols();
    for (const ex& e :
         {derived_general_solution(), derived_constants().second, derived_displacement(), derived_final_conditions().second,
          derived_phase().first, derived_phase().second, derived_modal_displacement()}) {
        const ex form = readable(e);
        CAPTURE(latex_line(form));
        CHECK(stands_for(form, e));
        CHECK_FALSE(form.is_equal(e));
        CHECK_FALSE(stands_for(form + 1, e));
        CHECK_FALSE(stands_for(-form, e));
        for (const Group& group : groups())
            if (form.has(group.symbol)) CHECK_FALSE(stands_for(form.subs(group.symbol == 2 * group.symbol), e));
        CHECK_FALSE(stands_for(form.subs(s.R == 2 * s.R), e));
    }
}

TEST_CASE("a wide sum is broken into lines, a narrow one is not", "[latex]") {
    const Symbols& s = symbols();
    ex sum = 0;
    for (int k = 1; k <= 12; ++k) sum += pow(s.R, k) * s.eta_0 * s.beta;
    const std::string wide = latex_equation("\\eta", sum);
    CHECK(wide.starts_with("\\begin{aligned} \\eta ={}& "));
    CHECK(wide.find(" \\\\ & + ") != std::string::npos);
    CHECK(latex_equation("x", s.R + s.beta) == "x = R_i + \\beta");
    CHECK(visible_width("\\frac{\\cos\\tau}{R_i^2}") < visible_width("\\cos\\tau+R_i"));
    CHECK(plain_sentence("the rate $\\eta_i'$ at $\\tau=0$, over $\\psi_{ji}R_i^2\\beta$, is $\\frac{1}{R_i}$") ==
          "the rate eta_i' at tau=0, over psi_ji R_i^2 beta, is 1/R_i");
}

TEST_CASE("the steps of some claims are printed", "[.print-steps]") {
    for (const Claim& claim : claims()) {
        if (std::find(compared.begin(), compared.end(), claim.id) == compared.end()) continue;
        std::cout << claim.id << "\n";
        for (const Step& step : decide(claim).steps) std::cout << step.text << "\n" << step.latex << "\n";
    }
    SUCCEED();
}

TEST_CASE("two runs write the same steps", "[latex]") {
    const std::string first = output_of_this_program("[.print-steps]"), second = output_of_this_program("[.print-steps]");
    CHECK(first.find("[v_{di}\\cos\\phi_j]") != std::string::npos);
    CHECK(first == second);
}
