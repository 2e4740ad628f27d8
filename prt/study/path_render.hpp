// A path tracer: the independent, slow reference for pictures of bakes with bounces, diffuse and glossy. It uses no vertex
// but to interpolate position, albedo and normal over a face. At the center of every pixel it follows random paths;
//   radiance = sum over the surfaces of a path of (product of the reflectances so far) * emission
//            + (product of all reflectances) * sky(s) where the path leaves the scene in direction s.
// Directions have the density of the cosine about the shading normal, or of the lobe about the mirrored direction: chance
// decides by their reflectances. Paths end below the face, at backs of faces, and by chance where they carry little light
// (Russian roulette [ArvoKirk90]). BRDFs have the bands of their tables. Mirrors are not followed.
#pragma once
#include "prt/rays/tracer.hpp"
#include "prt/runtime/render.hpp"
#include "prt/scene/camera.hpp"

namespace sh::prt {

/// Two pictures from independent paths.
struct PathPictures {
  Picture first;
  Picture second;
};

/// Each of the two pictures follows `paths` paths a pixel, through its center: size.samples is 1. Pixels that hit nothing
/// are black and have coverage 0. The same bits for any number of threads. Throws std::invalid_argument for another size
/// and for a mesh with mirrors.
PathPictures path_render(const Mesh& mesh, const Tracer& tracer, const Background& sky, const Camera& camera,
                         const PictureSize& size, int paths);

/// Noise of the mean of both pictures: rms of half their difference over the rms of the mean, over the pixels that the
/// mesh covers and all channels. NaN if the mesh covers none or all are black.
double path_noise(const PathPictures& paths);

/// Error of a picture of the same size: rms of its difference from the mean of both, in the same unit, without the part
/// that is noise: the product of the differences from the one and from the other has the square of the error as its
/// expectation, because the two are independent. 0 where noise leaves less, NaN as above.
double error_against_paths(const Picture& picture, const PathPictures& paths);

}  // namespace sh::prt
