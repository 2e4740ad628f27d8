#include "prt/view/serve.hpp"

#include <fmt/format.h>
#include <httplib.h>

#include <charconv>
#include <chrono>
#include <stdexcept>
#include <thread>

#include "numeric/output/progress.hpp"

namespace sh::prt {
namespace {

constexpr const char* kHost = "127.0.0.1";
constexpr std::size_t kMostPicture = std::size_t{1} << 30U;  // bytes

bool is_of_this_machine(const httplib::Request& request) {
  const std::string host = request.get_header_value("Host");
  const std::string name = host.substr(0, host.find(':'));
  const std::string origin = request.get_header_value("Origin");  // of a page that posts
  return (name == kHost || name == "localhost") && (origin.empty() || origin == "http://" + host);
}

void answer_with(httplib::Server& server, const std::string& path, const std::string& bytes, const char* type) {
  server.Get(path, [&bytes, type](const httplib::Request& /*request*/, httplib::Response& response) {
    response.set_header("Cache-Control", "no-store");
    response.set_content(bytes, type);
  });
}

/// POST /project?degree=N with a picture as body: its light, or status 400 with one line.
void answer_pictures(httplib::Server& server, const ProjectsPictures& project) {
  server.Post("/project", [&project](const httplib::Request& request, httplib::Response& response) {
    const std::string text = request.get_param_value("degree");
    int degree = -1;
    std::from_chars(text.data(), text.data() + text.size(), degree);
    try {
      response.set_content(project(request.body, degree), "application/json");
    } catch (const std::exception& flaw) {
      response.status = 400;
      response.set_content(flaw.what(), "text/plain; charset=utf-8");
    }
  });
}

}  // namespace

void serve_page(const std::string& page, const std::vector<ViewedFile>& files, int port,
                const ProjectsPictures& project, const std::function<void(const std::string& address)>& ready) {
  httplib::Server server;
  server.set_pre_routing_handler([](const httplib::Request& request, httplib::Response& response) {
    if (is_of_this_machine(request)) return httplib::Server::HandlerResponse::Unhandled;
    response.status = 403;
    return httplib::Server::HandlerResponse::Handled;
  });
  answer_with(server, "/", page, "text/html; charset=utf-8");
  for (std::size_t i = 0; i < files.size(); ++i) {
    answer_with(server, fmt::format("/file/{}", i), files[i].bytes, "application/octet-stream");
  }
  answer_pictures(server, project);
  server.set_payload_max_length(kMostPicture);
  const int bound = port == 0 ? server.bind_to_any_port(kHost) : server.bind_to_port(kHost, port) ? port : -1;
  if (bound < 0)
    throw std::runtime_error(fmt::format("--port {}: cannot listen there; expected a port that is free", port));
  std::thread answering([&] { server.listen_after_bind(); });
  ready(fmt::format("http://{}:{}/", kHost, bound));
  try {
    while (true) {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
      output::check_interrupt();
    }
  } catch (const output::Interrupted&) {  // the way to end
    server.stop();
    answering.join();
  }
}

}  // namespace sh::prt
