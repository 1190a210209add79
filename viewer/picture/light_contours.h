// Lines of equal light in pictures of grids.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "viewer/picture/canvas.h"
#include "viewer/picture/contours.h"

namespace hottel {

// Returns the one number of a place that contours go by: the mean of its channels, of two bands the solar one.
double shown_mean(std::span<const double> value);

// Returns the levels of lines of equal light for a picture of a grid: round ones, at most so many (contour_levels), in
// what the grid holds; of several channels shown_mean() counts. None for 0. Values that are not above 0, or no numbers,
// are passed over.
std::vector<double> light_contours(std::span<const double> values, std::size_t channels, int contours);

// Draws lines of these levels over light, moved by `origin`, each with one label at most.
//
//   (1) they run where the field has their level, once what is finer than a cell is blended (smoothed_field); by
//       logarithms: light spans decades, and one lamp does not lift what is around it
//   (2) they cross neither walls nor each other (contour_set)
// cell: pixels across. size: that of letters. Nothing is drawn where there are no levels.
void draw_light_contours(PictureCanvas& canvas, PixelField light, std::span<const double> levels, double cell,
                         Pixel origin, double size);

}  // namespace hottel
