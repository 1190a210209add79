// Radiosities of one light after another, and what follows from them.
#pragma once

#include "solver/dividing/dividing_estimate.h"  // DividingEstimate
#include "solver/radiosity/direct_light.h"      // LightShares
#include "solver/radiosity/gray_exchange.h"     // gray_exchange
#include "solver/radiosity/net_flux.h"          // net_flux
#include "solver/radiosity/radiosity_solver.h"  // RadiositySolver
