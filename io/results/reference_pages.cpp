#include "io/results/reference_pages.h"

#include "kernel/version.h"

namespace hottel {
namespace {

constexpr const char* kReadme =
    R"(# Reference solutions of diffuse light

View factors and radiosities of scenes in the plane and in space, computed by hottel {version}: to cite, and to test
solvers against.

## Which problem

**The problem is discrete.** Radiosity, emission and reflectivity are constant on each element, and

    B_i = E_i + rho_i (sum_j F_ij B_j + D_i)

with F_ij the exact view factor of elements i and j, and D_i what lights send to i directly. `scene.json` says which
elements there are (`elements` of a surface; where it says nothing a surface is one element), and `reference.json` how
many. Bounds of radiosities are bounds of the discrete solution. The continuous one, and that of finer elements, is
another: no bound here tells how far it is.

## Files

`reference.json` says of each scene how many elements, unknowns and factors it has, what is guaranteed of them, in
which units numbers are, and each file's checksum. There is one folder a scene:

| file | what it holds |
|---|---|
| `scene.json` | the scene, which holds all that is computed from (of meshes, decks and divided scenes as hottel writes them); coordinates are the decimals as typed |
| `factors.csv` | view factors of all elements that see each other |
| `factors.mtx` | the same in Matrix Market's format, rows and columns as in the next file, the sky last |
| `factors.mtx.faces.csv` | the elements |
| `radiosity.csv` | the discrete solution, one line for each element with a material and each channel |
| `illumination.npy` | where the scene has a grid: mean irradiance at the centres of its cells, of the discrete solution; float64 |
| `illumination.npy.json` | its shape, axes, region and channels |

Units: L is the unit of coordinates of the scene, A that of areas, W that of radiosities; `units` in `reference.json` names
all three. A is m (plane, a length) or m² (space), W is W/m² (plane: watts per metre of depth and per metre of edge); where the unit of
length has a name that hottel does not know, A is in that unit.

| file | column | unit | meaning |
|---|---|---|---|
| `factors.csv` | `from`, `to` | | elements: `NAME` a front, `NAME:back` a back, `NAME#k` element k; `sky` |
| | `factor` | 1 | fraction of what leaves `from` that arrives at `to` |
| | `lower`, `upper` | 1 | bounds of the real number, proven |
| | `visibility` | 1 | S / S0: over what it were with all other surfaces gone; empty where that is 0 |
| | `guarantee` | | what is known of `factor`, below |
| `factors.mtx` | row, column | | `index` of `factors.mtx.faces.csv`, from 1 |
| | value | 1 | the factor from row to column |
| `factors.mtx.faces.csv` | `index`, `face`, `element`, `material` | | number, name, k of `NAME#k` (0: whole), name |
| | `area` | A | of what belongs to the element |
| | `x0`, `y0`, `x1`, `y1` | L | in the plane: its ends, front on the right of 0 -> 1 |
| | `points` | L | in space: its corners, counter-clockwise seen from the front |
| `radiosity.csv` | `face`, `element`, `channel` | | |
| | `area` | A | |
| | `emission` | W | E |
| | `reflectivity` | 1 | rho |
| | `radiosity` | W | B of the discrete problem |
| | `lower`, `upper` | W | bounds of B of the discrete problem, proven where `radiosities` of `reference.json` are `enclosed`; where they are `estimated`, of what the factors as computed give |
| | `irradiance`, `net` | W | H, B - H |
| `illumination.npy` | every number | W | mean over all directions of the radiosity seen; NaN in solids |

**Factors.** In the plane each is the double nearest to the real number (`exact`). In space `enclosed` is within `tolerance`
(`reference.json`) of the smaller area over its own, proven; `estimated` is within as much by two rules of quadrature that
agree and a check that every pair passes, without proof, and `lower`, `upper` are wide.

**Light on grids** has no bound: what each centre sees is exact, its angles are summed in doubles. Hold it to 1e-12 of the
largest value.

## Check it

    sha256sum -c SHA256SUMS

## Make it again

    {command}

in this folder writes the same set with the same version: each scene file states its elements and its grid. Factors in
the plane are correctly rounded, so that `factors.csv` is the same byte for byte on any machine. What is summed in
doubles may differ in the last digits where the mathematical library is another one; bounds then overlap.

## Compare your solver

    hottel compare NAME/scene.json --methods file:YOUR_FACTORS.csv -o OUT

tells how wrong view factors are, in words and numbers; `.mtx`, `.npy` and files of View3D are read too, and
`--grid-file YOUR.npy` takes light on the grid. Without hottel: take `NAME/scene.json` with exactly its elements, and hold each
of your factors against `lower`, `upper` of `factors.csv`, and each radiosity against `lower`, `upper` of `radiosity.csv`. A
radiosity outside its bounds by more than your arithmetic's error solves another problem than this discrete one:
finer elements, other factors, or a mistake.

## Licence

CC0-1.0: [LICENSE.txt](LICENSE.txt).

## Citation

Name hottel {version} (The hottel developers; `CITATION.cff` in the root of its repository), and the SHA-256 of the file
`SHA256SUMS` of this set, which stands for every byte of it.
)";

constexpr const char* kLicence =
    R"(SPDX-License-Identifier: CC0-1.0

To the extent possible under law, the hottel developers have waived all copyright and related or neighbouring rights to
the files of this set that hottel wrote: factors, elements, radiosities, light, the manifest, the page and the checksums.
So they have to each scene.json that is of a scene that comes with hottel. A scene of others stays under the terms of
those who made it.

CC0 1.0 Universal, the full text: https://creativecommons.org/publicdomain/zero/1.0/legalcode
)";

void replace_all(std::string& text, const std::string& place, const std::string& by) {
  for (std::size_t at = text.find(place); at != std::string::npos; at = text.find(place, at + by.size()))
    text.replace(at, place.size(), by);
}

}  // namespace

std::string reference_readme(const std::string& command) {
  std::string text = kReadme;
  replace_all(text, "{version}", kVersion);
  replace_all(text, "{command}", command);
  return text;
}

std::string reference_licence() { return kLicence; }

}  // namespace hottel
