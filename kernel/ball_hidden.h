// What a Ball is made of. Internal to kernel: it shows Arb.
#pragma once

#include <arb.h>

#include "kernel/ball.h"
#include "kernel/flint_memory.h"

namespace hottel {

struct Ball::Hidden {
  arb_t x;
  Hidden() {
    return_flint_memory_at_thread_end();
    arb_init(x);
  }
  Hidden(const Hidden& other) {
    return_flint_memory_at_thread_end();
    arb_init(x);
    arb_set(x, other.x);
  }
  Hidden& operator=(const Hidden&) = delete;
  ~Hidden() { arb_clear(x); }
};

// Sets a ball to an integer, exactly.
inline void set_integer(arb_t out, const Integer& value) {
  fmpz_t z;
  fmpz_init(z);
  fmpz_set_mpz(z, value.get_mpz_t());
  arb_set_fmpz(out, z);
  fmpz_clear(z);
}

}  // namespace hottel
