// Kernels over many records at once: directions, coefficient vectors, (matrix, vector) pairs.
//
// Copied by:    shgen write, from codegen/runtime to generated/batch
// Licence:      MIT-0; paste it anywhere.
//
//   std::vector<float> directions(3 * n), values(25 * n);
//   sh::batch::basis(4, n, sh::batch::plain(directions.data()), sh::batch::plain(values.data()));
//
// records.hpp explains layouts and instruction sets, drivers.hpp declares the functions over n records, one.hpp those
// for one record, stored.hpp relighting of transfer as files store it. An output may be the array of an input with the
// same layout and record size; otherwise arrays must not overlap. Outputs that outgrow the last cache are written past
// it (not from half precision). Nothing is allocated.
//
// Errors: std::invalid_argument when the degree is out of range, an array is missing, an output is shared or an array is
// interleaved that has no colors. Inputs outside a kernel's domain give what the kernel gives.
#pragma once

#include "drivers.hpp"
#include "one.hpp"
#include "records.hpp"
#include "stored.hpp"
