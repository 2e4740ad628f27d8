// The numbers of a splat as SPZ rounds them. Each function states its step: a decoded number is at most half a step
// from the encoded one within the range, and is clamped to the range outside.
#pragma once
#include <array>
#include <cstdint>

namespace sh::prt {

/// Step 2^-fractional_bits, range +-2^23 steps; three bytes.
void encode_spz_position(float x, int fractional_bits, char* to);
float decode_spz_position(const char* from, int fractional_bits);

/// Step 1/16, range -10 .. 5.9375, of the natural logarithm of a scale.
std::uint8_t encode_spz_scale(float log_scale);
float decode_spz_scale(std::uint8_t code);

/// Step 1/255 of an opacity, range 0 .. 1; from and to logits.
std::uint8_t encode_spz_opacity(float logit);
float decode_spz_opacity(std::uint8_t code);

/// Step 1/(0.15 * 255) of the coefficient of degree 0, range +-10/3.
std::uint8_t encode_spz_color(float coefficient);
float decode_spz_color(std::uint8_t code);

/// Step 2^(1 - bits), range -1 .. 1 - 2^-7; bits 1 to 8. Zero stays zero.
std::uint8_t encode_spz_harmonic(float coefficient, int bits);
float decode_spz_harmonic(std::uint8_t code);

/// Unit quaternions w, x, y, z up to their sign. Version 2: x, y, z in steps of 1/127.5, w from them; three bytes.
/// Later: the three smallest of x, y, z, w in steps of sqrt(1/2)/511 and the number of the largest; four bytes.
void encode_spz_rotation(const float* q, int version, char* to);
void decode_spz_rotation(const char* from, int version, float* q);

}  // namespace sh::prt
