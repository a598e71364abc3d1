// Draws the formulas of the finished site with KaTeX, so that a page is delivered with them:
//
//   node draw-formulas.mjs SITE DATA KATEX
//
// A formula becomes HTML for the eye and MathML for who listens; in the steps of a derivation, which are long and folded, and on a
// page with more than `most_of_formulas`, MathML is for both, a quarter of the elements. formulas.js draws those of long
// pages in the browser, when they come near the window. In displayed formulas of the equations' pages the symbols of
// DATA/symbols.json carry the number of their entry, for reader.js. SITE/symbols.js and SITE/statements.js hold the meanings of
// the symbols and the statements of the equations, drawn. KATEX is the folder of katex.min.js. A formula that KaTeX rejects,
// as it stands or in the lines of formulas.js, and one whose lines have other symbols or another value is told, a line each; exit status 1 if there
// is any.
import {createRequire} from "node:module";
import fs from "node:fs";
import path from "node:path";
import {values_of} from "./value-of-formula.mjs";

const [site, data, folder] = process.argv.slice(2);
if (!folder) {
  console.error("usage: node draw-formulas.mjs SITE DATA KATEX");
  process.exit(2);
}
const katex = createRequire(import.meta.url)(path.resolve(folder, "katex.min.js"));
const symbols = JSON.parse(fs.readFileSync(path.join(data, "symbols.json"), "utf8"));
const statements = JSON.parse(fs.readFileSync(path.join(data, "statements.json"), "utf8"));
globalThis.window = {};
(0, eval)(fs.readFileSync(new URL("formulas.js", import.meta.url), "utf8"));
const faults = new Set(), displayed_formulas = new Set();

