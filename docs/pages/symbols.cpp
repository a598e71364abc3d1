#include "symbols.hpp"

#include <cctype>
#include <set>
#include <sstream>

#include "denhartog/ledger/ledger_entry.hpp"
#include "denhartog/number/errors.hpp"
#include "derivation/ledger/source_text.hpp"
#include "text.hpp"

namespace denhartog::pages {

namespace {

std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream in(line.substr(1));
    for (std::string cell; std::getline(in, cell, '|');) {
        const std::size_t first = cell.find_first_not_of(' ');
        cells.push_back(first == std::string::npos ? "" : cell.substr(first, cell.find_last_not_of(' ') - first + 1));
    }
    return cells;
}

void replace_all(std::string& text, const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

/// The spelling of the ledger: a group round each argument.
std::string with_groups(std::string latex) {
    for (const char* command : {"\\overline", "\\mathbf", "\\dot"}) {
        const std::string from = std::string(command) + " ";
        for (std::size_t at = latex.find(from); at != std::string::npos; at = latex.find(from)) {
            const char letter = latex[at + from.size()];
            latex.replace(at, from.size() + 1, std::string(command) + "{" + letter + "}");
        }
    }
    replace_all(latex, "\\boldsymbol\\Psi", "\\boldsymbol{\\Psi}");
    replace_all(latex, "'", "");
    return latex;
}

/// The same symbol of another mass: psi_ki, psi_ji, psi_li; G_k, G_j.
std::vector<std::string> of_other_masses(const std::string& latex) {
    std::vector<std::string> all{latex};
    const std::size_t index = latex.rfind('_');
    if (index == std::string::npos) return all;
    for (const char mass : {'k', 'j'}) {
        const std::size_t at = latex.find(mass, index);
        if (at == std::string::npos || latex.find("lim", index) != std::string::npos) continue;
        for (const char other : {'k', 'j', 'l'}) {
            std::string name = latex;
            name[at] = other;
            if (other != mass) all.push_back(name);
        }
        break;
    }
    return all;
}

std::vector<std::string> formulas_of(const std::string& cell) {
    std::vector<std::string> formulas;
    for (std::size_t at = cell.find('$'); at != std::string::npos; at = cell.find('$', at)) {
        const std::size_t end = cell.find('$', at + 1);
        formulas.push_back(cell.substr(at + 1, end - at - 1));
        at = end + 1;
    }
    return formulas;
}

std::vector<std::string> equations_of(const std::string& cell) {
    std::vector<std::string> numbers;
    for (std::size_t at = cell.find('('); at != std::string::npos; at = cell.find('(', at + 1)) {
        const auto number = ledger::equation_number(cell.substr(at + 1, cell.find(')', at) - at - 1));
        if (number) numbers.push_back(*number);
    }
    return numbers;
}

bool stands_in(const std::string& latex, const std::string& name) {
    for (std::size_t at = latex.find(name); at != std::string::npos; at = latex.find(name, at + 1)) {
        const char before = at == 0 ? ' ' : latex[at - 1],
                   after = at + name.size() < latex.size() ? latex[at + name.size()] : ' ';
        const bool letter = std::isalpha(static_cast<unsigned char>(name[0])) != 0;
        if (letter &&
            (std::isalpha(static_cast<unsigned char>(before)) != 0 || before == '\\' || before == '_' || before == '{')) {
            if (before != '{' || name.size() < 3) continue;
        }
        const bool ends = std::isalpha(static_cast<unsigned char>(name.back())) != 0;
        if (ends && (std::isalpha(static_cast<unsigned char>(after)) != 0 || after == '_')) continue;
        return true;
    }
    return false;
}

} // namespace

std::vector<Symbol> read_symbols(const std::filesystem::path& notation) {
    std::istringstream in(derivation::text_of(notation));
    std::vector<Symbol> symbols;
    for (std::string line; std::getline(in, line) && line != "## Symbols of ours";) {
        if (!line.starts_with("| $")) continue;
        const std::vector<std::string> cells = cells_of(line);
        if (cells.size() < 4) throw InputError("a symbol", "must have its meaning and its equation", line, notation.string());
        for (const std::string& formula : formulas_of(cells[0])) {
            const std::string latex = with_groups(formula);
            if (latex.empty() || latex == "j" || latex == "l" || latex == "t") continue;
            symbols.push_back({of_other_masses(latex), cells[2], equations_of(cells[3]), cells.size() > 4 ? cells[4] : ""});
        }
    }
    if (symbols.empty()) throw InputError("the notation page", "must have tables of symbols", notation.string());
    return symbols;
}

std::vector<const Symbol*> symbols_in(const std::vector<Symbol>& symbols, const std::string& latex) {
    std::vector<const Symbol*> found;
    std::set<std::string> meanings;
    for (const Symbol& symbol : symbols)
        for (const std::string& name : symbol.latex)
            if (stands_in(latex, name)) {
                if (meanings.insert(symbol.meaning).second) found.push_back(&symbol);
                break;
            }
    return found;
}

std::string symbols_as_json(const std::vector<Symbol>& symbols) {
    ledger::Json all = ledger::Json::array();
    for (const Symbol& symbol : symbols) {
        std::string meaning = html(symbol.meaning);
        for (bool open = true; meaning.find('$') != std::string::npos; open = !open)
            meaning.replace(meaning.find('$'), 1, open ? "\\(" : "\\)");
        for (bool open = true; meaning.find('`') != std::string::npos; open = !open)
            meaning.replace(meaning.find('`'), 1, open ? "<code>" : "</code>");
        all.push_back({{"latex", symbol.latex}, {"meaning", meaning}, {"units", symbol.units}, {"equations", symbol.equations}});
    }
    return all.dump(0) + "\n";
}

} // namespace denhartog::pages
