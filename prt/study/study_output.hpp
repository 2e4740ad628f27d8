// Writes a study as JSON and as charts.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "prt/study/study.hpp"

namespace sh::prt {

/// All measurements, with descriptions. `scene` gives the positions of the worst vertices.
nlohmann::ordered_json study_json(const Study& study, const Scene& scene);

struct StudyChart {
  std::string file;  // name without folder, .svg
  std::string title;
  std::string svg;
};

/// Charts of every part with errors above 0: error against its axis and, if time was measured, against time.
std::vector<StudyChart> study_charts(const Study& study);

}  // namespace sh::prt
