// Radiosities in space as a file for ParaView and others that read VTK's formats.
#pragma once

#include <functional>
#include <string_view>

#include "geometry/element.h"
#include "geometry/exchange_matrix.h"
#include "geometry/space/prepared/prepared_scene.h"
#include "solver/radiosity/radiosity_solution.h"

namespace hottel {

// Writes an unstructured grid (VTK's XML, as text): a convex polygon for each patch that an element with a row is made
// of, those of one element beside each other.
//
//   (1) cell data, by channel: emission, reflectivity, radiosity, lower, upper, irradiance, net: shortest decimals that
//       read back to the same double, as in radiosity.csv; and net_flux, net times area [W], in two bands with their
//       sum `total`. Components have the names of their channels
//   (2) of each cell also: id, the number of its element among those with a row, from 0; name, face, group and material
//       as texts; area of the whole element; sky_view_factor; surface, is_back, element: the number of the surface in
//       the scene, its side, and the number of the element on it
//   (3) where the scene has temperatures to tell: temperature [K], of two bands that of the thermal one, by channel
//       else, and has_temperature; 0 where an element has none
//   (4) line 2 + id n + c of radiosity.csv, the first being 1, is of the cell's element and channel c of n. So each
//       cell belongs to one line a channel; several cells to one where an element is made of several patches. An
//       element that is nothing but a mask has lines and no cell
//   (5) corners are the nearest doubles, counter-clockwise seen from the side that the element is on; patches share
//       none
//
// Whatever the sink throws stops the writing. REQUIRES the solution of this matrix, and the matrix of this scene by
// that granularity.
void write_radiosity_vtu(const PreparedScene3& prepared, Granularity granularity, const ExchangeMatrix& matrix,
                         const RadiositySolution& solution, const std::function<void(std::string_view)>& sink);

}  // namespace hottel
