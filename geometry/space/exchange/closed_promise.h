// The promise of a scene in space to be closed, where its exact factors are not asked for.
#pragma once

namespace hottel {

struct PreparedScene3;

// Throws RequestError, naming the first front, where the scene promises to be closed and a front with a material sees
// the sky. Decided by signs, whatever method gives the factors.
// COST: nothing without the promise; else that of the pairs of all faces with the sky, coarsely.
void require_closed(const PreparedScene3& prepared);

}  // namespace hottel
