// The attributes in the header of an OpenEXR file, before the library reads them.
#pragma once
#include <string>
#include <string_view>

namespace sh::prt {

/// Refuses a header with an attribute of more bytes than the file has: the library would first take the memory, up to 2
/// GB. `file` names the picture in messages. Throws std::runtime_error, one line.
void check_exr_attributes(const std::string& file, std::string_view bytes);

}  // namespace sh::prt
