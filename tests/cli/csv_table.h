// Tables that the program writes, for tests.
#pragma once

#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "tests/cli/program.h"

namespace hottel::testing_cli {

inline std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

// The lines of a csv without names in quotes, by what stands in their first cells.
inline std::map<std::string, std::vector<std::string>> table(const std::string& csv, std::size_t keys) {
  std::map<std::string, std::vector<std::string>> rows;
  for (const std::string& line : lines_of(csv)) {
    const std::vector<std::string> cells = cells_of(line);
    std::string key = cells[0];
    for (std::size_t k = 1; k < keys; ++k) key += "," + cells[k];
    rows[key] = cells;
  }
  return rows;
}

}  // namespace hottel::testing_cli
