// Serves a page and its files to browsers of this machine alone.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "prt/view/page.hpp"

namespace sh::prt {

/// Bytes of a picture and a degree -> its light as JSON. Throws an exception with one line for a picture that cannot be read.
using ProjectsPictures = std::function<std::string(const std::string& bytes, int degree)>;

/// Listens on 127.0.0.1, calls ready(address), such as http://127.0.0.1:8080/, and answers until a signal asks to stop. Port
/// 0 takes any that is free. Requests by another name than 127.0.0.1 or localhost, or from pages of others, are refused. Pictures that the page sends
/// go through `project`. Throws std::runtime_error, one line, if the port is taken.
void serve_page(const std::string& page, const std::vector<ViewedFile>& files, int port,
                const ProjectsPictures& project, const std::function<void(const std::string& address)>& ready);

}  // namespace sh::prt
