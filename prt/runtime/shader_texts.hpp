// The shaders of prt/shaders and the generated GLSL functions that shaders call, as text inside the library.
#pragma once
#include <string>
#include <string_view>

namespace sh::prt {

/// The text of a file of prt/shaders, or of a file of generated/glsl that CMakeLists.txt names. Throws
/// std::logic_error for any other name.
std::string_view shader_text(std::string_view file);

/// `family`_l`degree`: the name of a generated function; its text is shader_text(name + ".glsl").
std::string kernel_name(std::string_view family, int degree);

}  // namespace sh::prt
