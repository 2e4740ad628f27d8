// What the numbers of a transfer file have to be, for its writer and its reader.
#pragma once
#include <string>

#include "prt/transfer/transfer.hpp"

namespace sh::prt {

/// What is wrong with a number of the transfer, as the end of a message; empty if nothing is. Indices name vertices;
/// positions, coefficients and emitted light are finite; normals have length 1 (to 1/1000); albedo and mirrors are
/// from 0 to 1.
std::string flaw_of_values(const Transfer& transfer);

}  // namespace sh::prt
