// The style sheet of the report's page, besides that of its charts.
#pragma once

namespace sh::numeric {

inline constexpr const char* kPageStyle = R"(
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

}  // namespace sh::numeric
