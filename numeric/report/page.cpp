// report_page of report.hpp: one HTML page with everything in it, charts as SVG, tables folded away.
#include <fmt/format.h>

#include <initializer_list>

#include "numeric/output/markup.hpp"
#include "numeric/report/figures.hpp"
#include "numeric/report/report.hpp"

namespace sh::numeric {
namespace {

using output::escaped;

// Besides the style of the charts.
constexpr const char* kPageStyle = R"(
*{box-sizing:border-box}
body{margin:0;background:var(--paper);color:var(--ink);font:16px/1.55 system-ui,-apple-system,"Segoe UI",Roboto,"DejaVu Sans",sans-serif}
main,header,nav{max-width:1020px;margin:0 auto;padding:0 24px}
header{padding-top:48px}
h1{font-size:30px;line-height:1.2;margin:0 0 8px;letter-spacing:-.01em}
h2{font-size:21px;margin:56px 0 4px;padding-top:16px;border-top:1px solid var(--grid)}
p{max-width:70ch;margin:8px 0}
.quiet,small{color:var(--quiet)}
nav{margin-top:20px;display:flex;flex-wrap:wrap;gap:6px 18px}
a{color:var(--c0);text-decoration:none}a:hover{text-decoration:underline}
.legend{display:flex;flex-wrap:wrap;gap:4px 18px;margin:14px 0 6px;font-size:13px;padding:0;list-style:none}
.legend li{display:flex;align-items:center;gap:6px}
.charts{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(440px,100%),1fr));gap:20px 28px;margin:12px 0}
.charts .chart{width:100%}
details{margin:10px 0}summary{cursor:pointer;color:var(--quiet);font-size:14px}
.table{overflow-x:auto}
table{border-collapse:collapse;font-size:13px;line-height:1.4;margin:8px 0;font-variant-numeric:tabular-nums}
th,td{text-align:left;padding:3px 14px 3px 0;vertical-align:top;border-bottom:1px solid var(--grid)}
th{font-weight:600;color:var(--quiet);white-space:nowrap}
td.n{text-align:right;white-space:nowrap}td.w{white-space:nowrap}tr.best td{font-weight:600}tr.best td.light{font-weight:400}
td.how{min-width:26ch}ul{max-width:70ch;padding-left:1.2em}
code{font:12.5px/1.4 ui-monospace,"SF Mono",Menlo,Consolas,"DejaVu Sans Mono",monospace}
footer{max-width:1020px;margin:64px auto 32px;padding:0 24px;color:var(--quiet);font-size:13px}
)";

std::string table(std::initializer_list<const char*> columns, const std::string& rows) {
  return fmt::format("<div class=\"table\"><table><tr><th>{}</th></tr>\n{}</table></div>",
                     fmt::join(columns, "</th><th>"), rows);
}

std::string row(const Point& p) {
  return fmt::format(
      R"(<tr{}><td class="n">{}</td><td class="w">{}</td><td>{}</td><td>{}</td><td class="n">{:.3g}</td>)"
      R"(<td class="n">{:.2e}</td><td class="n">{:.2g}</td><td class="light">{}: {}</td><td class="light">{}</td>)"
      "<td class=\"light\"><code>{}</code></td></tr>\n",
      p.on_front ? " class=\"best\"" : "", p.info.degree, escaped(p.info.name), p.info.scalar, to_string(p.info.mode),
      p.nanoseconds, p.error, p.error_eps, escaped(p.worst.input), escaped(p.worst.output), escaped(p.info.leaves_out),
      escaped(p.info.call.empty() ? p.info.source : p.info.call));
}

std::string table_of(const Task& task, const std::vector<Point>& points) {
  std::string rows;
  std::size_t count = 0;
  std::string unit;
  for (const auto& point : points) {
    if (point.info.task != task.id) continue;
    if (unit.empty()) unit = point.unit;
    rows += row(point);
    ++count;
  }
  return fmt::format(
      "<details><summary>All {} measurements</summary><p><small>Bold: on the front of its degree and mode. eps: "
      "largest error in machine epsilon \u00d7 {}.</small></p>{}</details>\n",
      count, escaped(unit),
      table({"degree", "method", "type", "mode", "ns", "error", "eps", "worst input and output", "leaves out", "call"},
            rows));
}

std::string legend_of(const std::vector<output::ChartSeries>& all) {
  std::string text = "<ul class=\"legend\">";
  for (const auto& series : all) text += "<li>" + output::chart_key(series) + escaped(series.name) + "</li>";
  return text + "</ul>\n";
}

std::string html_of(const Figure& figure) {
  std::string text = legend_of(figure.legend) + "<div class=\"charts\">\n";
  for (const auto& chart : figure.charts) text += output::chart_svg(chart);
  return text + "</div>\n";
}

