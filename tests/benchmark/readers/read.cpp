// Reads the pack and says of each scene how far the contact goes at the 64 instants: c++ -std=c++17 read.cpp && ./a.out FOLDER
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <vector>

using Row = std::map<std::string, std::string>;

std::vector<Row> table(const std::string& path) {
    std::ifstream file(path);
    std::vector<std::string> names;
    std::vector<Row> rows;
    for (std::string line, cell; std::getline(file, line);) {
        std::istringstream cells(line);
        Row row;
        for (std::size_t n = 0; std::getline(cells, cell, ','); ++n)
            if (rows.empty() && names.size() == n) names.push_back(cell); // the first line
            else row[names.at(n)] = cell;
        if (!row.empty()) rows.push_back(row);
    }
    return rows;
}

int main(int, char** argv) {
    const std::string folder = argv[1];
    const auto samples = table(folder + "/samples.csv"), events = table(folder + "/events.csv");
    for (Row& s : table(folder + "/scenes.csv")) { // lists have spaces: s["m"], s["k"], s["c"], s["c_ground"], s["amplitude"]
        double x = 0, v = 0;
        int stops = 0;
        for (Row row : samples)
            if (row["scene"] == s["scene"] && row["mass"] == s["contact"])
                x = std::fmax(x, std::fabs(std::atof(row["x"].c_str()))), v = std::fmax(v, std::fabs(std::atof(row["v"].c_str())));
        for (Row event : events) stops += event["scene"] == s["scene"] && event["what"] == "stops";
        std::printf("%s %s %s %d %.17g %.17g\n", s["scene"].c_str(), s["masses"].c_str(), s["regime"].c_str(), stops, x, v);
    }
}
