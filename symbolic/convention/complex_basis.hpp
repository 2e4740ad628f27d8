// Complex and real spherical harmonics: the unitary W between them, exact.
//
// Both orthonormal. Complex: Y_lm = e_m k P_l^|m|(cos theta) exp(i m phi), e_m = (-1)^m for m > 0 with the
// Condon-Shortley phase, else 1; so Y_l,-m = (-1)^m conj(Y_lm), or conj(Y_lm) without the phase. Real: as
// symbolic/basis/basis.hpp. In each band Y_real = W Y_complex, with
//     Y_real,m = (e_m Y_m + Y_-m) / sqrt 2,   Y_real,-m = (e_m Y_m - Y_-m) / (i sqrt 2),   Y_real,0 = Y_0   (m > 0).
// If Y_complex(R s) = D Y_complex(s), the real matrix is W D W* [Brown04]. Coefficients transform with the conjugate:
// f = sum c Y gives c_complex = W^T c_real, c_real = conj(W) c_complex.
#pragma once

#include "symbolic/number/matrix.hpp"
#include "symbolic/number/radical_sum.hpp"

namespace sh::symbolic {

/// W of one band, (2l+1, 2l+1): row l+m real, column l+m complex.
Matrix<RadicalSum> real_from_complex(int degree, bool condon_shortley);

/// The conjugate transpose.
Matrix<RadicalSum> adjoint(const Matrix<RadicalSum>& m);

}  // namespace sh::symbolic
