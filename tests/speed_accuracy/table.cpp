#include "tests/speed_accuracy/table.hpp"

namespace denhartog::tests {
namespace {

std::string line(const std::vector<std::string>& cells) {
    std::string text = "|";
    for (const std::string& cell : cells) text += " " + cell + " |";
    return text + "\n";
}

} // namespace

std::string markdown(const Table& t) {
    std::string text = "## " + t.title + "\n\n" + line(t.head) + line(std::vector<std::string>(t.head.size(), "---"));
    for (const std::vector<std::string>& row : t.rows) text += line(row);
    return text + "\n" + (t.note.empty() ? "" : t.note + "\n\n");
}

} // namespace denhartog::tests
