// Reads the pack and says of each scene how far the contact goes at the 64 instants: c++ -std=c++17 read.cpp && ./a.out FOLDER
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>
#include <vector>

using Row = std::map<std::string, std::string>; // a cell by its column

std::vector<Row> table(const std::string& path) {
    std::ifstream file(path);
    std::vector<std::vector<std::string>> lines;
    for (std::string line; std::getline(file, line);) {
        std::istringstream cells(line);
        for (lines.emplace_back(); std::getline(cells, line, ',');) lines.back().push_back(line);
    }
    std::vector<Row> rows(lines.size() - 1);
    for (std::size_t n = 1; n < lines.size(); ++n)
        for (std::size_t k = 0; k < lines[n].size(); ++k) rows[n - 1][lines[0][k]] = lines[n][k];
    return rows;
}

// The largest size of a list of numbers with spaces between them.
double largest(const std::string& list) {
    std::istringstream numbers(list);
    double most = 0;
    for (double x = 0; numbers >> x;) most = std::fmax(most, std::fabs(x));
    return most;
}

int main(int, char** argv) {
    const std::string folder = argv[1];
    auto scenes = table(folder + "/scenes.csv"), samples = table(folder + "/samples.csv"), events = table(folder + "/events.csv");
    for (Row& s : scenes) { // lists have spaces: s["m"], s["k"], s["c"], s["c_ground"], s["amplitude"]
        double x = 0, v = 0, stops = 0;
        for (Row& row : samples) // at t = (0, ..., 63) * period / 64
            if (row["scene"] == s["scene"] && row["mass"] == s["contact"]) x = largest(row["x"]), v = largest(row["v"]);
        for (Row& event : events) stops += event["scene"] == s["scene"] && event["what"] == "stops";
        std::printf("%s %s %s %g %.17g %.17g\n", s["scene"].c_str(), s["masses"].c_str(), s["regime"].c_str(), stops, x, v);
    }
}
