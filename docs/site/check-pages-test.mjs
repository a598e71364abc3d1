// Shows that check-pages.mjs finds each fault that it looks for:
//
//   node check-pages-test.mjs
//
// Opens a page for each kind of fault, and one without a fault; the good one in a browser that writes much on standard error. Exit status 1 where a fault is not told, or is told of the good page. Run from the folder where
// axe-core and puppeteer-core are.
import {spawnSync} from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import {fileURLToPath} from "node:url";

const drawn = (inside, math = "<math><mi>x</mi></math>", hidden = " aria-hidden='true'") =>
  `<span class="katex"><span class="katex-mathml">${math}</span><span class="katex-html"${hidden}>${inside}</span></span>`;

// Name: what the page holds, and what has to be told of it.
const pages = {
  good: ["<p>A formula, " + drawn("x") + ", and <a href='good.html'>a link</a>.</p>"],
  raw: ["<p>Here \\f$ is left, and \\(x\\) as well.</p>", "raw formula in the text: Here"],
  tex: ["<p>Here \\frac{1}{2} is left.</p>", "raw formula in the text: Here"],
  rejected: ["<p>" + drawn("<span class='katex-error'>\u005cfoo</span>") + "</p>", "a formula was rejected: "],
  left_out: ["<p>Here is " + drawn("") + " nothing.</p>", "1 formulas are not drawn"],
  mute: ["<p>" + drawn("x", "<math></math>") + "</p>", "1 formulas have nothing for who listens"],
  strokes: ["<p>" + drawn("x", undefined, "") + "</p>", "1 formulas would be read stroke by stroke"],
  stop: ["<p class='formulaDsp' tabindex='0'>" + drawn("x") + "</p>", "1 needless stops of the keyboard at formulas"],
  folded: ["<details>A part that nothing names.</details>", "1 folded parts have no name"],
  wide: ["<div style='width: 500px'>Wider than a telephone.</div>", "is 1?\\d\\d pixels too wide at 375"],
  console: ["<script>console.error('of the page')</script>", "console: of the page"],
  script: ["<script>throw new Error('of the page')</script>", "script: of the page"],
  missing: ["<img src='missing.png' alt='missing'>", "not loaded: file:.*missing.png"],
  call: ["<img src='http://127.0.0.1:9/image.png' alt='elsewhere'>", "calls another host: http://127"],
  inside: ["<p>" + drawn("x<img src='data:image/gif;base64,R0lGODlhAQABAAAAACw='>", undefined, "") + "</p>", "axe, light: image-alt"],
  nameless: ["<img src='data:image/gif;base64,R0lGODlhAQABAAAAACw='>", "axe, light: image-alt"],
  dark: ["<style>@media (prefers-color-scheme: dark) { p { color: #333; background: #222; } }</style><p>Too dark.</p>",
         "axe, dark: color-contrast"],
  busy: ["<script>addEventListener('load', () => setTimeout(() => { for (;;); }))</script>",
         "could not be looked at, .*: no end within"],
};

const folder = fs.mkdtempSync(path.join(os.tmpdir(), "check-pages-"));
process.on("exit", () => fs.rmSync(folder, {recursive: true}));
for (const [name, [body]] of Object.entries(pages))
  fs.writeFileSync(path.join(folder, name + ".html"), `<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width"><title>${name}</title></head>
<body><main><h1>${name}</h1>${body}</main></body></html>`);
const chromium = process.env.CHROMIUM ?? "/usr/bin/chromium";
const talking = path.join(folder, "chromium");
fs.writeFileSync(talking, `#!/bin/sh\nexec ${chromium} --enable-logging=stderr --v=2 "$@"\n`, {mode: 0o755});

const checker = fileURLToPath(new URL("check-pages.mjs", import.meta.url));

function check(environment, ...options) {
  return spawnSync(process.execPath, [checker, folder, path.join(folder, "report.json"), "--limit", "20", ...options],
                   {encoding: "utf8", env: {...process.env, ...environment}});
}

const wrong = [];
const all = check({});
for (const [name, [, fault]] of Object.entries(pages))
  if (fault ? !new RegExp("^" + name + "\\.html: " + fault, "m").test(all.stderr) : all.stderr.includes(name + ".html"))
    wrong.push(fault ? name + ".html is not told: " + fault : name + ".html has no fault");
if (all.status !== 1) wrong.push("exit status " + all.status + " with faults");
const good = check({CHROMIUM: talking}, "--only", "^good");
if (good.status !== 0) wrong.push("exit status " + good.status + " without a fault");
for (const each of wrong) console.error("check-pages-test: " + each);
if (wrong.length) console.error(all.stdout + all.stderr + good.stdout + good.stderr);
else console.log((Object.keys(pages).length - 1) + " pages with a fault each are told, a good one is not");
process.exit(wrong.length ? 1 : 0);
