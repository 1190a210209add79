// What a Ball is made of. Internal to kernel: it shows Arb.
#pragma once

#include <arb.h>

#include "kernel/flint_memory.h"
#include "kernel/rational.h"

namespace hottel {

// A ball of Arb, owned.
struct BallNumber {
  arb_t x;
  BallNumber() {
    return_flint_memory_at_thread_end();
    arb_init(x);
  }
  BallNumber(const BallNumber& other) {
    return_flint_memory_at_thread_end();
    arb_init(x);
    arb_set(x, other.x);
  }
  BallNumber& operator=(const BallNumber&) = delete;
  ~BallNumber() { arb_clear(x); }
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
