// Every format that is written, byte for byte, and read back by code that knows only the format.
//
// The golden files are in tests/contract/; tests/contract/regenerate makes them anew.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tests/cli/program.h"

namespace hottel::golden_files_test {
namespace {

using testing_cli::contents;
using testing_cli::lines_of;
using testing_cli::Outcome;
using testing_cli::Workplace;
namespace fs = std::filesystem;

const fs::path kGolden = fs::path(HOTTEL_SOURCE_DIR) / "tests/contract";

std::string golden(const std::string& name) { return contents(kGolden / name); }

TEST(GoldenFiles, AreWhatTheProgramWrites) {
  const Workplace place;
  const Outcome outcome =
      place.run("sh '" + (kGolden / "regenerate").string() + "' '" + std::string(HOTTEL_PROGRAM) + "' .");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  std::size_t compared = 0;
  for (const auto& entry : fs::directory_iterator(kGolden)) {
    const std::string name = entry.path().filename().string();
    if (name == "regenerate") continue;
    EXPECT_TRUE(place.read(name) == contents(entry.path())) << name << " differs";
    ++compared;
  }
  EXPECT_EQ(compared, place.files().size()) << "a file is written that has no golden one";
}

// Fields of csv as RFC 4180 has them.
std::vector<std::vector<std::string>> read_csv(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> row(1);
  bool is_quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (is_quoted) {
      if (c != '"')
        row.back() += c;
      else if (i + 1 < text.size() && text[i + 1] == '"')
        row.back() += text[++i];
      else
        is_quoted = false;
    } else if (c == '"') {
      is_quoted = true;
    } else if (c == ',') {
      row.emplace_back();
    } else if (c == '\n') {
      rows.push_back(std::move(row));
      row.assign(1, "");
    } else {
      row.back() += c;
    }
  }
  return rows;
}

using Entries = std::map<std::pair<std::size_t, std::size_t>, double>;

struct Names {
  std::map<std::string, std::size_t> index;  // from 1
  std::size_t sky = 0;
};

Names face_names() {
  Names names;
  for (const auto& row : read_csv(golden("factors.mtx.faces.csv")))
    if (row[0] != "index") names.index[row[1]] = std::stoul(row[0]);
  names.sky = names.index.at("sky");
  return names;
}

// What factors.csv says, by the indices of factors.mtx.faces.csv.
Entries entries_of_csv() {
  const Names names = face_names();
  Entries entries;
  for (const auto& row : read_csv(golden("factors.csv")))
    if (row[0] != "from") entries[{names.index.at(row[0]), names.index.at(row[1])}] = std::stod(row[2]);
  return entries;
}

TEST(GoldenFiles, CsvQuotesNamesAsRfc4180) {
  const auto rows = read_csv(golden("factors.csv"));
  EXPECT_EQ(rows.front(),
            (std::vector<std::string>{"from", "to", "factor", "lower", "upper", "visibility", "guarantee"}));
  for (const auto& row : rows) EXPECT_EQ(row.size(), 7u);
  EXPECT_EQ(rows.at(1).at(1), "screen, \"thin\":back");
  EXPECT_EQ(golden("factors.csv").find('\r'), std::string::npos);
}

TEST(GoldenFiles, FacesAreNumberedFromOneWithTheSkyLast) {
  const auto rows = read_csv(golden("factors.mtx.faces.csv"));
  EXPECT_EQ(rows.front(),
            (std::vector<std::string>{"index", "face", "element", "area", "material", "x0", "y0", "x1", "y1"}));
  for (std::size_t k = 1; k < rows.size(); ++k) EXPECT_EQ(rows[k].at(0), std::to_string(k));
  EXPECT_EQ(rows.back().at(1), "sky");
  EXPECT_EQ(rows.size(), 1u + 2 * 8 + 1);  // fronts and backs of eight surfaces, and the sky
}

TEST(GoldenFiles, MatrixMarketHoldsTheFactorsOfTheCsv) {
  const auto lines = lines_of(golden("factors.mtx"));
  ASSERT_EQ(lines.at(0), "%%MatrixMarket matrix coordinate real general");
  std::size_t k = 1;
  while (lines.at(k).starts_with("%")) ++k;
  std::size_t rows = 0, columns = 0, count = 0;
  std::istringstream(lines.at(k++)) >> rows >> columns >> count;
  EXPECT_EQ(rows, face_names().sky);
  EXPECT_EQ(columns, face_names().sky);
  EXPECT_EQ(count, lines.size() - k);
  Entries entries;
  for (; k < lines.size(); ++k) {
    std::size_t from = 0, to = 0;
    double factor = 0;
    std::istringstream(lines[k]) >> from >> to >> factor;
    entries[{from, to}] = factor;
  }
  EXPECT_EQ(entries, entries_of_csv());
}

Entries nonzero(const std::vector<double>& dense, std::size_t n) {
  Entries entries;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      if (dense[i * n + j] != 0) entries[{i + 1, j + 1}] = dense[i * n + j];
  return entries;
}

template <class Number>
std::vector<Number> numbers_from(const std::string& bytes, std::size_t offset) {
  std::vector<Number> numbers((bytes.size() - offset) / sizeof(Number));
  std::memcpy(numbers.data(), bytes.data() + offset, numbers.size() * sizeof(Number));
  return numbers;
}

TEST(GoldenFiles, NumPyHoldsTheFactorsOfTheCsv) {
  const std::string bytes = golden("factors.npy");
  ASSERT_TRUE(bytes.starts_with(std::string("\x93NUMPY\x01\x00", 8)));
  const std::size_t length = static_cast<unsigned char>(bytes[8]) + 256u * static_cast<unsigned char>(bytes[9]);
  EXPECT_EQ((10 + length) % 64, 0u);
  const std::string header = bytes.substr(10, length);
  const std::size_t n = face_names().sky;
  const std::string shape = "(" + std::to_string(n) + ", " + std::to_string(n) + ")";
  EXPECT_TRUE(header.starts_with("{'descr': '<f8', 'fortran_order': False, 'shape': " + shape + ", }")) << header;
  EXPECT_EQ(header.back(), '\n');
  ASSERT_EQ(bytes.size(), 10 + length + 8 * n * n);
  EXPECT_EQ(nonzero(numbers_from<double>(bytes, 10 + length), n), entries_of_csv());
}

// The light is what the cells see, times radiosities and the sky's emission, which is 0 here.
TEST(GoldenFiles, ViewsTimesRadiositiesIsTheLight) {
  const std::string bytes = golden("illumination.npy");
  const std::size_t length = static_cast<unsigned char>(bytes[8]) + 256u * static_cast<unsigned char>(bytes[9]);
  const std::vector<double> light = numbers_from<double>(bytes, 10 + length);
  std::map<std::pair<std::string, std::string>, std::vector<double>> radiosity;  // by face and element, the channels
  for (const auto& row : read_csv(golden("radiosity.csv")))
    if (row[0] != "face") radiosity[{row[0], row[1]}].push_back(std::stod(row[6]));
  const std::size_t channels = radiosity.begin()->second.size();
  const auto faces = read_csv(golden("views.mtx.faces.csv"));
  const auto lines = lines_of(golden("views.mtx"));
  ASSERT_EQ(lines.at(0), "%%MatrixMarket matrix coordinate real general");
  std::size_t k = 1;
  while (lines.at(k).starts_with("%")) ++k;
  std::size_t rows = 0, columns = 0, count = 0;
  std::istringstream(lines.at(k++)) >> rows >> columns >> count;
  EXPECT_EQ(rows * channels, light.size());
  EXPECT_EQ(columns, faces.size() - 1);
  EXPECT_EQ(count, lines.size() - k);
  std::vector<double> product(light.size(), 0), sum(rows, 0);
  for (; k < lines.size(); ++k) {
    std::size_t row = 0, column = 0;
    double fraction = 0;
    std::istringstream(lines[k]) >> row >> column >> fraction;
    sum.at(row - 1) += fraction;
    const auto found = radiosity.find({faces.at(column).at(1), faces.at(column).at(2)});
    if (found == radiosity.end()) continue;
    for (std::size_t c = 0; c < channels; ++c) product[(row - 1) * channels + c] += fraction * found->second[c];
  }
  for (std::size_t i = 0; i < light.size(); ++i) {
    EXPECT_NEAR(sum[i / channels], std::isnan(light[i]) ? 0 : 1, 1e-15);
    if (!std::isnan(light[i])) {
      EXPECT_NEAR(product[i], light[i], 1e-14 * (1 + light[i])) << i;
    }
  }
}

// A View3D result: areas, factors and emittances of the faces that radiate, as one list of numbers.
void expect_view3d(const std::vector<double>& numbers, std::size_t count, double relative) {
  std::vector<std::size_t> radiating;
  std::vector<double> expected;
  for (const auto& row : read_csv(golden("factors.mtx.faces.csv")))
    if (row[0] != "index" && !row[4].empty()) {
      radiating.push_back(std::stoul(row[0]));
      expected.push_back(std::stod(row[3]));
    }
  ASSERT_EQ(count, radiating.size());
  const Entries factors = entries_of_csv();
  for (const std::size_t from : radiating)
    for (const std::size_t to : radiating) {
      const auto found = factors.find({from, to});
      expected.push_back(found == factors.end() ? 0 : found->second);
    }
  for (const auto& row : read_csv(golden("factors.mtx.faces.csv")))
    if (!row[4].empty() && row[0] != "index")
      expected.push_back(row[4] == "lamp" ? 0.9 : row[4] == "white" ? 0.3 : 0.5);
  ASSERT_EQ(numbers.size(), expected.size());
  for (std::size_t k = 0; k < numbers.size(); ++k)
    EXPECT_NEAR(numbers[k], expected[k], relative * expected[k]) << "number " << k;
}

TEST(GoldenFiles, View3dTextHoldsTheFactorsOfTheCsv) {
  const std::string text = golden("factors.txt");
  EXPECT_EQ(text.find('\n'), 30u);  // the header is padded
  std::istringstream in(text);
  std::string program, version;
  int out = -1, enclosure = -1, emittances = -1;
  std::size_t count = 0;
  in >> program >> version >> out >> enclosure >> emittances >> count;
  EXPECT_EQ(program + " " + version, "View3D 4.0.0");
  EXPECT_EQ(std::make_pair(out, enclosure), std::make_pair(0, 0));
  EXPECT_EQ(emittances, 0);
  std::vector<double> numbers;
  for (double number; in >> number;) numbers.push_back(number);
  expect_view3d(numbers, count, 0);
  const auto lines = lines_of(text);
  ASSERT_EQ(lines.size(), 1 + 1 + count + 1);
}

TEST(GoldenFiles, View3dBinaryHoldsTheFactorsOfTheCsv) {
  const std::string bytes = golden("factors.bin");
  const std::string header = bytes.substr(0, 32);
  EXPECT_TRUE(header.starts_with("View3D 4.0.0 1 0 0 "));
  EXPECT_TRUE(header.ends_with("\r\n"));
  const std::vector<float> numbers = numbers_from<float>(bytes, 32);
  expect_view3d({numbers.begin(), numbers.end()}, std::stoul(header.substr(19)), 6e-8);
}

TEST(GoldenFiles, DenseMatricesHaveNamesInTheFirstRowAndColumn) {
  const Entries factors = entries_of_csv();
  for (const std::string name : {"matrix_factor.csv", "matrix_exchange.csv", "matrix_visibility.csv"}) {
    const auto rows = read_csv(golden(name));
    const std::size_t n = face_names().sky;
    ASSERT_EQ(rows.size(), n + 1);
    for (std::size_t i = 0; i <= n; ++i) {
      ASSERT_EQ(rows[i].size(), n + 1);
      EXPECT_EQ(rows[i][0], rows[0][i]);
      if (i == 0) continue;
      EXPECT_EQ(face_names().index.at(rows[i][0]), i);
      for (std::size_t j = 1; j <= n; ++j) {
        const auto found = factors.find({i, j});
        if (found == factors.end())
          EXPECT_TRUE(rows[i][j] == "0" || (rows[i][j] == "NaN" && name == "matrix_visibility.csv"));
        else if (name == "matrix_factor.csv")
          EXPECT_EQ(std::stod(rows[i][j]), found->second);
        else
          EXPECT_GT(std::stod(rows[i][j]), 0);
      }
    }
  }
}

// ---- in space

TEST(GoldenFilesOfSpace, FacesHaveTheirCorners) {
  const auto rows = read_csv(golden("space_factors_element.mtx.faces.csv"));
  EXPECT_EQ(rows.front(), (std::vector<std::string>{"index", "face", "element", "area", "material", "points"}));
  for (std::size_t k = 1; k + 1 < rows.size(); ++k) {
    EXPECT_EQ(rows[k].at(0), std::to_string(k));
    std::istringstream in(rows[k].at(5));
    std::size_t corners = 0;
    for (std::string corner; std::getline(in, corner, ';'); ++corners) {
      std::istringstream numbers(corner);
      double x = 0, y = 0, z = 0;
      EXPECT_TRUE(numbers >> x >> y >> z) << corner;
    }
    EXPECT_GE(corners, 3u) << rows[k].at(1);
  }
  EXPECT_EQ(rows.back().at(1), "sky");
  EXPECT_EQ(rows.back().at(5), "");
  EXPECT_EQ(rows.size(), 1u + 2 * 7 + 3 + 1);  // fronts and backs of seven surfaces, one front in four, and the sky
}

// By rows of a list of factors: their sums. Eight places are kept.
void expect_rows_close(const std::string& name) {
  std::map<std::string, double> sums;
  for (const auto& row : read_csv(golden(name))) {
    ASSERT_EQ(row.size(), 7u);
    if (row[0] == "from") continue;
    const double factor = std::stod(row[2]);
    EXPECT_TRUE(std::stod(row[3]) <= factor && factor <= std::stod(row[4]));
    EXPECT_TRUE(row[6] == "enclosed" || row[6] == "estimated" || (row[6] == "exact" && factor == 0));
    sums[row[0]] += factor;
  }
  for (const auto& [from, sum] : sums) EXPECT_NEAR(sum, 1, 2e-7) << name << " " << from;
}

TEST(GoldenFilesOfSpace, RowsSumToOne) {
  for (const char* name :
       {"space_factors.csv", "space_factors_facing.csv", "space_factors_element.csv", "space_factors_group.csv"})
    expect_rows_close(name);
}

TEST(GoldenFilesOfSpace, FacingAddsWhatIsHidden) {
  const auto visible = read_csv(golden("space_factors.csv")), facing = read_csv(golden("space_factors_facing.csv"));
  std::size_t k = 0, hidden = 0;
  for (const auto& row : facing) {
    if (k < visible.size() && row == visible[k]) {
      ++k;
      continue;
    }
    ++hidden;
    EXPECT_EQ(row[2], "0");
    EXPECT_EQ(row[5], "0");
  }
  EXPECT_EQ(k, visible.size());
  EXPECT_GT(hidden, 0u);
}

TEST(GoldenFilesOfSpace, MatrixMarketHoldsTheFactorsOfTheCsv) {
  std::map<std::string, std::size_t> index;  // of elements
  for (const auto& row : read_csv(golden("space_factors_element.mtx.faces.csv"))) {
    if (row[0] == "index") continue;
    index.try_emplace(row[1], std::stoul(row[0]));
    index[row[1] + "#" + row[2]] = std::stoul(row[0]);
  }
  Entries expected, entries;
  for (const auto& row : read_csv(golden("space_factors_element.csv")))
    if (row[0] != "from") expected[{index.at(row[0]), index.at(row[1])}] = std::stod(row[2]);
  const auto lines = lines_of(golden("space_factors_element.mtx"));
  std::size_t k = 0;
  while (lines.at(k).starts_with("%")) ++k;
  for (++k; k < lines.size(); ++k) {
    std::size_t from = 0, to = 0;
    double factor = 0;
    std::istringstream(lines[k]) >> from >> to >> factor;
    entries[{from, to}] = factor;
  }
  EXPECT_EQ(entries, expected);
}

TEST(GoldenFilesOfSpace, DenseMatricesHaveNamesInTheFirstRowAndColumn) {
  for (const std::string name :
       {"space_matrix_factor.csv", "space_matrix_exchange.csv", "space_matrix_visibility.csv"}) {
    const auto rows = read_csv(golden(name));
    ASSERT_EQ(rows.size(), 2u * 7 + 2);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      ASSERT_EQ(rows[i].size(), rows.size());
      EXPECT_EQ(rows[i][0], rows[0][i]);
    }
  }
  const auto exchange = read_csv(golden("space_matrix_exchange.csv"));
  for (std::size_t i = 1; i + 1 < exchange.size(); i += 2)
    for (std::size_t j = 1; j + 1 < exchange.size(); j += 2) EXPECT_EQ(exchange[i][j], exchange[j][i]);
}