std::string convergence_section(const std::vector<ConvergenceSeries>& convergence) {
  std::string functions;
  for (const auto& function : test_functions()) {
    functions += fmt::format("<li><b>{}</b>: {}</li>", escaped(function.name), escaped(function.description));
  }
  std::string rows;
  for (const auto& series : convergence) {
    for (const auto& p : series.points) {
      rows += fmt::format(
          "<tr><td>{}</td><td>{}</td><td class=\"n\">{}</td><td class=\"n\">{:.2e}</td><td class=\"n\">{:.2e}</td><td "
          "class=\"n\">{:.3g}</td></tr>\n",
          escaped(series.function), escaped(series.rule), p.samples, p.error_rms, p.error_max, p.nanoseconds / 1000);
    }
  }
  return "<section id=\"convergence\"><h2>Projection by quadrature</h2>\n<p>The coefficients of a function up to "
         "degree 5, from samples of the function. Error: the largest error of a coefficient, relative to the length of "
         "all coefficients (root mean square over seeds for random rules). Time: making the nodes, evaluating the "
         "function, summing.</p>\n<ul>" +
         functions + "</ul>\n" + html_of(convergence_figure(convergence)) +
         "<details><summary>All measurements</summary>" +
         table({"function", "rule", "samples", "error, rms", "error, largest", "\u00b5s"}, rows) +
         "</details></section>\n";
}

std::string claims_section(const std::vector<SourceClaim>& claims) {
  std::string rows;
  for (const auto& c : claims) {
    rows += fmt::format(
        "<tr><td>{}<br><small>{}</small></td><td class=\"n\">{}{}</td><td class=\"n\">{:.3g}{}</td><td>{}</td><td "
        "class=\"how\"><small>{}</small></td></tr>\n",
        escaped(c.claim), escaped(c.source + ", " + c.id), escaped(c.printed), escaped(c.unit), c.measured,
        escaped(c.unit), c.reproduced ? "yes" : "<b>no</b>", escaped(c.how));
  }
  return "<section id=\"claims\"><h2>Claims of the sources, measured again</h2>\n" +
         table({"claim", "printed", "measured", "reproduced", "how"}, rows) + "</section>\n";
}

std::string section_of(const Task& task, const std::vector<Point>& points) {
  const auto figure = task_figure(task, points);
  std::string text = fmt::format("<section id=\"{}\"><h2>{}</h2>\n<p>{} Error: of {}.</p>\n", task.id,
                                 escaped(task.title), escaped(task.what), escaped(task.error));
  return text + html_of(figure) + table_of(task, points) + "</section>\n";
}

std::string head(const Report& report) {
  return "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
         "content=\"width=device-width,initial-scale=1\"><meta name=\"color-scheme\" content=\"light "
         "dark\"><title>shforge: error against run time</title>\n<style>" +
         output::chart_style() + kPageStyle + "</style></head>\n<body><header><h1>Error against run time</h1>\n" +
         fmt::format("<p class=\"quiet\">{}, one thread; batches on {}; {} mode, measured in {:.0f} s.</p>\n",
                     escaped(report.machine), escaped(report.instruction_set), report.quick ? "quick" : "full",
                     report.seconds);
}

constexpr const char* kHowToRead =
    "<p>Each mark is a method in one type, \u25cf filled for float and \u25cb hollow for double. Marks to the left are "
    "faster, marks below are more exact. The solid line is the front of single calls, the dashed line the front of "
    "batches: no method is both faster and more exact than a mark on its front. Rest the pointer on a mark to see its "
    "worst input and what it leaves out.</p>\n<p>The error of a method is the largest over all inputs (random ones, "
    "axes, "
    "poles, places beside them, all angles), against an oracle of other algorithms in higher precision, at the input "
    "rounded to the type. The time is the least of several passes. Calls go through a pointer (about 1 ns each); the "
    "compiler does not contract operations. Times differ between machines and runs, ratios of times hardly do.</p>"
    "</header>\n";

}  // namespace

std::string report_page(const Report& report) {
  std::string page = head(report) + kHowToRead + "<nav>";
  for (const auto& task : report.tasks) page += fmt::format("<a href=\"#{}\">{}</a>", task.id, escaped(task.title));
  if (!report.convergence.empty()) page += "<a href=\"#convergence\">Projection by quadrature</a>";
  if (!report.claims.empty()) page += "<a href=\"#claims\">Claims of the sources</a>";
  page += "</nav>\n<main>\n";
  for (const auto& task : report.tasks) page += section_of(task, report.points);
  if (!report.convergence.empty()) page += convergence_section(report.convergence);
  if (!report.claims.empty()) page += claims_section(report.claims);
  return page +
         "</main>\n<footer>Made by <code>shcheck report</code>. The numbers are in <code>report.json</code>. "
         "Orthonormal real spherical harmonics, no Condon-Shortley phase, z polar.</footer></body></html>\n";
}

}  // namespace sh::numeric
