// SPDX-FileCopyrightText: 2026 The PEMesh developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PageStyle.h"

namespace pemesh
{

// Neither < nor & may occur: the page is well-formed XML as well.
const char* const PageStyle = R"(
:root { color-scheme: light dark; --text: #1b1b1b; --page: #fff; --soft: #f3f4f6; --line: #c9ccd1;
  --accent: #005a9c; }
@media (prefers-color-scheme: dark) { :root { --text: #e6e6e6; --page: #15171a; --soft: #22262b;
  --line: #4a5058; --accent: #7db9e8; } }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 1rem 1.5rem 4rem; max-width: 72rem; color: var(--text);
  background: var(--page); font: 1rem/1.5 system-ui, "DejaVu Sans", sans-serif; }
h1 { line-height: 1.2; margin-bottom: .2rem; }
h2 { margin-top: 2.5rem; border-bottom: 2px solid var(--line); }
a { color: var(--accent); }
nav ul { display: flex; flex-wrap: wrap; gap: .2rem 1.2rem; padding: 0; list-style: none; }
.lead { font-size: 1.1rem; }
.figures { display: grid; grid-template-columns: repeat(auto-fill, minmax(20rem, 1fr)); gap: 1rem; }
figure { margin: 0; padding: .5rem; border: 1px solid var(--line); border-radius: .4rem;
  break-inside: avoid; }
figure img { display: block; width: 100%; height: auto; background: #fff; border-radius: .2rem; }
figcaption { font-size: .85rem; margin-top: .4rem; overflow-wrap: anywhere; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; margin: 1rem 0; font-size: .9rem; }
caption { text-align: left; font-weight: 600; padding: .3rem 0; }
th, td { text-align: left; vertical-align: top; padding: .25rem .7rem; border-bottom: 1px solid
  var(--line); }
thead th { background: var(--soft); }
td.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
th button { font: inherit; font-weight: 600; color: inherit; background: none; border: 0; padding: 0;
  cursor: pointer; text-align: left; }
th[aria-sort=ascending] button::after { content: " \25B2"; }
th[aria-sort=descending] button::after { content: " \25BC"; }
.note { background: var(--soft); border-left: .3rem solid var(--accent); padding: .5rem .8rem; }
.failed { border-left: .3rem solid #b3261e; padding: .5rem .8rem; background: var(--soft); }
pre { background: var(--soft); padding: .8rem; overflow-x: auto; font-size: .85rem; }
li { margin: .2rem 0; overflow-wrap: anywhere; }
@media print {
  :root { --text: #000; --page: #fff; --soft: #f4f4f4; --line: #999; --accent: #000; }
  @page { margin: 1.5cm; }
  body { max-width: none; padding: 0; font-size: 10pt; }
  nav { display: none; }
  h2, h3, caption { break-after: avoid; }
  tr, figure { break-inside: avoid; }
  .figures { grid-template-columns: repeat(2, 1fr); }
  .wide, pre { overflow: visible; }
  table { font-size: 8pt; }
  td.number { white-space: normal; }
}
)";

// A click on the head of a column sorts the rows, numbers by value; a second one turns them round.
const char* const PageScript = R"(
document.querySelectorAll("table.sortable").forEach(function (table) {
  var body = table.tBodies[0];
  Array.from(table.tHead.rows[0].cells).forEach(function (head, column) {
    var button = document.createElement("button");
    button.type = "button";
    button.textContent = head.textContent;
    head.textContent = "";
    head.appendChild(button);
    button.addEventListener("click", function () {
      var up = head.getAttribute("aria-sort") !== "ascending";
      Array.from(table.tHead.rows[0].cells).forEach(function (other) {
        other.removeAttribute("aria-sort");
      });
      head.setAttribute("aria-sort", up ? "ascending" : "descending");
      var rows = Array.from(body.rows);
      rows.sort(function (a, b) {
        var u = a.cells[column].textContent, v = b.cells[column].textContent;
        var x = parseFloat(u), y = parseFloat(v);
        var order = isNaN(x) || isNaN(y) ? u.localeCompare(v) : x - y;
        return up ? order : -order;
      });
      rows.forEach(function (row) { body.appendChild(row); });
    });
  });
});
)";

} // namespace pemesh