// Corners of faces, as coordinates.
using MeshFaces = std::vector<std::vector<std::array<double, 3>>>;

// Points and faces of an indexed mesh: as many of each, faces with the number of their corners first.
MeshFaces indexed_faces(std::istream& in, std::size_t points, std::size_t faces) {
  std::vector<std::array<double, 3>> all(points);
  for (auto& [x, y, z] : all) in >> x >> y >> z;
  MeshFaces result(faces);
  for (auto& face : result) {
    std::size_t corners = 0, index = 0;
    in >> corners;
    for (std::size_t k = 0; k < corners; ++k) {
      in >> index;
      face.push_back(all.at(index));
    }
  }
  EXPECT_TRUE(in);
  std::string rest;
  EXPECT_FALSE(in >> rest) << rest;
  return result;
}

TEST(GoldenFilesOfSpace, MeshesHoldTheSameFaces) {
  std::istringstream off(golden("space_mesh.off"));
  std::string word;
  std::size_t points = 0, faces = 0, edges = 0;
  off >> word >> points >> faces >> edges;
  EXPECT_EQ(word, "OFF");
  const MeshFaces of_off = indexed_faces(off, points, faces);
  ASSERT_EQ(of_off.size(), 7u);

  const std::string ply = golden("space_mesh.ply"), end = "end_header\n";
  EXPECT_TRUE(ply.starts_with("ply\nformat ascii 1.0\nelement vertex " + std::to_string(points) + "\n"));
  std::istringstream body(ply.substr(ply.find(end) + end.size()));
  EXPECT_EQ(indexed_faces(body, points, faces), of_off);

  MeshFaces of_obj;
  std::vector<std::array<double, 3>> vertices;
  for (const std::string& line : lines_of(golden("space_mesh.obj"))) {
    std::istringstream in(line);
    std::array<double, 3> p{};
    std::size_t index = 0;
    in >> word;
    if (word == "v" && in >> p[0] >> p[1] >> p[2]) vertices.push_back(p);
    if (word == "f")
      for (of_obj.emplace_back(); in >> index;) of_obj.back().push_back(vertices.at(index - 1));
  }
  EXPECT_EQ(of_obj, of_off);
}

TEST(GoldenFilesOfSpace, StlHasTrianglesOfFloatsWithTheirNormals) {
  const std::string stl = golden("space_mesh.stl");
  std::uint32_t count = 0;
  std::memcpy(&count, stl.data() + 80, 4);
  EXPECT_FALSE(stl.starts_with("solid"));
  EXPECT_EQ(count, 12u);  // five quads and two triangles
  ASSERT_EQ(stl.size(), 84u + 50 * count);
  for (std::size_t k = 0; k < count; ++k) {
    std::array<float, 12> f{};  // normal, a, b, c
    std::memcpy(f.data(), stl.data() + 84 + 50 * k, sizeof f);
    std::array<double, 3> b{}, c{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      b[axis] = f[6 + axis] - f[3 + axis];
      c[axis] = f[9 + axis] - f[3 + axis];
    }
    const std::array<double, 3> normal{b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]};
    const double length = std::hypot(normal[0], normal[1], normal[2]);
    for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(f[axis], normal[axis] / length, 1e-6);
  }
}

}  // namespace
}  // namespace hottel::golden_files_test
