// The formulas that the pages of equations offer as code.
#include "denhartog/formulas/mode.hpp"
#include "derivation/offers/formula_list.hpp"
#include "tests/catch.hpp"

using namespace denhartog;
using namespace denhartog::offers;

namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

} // namespace

TEST_CASE("a formula that is written down is the one that runs, in each language", "[pages]") {
    const Written R = Written::symbol("R"), zeta = Written::symbol("zeta");
    const WrittenFormula u{"u", {"R", "zeta"}, {}, {paper::first_damping_function(R, zeta)}};
    CHECK(code_of(u, Language::python) == "def u(R, zeta):\n    w = np.sqrt(1 - zeta * zeta)\n    theta = np.pi * w / R\n"
                                          "    return np.sin(theta) / (R * w * (np.cosh(np.pi * zeta / R) + np.cos(theta)))\n");
    CHECK(has(code_of(u, Language::matlab), "theta = pi .* w ./ R;"));
    const WrittenFormula order{
        "f", {"a", "b"}, {}, {Written::symbol("a") - (Written::symbol("b") - 1) * (-Written::symbol("a"))}};
    CHECK(has(code_of(order, Language::cxx), "return a - (b - 1) * (-a);"));
    const WrittenFormula sum{"s", {"x"}, {"x"}, {2 * Written::sum_over_modes(Written::symbol("x") * Written::symbol("x"))}};
    CHECK(has(code_of(sum, Language::python), "2 * np.sum(x * x)"));
    CHECK(has(code_of(sum, Language::javascript), "sum += x[i] * x[i];"));
}
