// A study as text: JSON for programs, charts for people.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "prt/study/study.hpp"

namespace sh::prt {

/// Everything that was measured, with what it means. `scene` gives places of worst vertices.
nlohmann::ordered_json study_json(const Study& study, const Scene& scene);

struct StudyChart {
  std::string file;  // name without folder, .svg
  std::string title;
  std::string svg;
};

/// Of every part with errors above 0: error against its axis, and against time where that was measured.
std::vector<StudyChart> study_charts(const Study& study);

}  // namespace sh::prt
