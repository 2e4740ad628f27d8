// One product or one rotation at a time, with SIMD inside the call, for batch.hpp.
//
// Copied by:    shgen write, from codegen/runtime to generated/batch
// Licence:      MIT-0; paste it anywhere.
#pragma once

#include <cstddef>

namespace sh::batch {

/// One product of two functions, projected on the same bands, with SIMD inside: for what comes one at a time.
/// degree 0 to 10; a (bands^2), b (bands^2), out (bands^2), plain, of any alignment; out may be a or b.
/// Domain: any coefficients of which the squares can be added up; error at most 4 epsilon |a| |b|. Where an input is
/// infinite or not a number, so may be every output. Throws std::invalid_argument when the degree is out of range.
void product_one(int degree, const float* a, const float* b, float* out);

/// Coefficients of one rotated function, by a rotation matrix, with SIMD inside.
/// degree 0 to 10; r (9), c (bands^2), out (bands^2), plain, of any alignment; out may be c.
/// Domain: r, row by row, is a rotation: r r^T = 1, det r = 1; error at most 1e-6 |c| to degree 5.
/// Throws std::invalid_argument when the degree is out of range.
void rotate_one(int degree, const float* r, const float* c, float* out);

/// The same for a matrix that rotates many functions, one at a time: what depends on r once, then the rest for each.
/// prepared (rotate_prepared_size(degree)): of any alignment, the fastest when aligned to 64 bytes; the same on every
/// instruction set but for rounding, of no other use. Same domain and errors.
std::size_t rotate_prepared_size(int degree);
void rotate_prepare(int degree, const float* r, float* prepared);
void rotate_prepared_one(int degree, const float* prepared, const float* c, float* out);

}  // namespace sh::batch
