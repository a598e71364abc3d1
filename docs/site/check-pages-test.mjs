// Shows that check-pages.mjs finds each fault that it looks for:
//
//   node check-pages-test.mjs
//
// Opens a page for each kind of fault, and pages without a fault; these in a browser that writes much on standard error. The exit
// status is 1 if a fault is not told, or is told of a good page. Run from the folder where axe-core and puppeteer-core are.
import {spawnSync} from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import {fileURLToPath} from "node:url";

const drawn = (inside, math = "<math><mi>x</mi></math>", hidden = " aria-hidden='true'") =>
  `<span class="katex"><span class="katex-mathml">${math}</span><span class="katex-html"${hidden}>${inside}</span></span>`;

// Name: what the page holds, and what has to be told of it.
const pages = {
  good: ["<p>Colours of a formula, " + drawn("<span class='misprint'>x</span>y") +
         ".</p><details><summary>More</summary><p>Text.</p></details>"],
  eq_1: ["<p>The page of an equation.</p>"],
  eq_A_2: ["<p>This is not its page.</p>", "is not the page of an equation, but headed: eq_A_2"],
  good_link: ["<p>A formula, " + drawn("x") + ", and <a href='good.html'>a link</a>.</p>"],
  raw: ["<p>Here \\f$ is left, and \\(x\\) as well.</p>", "raw formula in the text: Here"],
  tex: ["<p>Here \\frac{1}{2} is left.</p>", "raw formula in the text: Here"],
  rejected: ["<p>" + drawn("<span class='katex-error'>\u005cfoo</span>") + "</p>", "a formula was rejected: "],
  left_out: ["<p>Here is " + drawn("") + " nothing.</p>", "1 formulas are not drawn"],
  mute: ["<p>" + drawn("x", "<math></math>") + "</p>", "1 formulas have nothing for who listens"],
  strokes: ["<p>" + drawn("x", undefined, "") + "</p>", "1 formulas would be read stroke by stroke"],
  stop: ["<p class='formulaDsp' tabindex='0'>" + drawn("x") + "</p>", "1 needless stops of the keyboard at formulas"],
  folded: ["<details>A part that nothing names.</details>", "1 folded parts have no name"],
  wide: ["<div style='width: 500px'>Wider than a telephone.</div>", "is 1?\\d\\d pixels too wide at 375"],
  wide_unfolded: ["<details><summary>More</summary><div style='width: 500px'>Wide.</div></details>",
                  "is 1?\\d\\d pixels too wide at 375, unfolded"],
  scrolls: ["<p class='formulaDsp' style='overflow-x: auto' tabindex='0'><span style='display: block; width: 500px'>x</span></p>",
            "1 formulas scroll at 375"],
  console: ["<script>console.error('of the page')</script>", "console: of the page"],
  script: ["<script>throw new Error('of the page')</script>", "script: of the page"],
  missing: ["<img src='missing.png' alt='missing'>", "not loaded: file:.*missing.png"],
  call: ["<img src='http://127.0.0.1:9/image.png' alt='elsewhere'>", "calls another host: http://127"],
  inside: ["<p>" + drawn("x<img src='data:image/gif;base64,R0lGODlhAQABAAAAACw='>", undefined, "") + "</p>", "axe, light: image-alt"],
  nameless: ["<img src='data:image/gif;base64,R0lGODlhAQABAAAAACw='>", "axe, light: image-alt"],
  dark: ["<style>@media (prefers-color-scheme: dark) { p { color: #333; background: #222; } }</style><p>Too dark.</p>",
         "axe, dark: color-contrast"],
  within_fold: ["<details><summary>More</summary><p style='color: #ccc'>Too pale.</p></details>", "axe, light: color-contrast"],
  stroke: ["<p>" + drawn("<span>a</span><span>b</span><span style='color: #ccc'>c</span>") + "</p>",
           "axe, light: color-contrast, 1 times"],
  stroke_in_dark: ["<style>@media (prefers-color-scheme: dark) { p { background: #fff; } .pale { color: #ccc; } }</style><p>" +
                   drawn("<span>a</span><span>b</span><span class='pale'>c</span>") + "</p>", "axe, dark: color-contrast, 1 times"],
  busy: ["<script>addEventListener('load', () => setTimeout(() => { for (;;); }))</script>",
         "could not be looked at, .*: no end within"],
};

const folder = fs.mkdtempSync(path.join(os.tmpdir(), "check-pages-"));
process.on("exit", () => fs.rmSync(folder, {recursive: true}));
for (const [name, [body]] of Object.entries(pages))
  fs.writeFileSync(path.join(folder, name + ".html"), `<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width"><title>${name}</title></head>
<body><main><h1>${name === "eq_1" ? "Equation (1)" : name}</h1>${body}</main></body></html>`);
const equations = path.join(folder, "equations.json");
fs.writeFileSync(equations, JSON.stringify(["1", "A.2", "3"].map((equation) => ({equation}))));
const chromium = process.env.CHROMIUM ?? "/usr/bin/chromium";
const talking = path.join(folder, "chromium");
fs.writeFileSync(talking, `#!/bin/sh\nexec ${chromium} --enable-logging=stderr --v=2 "$@"\n`, {mode: 0o755});

const checker = fileURLToPath(new URL("check-pages.mjs", import.meta.url));

function check(environment, ...options) {
  const given = [checker, folder, path.join(folder, "report.json"), "--limit", "20", "--equations", equations, ...options];
  return spawnSync(process.execPath, given, {encoding: "utf8", env: {...process.env, ...environment}});
}

const wrong = [];
const all = check({});
for (const [name, [, fault]] of Object.entries(pages))
  if (fault ? !new RegExp("^" + name + "\\.html: " + fault, "m").test(all.stderr) : all.stderr.includes(name + ".html"))
    wrong.push(fault ? name + ".html is not told: " + fault : name + ".html has no fault");
if (!/^Equation \(3\) has no page eq_3\.html$/m.test(all.stderr)) wrong.push("an equation without a page is not told");
if (all.stderr.includes("Equation (1)")) wrong.push("an equation with a page is told");
if (all.status !== 1) wrong.push("exit status " + all.status + " with faults");
const good = check({CHROMIUM: talking}, "--only", "^good");
if (good.status !== 0) wrong.push("exit status " + good.status + " without a fault");
for (const each of wrong) console.error("check-pages-test: " + each);
if (wrong.length) console.error(all.stdout + all.stderr + good.stdout + good.stderr);
else console.log(Object.values(pages).filter(([, fault]) => fault).length + " pages with a fault each are told, good ones are not");
process.exit(wrong.length ? 1 : 0);
