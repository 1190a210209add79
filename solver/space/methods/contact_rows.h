// What masks and their bases exchange, in rows of methods that look around.
#pragma once

#include "solver/methods/factor_rows.h"
#include "solver/space/methods/element_geometry.h"

namespace hottel {

// Adds the factors of the contacts of an element to its row.
inline void add_contacts(const ElementGeometry3& geometry, std::uint32_t from, RowSums& by) {
  for (const ElementGeometry3::Contact& contact : geometry.contacts(from)) by.add(contact.to, contact.factor);
}

}  // namespace hottel
