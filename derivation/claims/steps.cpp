// Lines of a derivation: LaTeX that the run makes of its expressions.
#include "derivation/algebra/symbols.hpp"
#include "derivation/typeset/latex.hpp"
#include "derivation/typeset/readable.hpp"

namespace denhartog::derivation {

std::string latex(const GiNaC::ex& e) { return latex_line(readable(e)); }

Step step(const std::string& text, const std::string& left, const GiNaC::ex& right) {
    return {text, latex_equation(left, readable(right))};
}

} // namespace denhartog::derivation
