// The parts of a study, one function each.
#pragma once
#include "prt/study/study.hpp"
#include "prt/study/study_setup.hpp"

namespace sh::prt {

/// Error and time against directions, a curve a sampler, at the scene's degree.
StudyPart study_directions(const StudySetup& setup);
/// Error of leaving out the higher degrees, and the time of each degree, a curve a reference.
StudyPart study_degrees(const StudySetup& setup);
/// Error of stopping the series of bounces, all vertices of the mesh.
StudyPart study_bounces(const StudySetup& setup);

/// Error against the bytes of a vertex, by degree and by how a number is stored.
StudyPart study_storage(const StudySetup& setup);
/// Error against degree under windows on the light.
StudyPart study_windows(const StudySetup& setup);
/// No curves: where errors sit that few directions and few degrees make, by bakes of the whole mesh.
StudyPart study_pictures(const StudySetup& setup);

}  // namespace sh::prt
