// Hottel's total exchange factors (script-F) of gray diffuse faces, from view factors.
//
//   const Simulation2 simulation(read_scene_2("scenes/analytic/square_radiosity.json"));
//   const ExchangeMatrix script_f = gray_exchange(simulation.factors()->matrix, simulation.scene().materials);
//   std::printf("script-F = %.12g\n", script_f.factor("bottom", "top").value);
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "geometry/exchange_matrix.h"
#include "geometry/material.h"

namespace hottel {

// Memory for one pair of the result while it is computed, from which GrayExchangeOptions::memory is checked.
inline constexpr std::uint64_t kBytesPerGrayPair = 80;

// Which channel is meant, how much memory is allowed, and a function for the progress.
struct GrayExchangeOptions {
  int channel = 0;                            // 0 to 2: whose reflectivities are meant
  std::uint64_t memory = 0;                   // bytes the result may take while it is computed; 0: no limit
  std::function<void(double)> progress = {};  // fraction done, called by the calling thread; may throw to stop
};

// Returns the gray-body exchange factors script-F_ij of a scene: the power that i emits and j absorbs, straight or
// after any number of reflections, over what a black body with the temperature of i would emit from i. So the net
// power that flows from i to j is
//
//   q_ij = A_i script-F_ij sigma (T_i^4 - T_j^4),    script-F_ij = e_i e_j sum_k F_ik G_kj,    G = I + rho F G,
//
// with the emissivities e = 1 - rho and G_kj the radiosity of k when j alone emits, 1 per area.     [fraction]
//
// Rows and columns are those of the view factors: a row for each face with a material; a column for each face, black
// backs included (e = 1), and for the sky, which is black and sends nothing back. Faces see themselves by reflection,
// so script-F_ii > 0 also where F_ii = 0.
//
//   (1) A_i script-F_ij = A_j script-F_ji for the real numbers behind the doubles
//   (2) rows sum to e_i
//   (3) without reflection script-F = F, bit for bit
//   (4) if no view factor is estimated, every number lies in ExchangeMatrix::bounds(), proven, for the exact view
//       factors and reflectivities. With exact factors, and reflectivities up to 1 - 2^-50 and beyond, bounds are a few
//       ulps wide. With enclosed ones they reach from the result of all lower ends to that of all upper ends; they are
//       narrower if the matrix has closed rows (enclosed_radiosity.h).
//       If some are estimated, script-F is that of the doubles: (1) and (2) hold as nearly as they do of
//       the view factors, and the guarantee is kEstimated
//   (5) the row and the column of a face with e = 0 are 0, even if all faces that it exchanges light with have e = 0
//       and the light would be reflected for ever
//   (6) no entry iff the real number is 0; the same bit for bit for any number of threads
//
// Throws ContractViolation if a factor is below 0, there is no such channel, or the material of an element is not in
// `materials`; RequestError if factors are too small for bounds, if estimated factors may let light circulate for ever,
// and if the result takes more memory than is allowed. COST: one elimination
// (n^3 / 3 for a component of n faces), three where factors are enclosed; for each column with e > 0 about ten passes
// over the matrix and five back substitutions (n^2), three times as many then; 80 bytes a pair of the result, which is
// dense within each component. SEE: Hottel and Sarofim, Radiative Transfer, 1967, chapter 3; Walton, NISTIR 6925, 2002
// (View3D, `emit=1`).
ExchangeMatrix gray_exchange(const ExchangeMatrix& matrix, const std::vector<Material>& materials,
                             const GrayExchangeOptions& options = {});

// Returns the largest width of bounds over its factor, of all positive factors of an enclosed matrix; 0 without any.
double max_relative_width(const ExchangeMatrix& matrix);

// Returns the first row whose material reflects the channels differently; nothing when all faces are gray.
// REQUIRES materials of the elements that index into `materials`.
std::optional<std::uint32_t> first_coloured(const ExchangeMatrix& matrix, const std::vector<Material>& materials);

// Returns the channel whose reflectivities script-F is of: the thermal one of two bands; else that of the name, r, g or
// b; without a name any, as all faces are to be gray. Throws RequestError, naming the material, where they are not, and
// UnknownName for another name. REQUIRES what first_coloured does.
int gray_channel(const ExchangeMatrix& matrix, const std::vector<Material>& materials, const std::string& name);

}  // namespace hottel