const plain_of = {"&lt;": "<", "&gt;": ">", "&amp;": "&", "&quot;": '"', "&#39;": "'", "&#160;": " "};
const plain = (text) => text.replace(/&(lt|gt|amp|quot|#39|#160);/g, (entity) => plain_of[entity]);
const html = (text) => text.replace(/&/g, "&amp;").replace(/</g, "&lt;").replace(/>/g, "&gt;").replace(/"/g, "&quot;");

// A symbol with its index, its primes and its exponent; the longest first. A letter stands alone: not within a word or a command.
const names = [];
symbols.forEach((symbol, at) => symbol.latex.forEach((latex) => names.push({latex, at})));
names.sort((a, b) => b.latex.length - a.latex.length);
const escaped = (text) => text.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");
const any = new RegExp("(\\\\(?:text|mathrm|operatorname|begin|end|tag)\\{[^{}]*\\})|(?<![\\\\A-Za-z_^])(?:" +
                       names.map((name) => "(?:" + escaped(name.latex) + ")").join("|") +
                       ")(?![A-Za-z_])(?:\\^(?:\\{[^{}]*\\}|[^{}\\\\]))?'*", "g");
const number_of = new Map(names.map((name) => [name.latex, name.at]));

function marked(latex) {
  return latex.replace(any, (found, word) => {
    if (word) return found;
    const name = names.find((each) => found.startsWith(each.latex));
    return name ? "\\htmlData{symbol=" + number_of.get(name.latex) + "}{" + found + "}" : found;
  });
}

// KaTeX takes a prime for a superscript, and a second one after it for a mistake: x'_{k0}^{(N)} is x_{k0}^{\prime(N)}.
const one_superscript = (latex) => latex.replace(/('+)(_(?:\{[^{}]*\}|[A-Za-z0-9]))\^(?:\{([^{}]*)\}|([A-Za-z0-9]))/g,
                                                 (_, primes, below, group, letter) =>
                                                     below + "^{" + "\\prime ".repeat(primes.length) + (group ?? letter) + "}");

const macros = {"\\misprint": "\\htmlClass{misprint}{#1}", "\\mended": "\\htmlClass{mended}{#1}"};
const unmarked = (latex) => latex.replace(/\\(misprint|mended)(?=\{)/g, "");
// MathML has the marks as colours, which become classes.
const as_colours = {"\\misprint": "\\textcolor{misprint}{#1}", "\\mended": "\\textcolor{mended}{#1}"};
const drawn = new Map();

function draw(given, displayed, explained, where, output = "htmlAndMathml") {
  const latex = one_superscript(given);
  if (displayed) displayed_formulas.add(latex);
  const key = (displayed ? "d" : "t") + (explained ? "e" : "") + output + latex;
  if (drawn.has(key)) return drawn.get(key);
  const only_mathml = output !== "htmlAndMathml";
  const options = {displayMode: displayed, throwOnError: true, trust: true, strict: false, macros: {...(only_mathml ? as_colours : macros)},
                   output: only_mathml ? "mathml" : output};
  let out = "";
  try {
    if (explained) {
      try { out = katex.renderToString(marked(latex), options); } catch { /* a symbol within a group that must stay whole */ }
    }
    if (!out) out = katex.renderToString(latex, options);
  } catch (error) {
    faults.add(where + ": " + latex.slice(0, 120) + ": " + error.message);
    return html(latex);
  }
  const tex = html(unmarked(latex).trim());
  out = out.replace(/<annotation encoding="application\/x-tex">[\s\S]*?<\/annotation>/,
                    () => '<annotation encoding="application/x-tex">' + tex + "</annotation>");
  if (only_mathml)
    out = out.replace(/^<span class="katex">|<\/span>$/g, "").replace(/ mathcolor="(misprint|mended)"/g, ' class="$1"');
  if (output === "later") out = out.replace("<math", '<math class="later"');
  if (tex !== html(latex.trim())) out = out.replace("<math", () => '<math data-tex="' + html(latex.trim()) + '"');
  drawn.set(key, out);
  return out;
}

const displays = /(?<!\\)\\\[([\s\S]*?)(?<!\\)\\\]/g, inlines = /(?<!\\)\\\(([\s\S]*?)(?<!\\)\\\)([,.;:)]+)?/g;
const untouched = /<(script|style|pre|code|textarea|title)\b[\s\S]*?<\/\1>|<div class="fragment"[\s\S]*?<!-- fragment -->|<!--[\s\S]*?-->|<[^>]*>/g;

// Browsers break a line between a formula and a comma. A short formula keeps the sign that follows it.
const longest_unbroken = 24;
const with_sign = (formula, latex, sign = "") =>
    sign && latex.length <= longest_unbroken ? '<span class="unbroken">' + formula + sign + "</span>" : formula + sign;

function draw_in(text, explained, where, output) {
  return text.replace(displays, (_, latex) => draw(plain(latex), true, explained, where, output))
             .replace(inlines, (_, latex, sign) => with_sign(draw(plain(latex), false, false, where, output), latex, sign));
}

function draw_page(page, explained, where, usual) {
  let out = "", from = 0, output = usual;
  for (const found of page.matchAll(untouched)) {
    out += draw_in(page.slice(from, found.index), explained && !output, where, output) + found[0];
    from = found.index + found[0].length;
    if (/^<\/?ol/.test(found[0])) output = found[0] === '<ol class="steps">' ? "mathml" : usual;
  }
  return out + draw_in(page.slice(from), explained, where, usual);
}

const most_of_formulas = 300000; // bytes of a page

let formulas = 0, pages = 0;
for (const name of fs.readdirSync(site).filter((each) => each.endsWith(".html") && !each.endsWith("_source.html"))) {
  const file = path.join(site, name), before = fs.readFileSync(file, "utf8");
  if (!/\\[([]/.test(before)) continue;
  let after = draw_page(before, name.startsWith("eq_"), name);
  if (after === before) continue;
  if (after.length - before.length > most_of_formulas) after = draw_page(before, false, name, "later");
  ++pages;
  formulas += after.split("<math").length - 1;
  fs.writeFileSync(file, after);
}

const meanings = symbols.map((each) => ({
  symbol: draw(each.latex[0], false, false, "symbols"),
  meaning: draw_page(each.meaning, false, "symbols"),
  units: each.units,
  equations: each.equations,
}));
fs.writeFileSync(path.join(site, "symbols.js"), "window.siteSymbols = " + JSON.stringify(meanings) + ";\n");
const shown = {};
for (const [number, each] of Object.entries(statements))
  shown[number] = {said: draw_page(each.said, false, "(" + number + ")"), drawn: draw(each.latex, true, false, "(" + number + ")", "mathml")};
fs.writeFileSync(path.join(site, "statements.js"), "window.siteStatements = " + JSON.stringify(shown) + ";\n");

// The lines of a formula have its symbols in its order, brackets and places of alignment apart, and its value.
const symbols_of = (tex) => tex.replace(/\\(allowbreak|nobreak|misprint|mended|tag|text|q?quad|[bB]ig[lr]?)(?![A-Za-z])|\\(left|right)(?![A-Za-z])\.?/g, "")
                               .replace(/\\(begin|end)\{(aligned|gathered|cases|split)\}|\\\\|&|[{}()\s]/g, "");
function without_marks(tex) {
  const mark = /\\(?:misprint|mended)\{/.exec(tex);
  if (!mark) return tex;
  const start = mark.index + mark[0].length;
  let end = start;
  for (let depth = 1; depth > 0; ++end) {
    if (tex[end] === "\\") ++end;
    else depth += tex[end] === "{" ? 1 : tex[end] === "}" ? -1 : 0;
  }
  return without_marks(tex.slice(0, mark.index) + tex.slice(start, end - 1) + tex.slice(end));
}
let evaluated = 0;
for (const latex of displayed_formulas) {
  const values = values_of(without_marks(latex));
  evaluated += values ? 1 : 0;
  for (const level of [1, 2, 3]) {
    try {
      const rows = window.siteFormulas.rows_of(latex, level);
      rows.forEach((row) => katex.renderToString(row, {displayMode: true, trust: true, strict: false, macros: {...macros}}));
      const in_lines = values && values_of(window.siteFormulas.rows_of(without_marks(latex), level).join(" "));
      if (values && !(in_lines && values.length === in_lines.length && values.every((x, at) => Math.abs(x - in_lines[at]) <= 1e-9 * (1 + Math.abs(x)))))
        faults.add("another value in lines at level " + level + ": " + latex.slice(0, 120));
      if (level === 1 && symbols_of(rows.join("")) !== symbols_of(latex)) faults.add("other symbols in lines: " + latex.slice(0, 120));
    } catch (error) {
      faults.add("in lines at level " + level + ": " + latex.slice(0, 120) + ": " + error.message);
    }
  }
}

for (const fault of faults) console.error("draw-formulas: " + fault);
console.log(formulas + " formulas drawn on " + pages + " pages; " + displayed_formulas.size + " displayed ones have lines for narrow windows, " + evaluated +
            " of them compared in value");
process.exit(faults.size ? 1 : 0);
