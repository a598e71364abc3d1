// Opens every page of the site in headless Chromium and looks for what a reader would trip over:
//
//   node check-pages.mjs SITE REPORT.json [--only REGEXP] [--screenshots FOLDER]
//
// An error in the console, a file that is not there, a call to another host; raw \f or \( left in the text; a formula that MathJax
// left out or rejected; a page wider than the window at 375 or 1280 pixels; a serious fault by axe-core, in light and dark,
// listings by sample. One line a fault on standard error; exit status 1 where there is any, 2 for usage. Run from the folder where
// axe-core and puppeteer-core are.
import {createRequire} from "node:module";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import {pathToFileURL} from "node:url";

const from_here = createRequire(path.join(process.cwd(), "package.json"));
const puppeteer = (await import(pathToFileURL(from_here.resolve("puppeteer-core")))).default;
const axe = fs.readFileSync(from_here.resolve("axe-core/axe.min.js"), "utf8");

const [site, report, ...options] = process.argv.slice(2);
const option = (name) => { const at = options.indexOf(name); return at < 0 ? undefined : options[at + 1]; };
if (!site || !report) {
  console.error("usage: node check-pages.mjs SITE REPORT.json [--only REGEXP] [--screenshots FOLDER]");
  process.exit(2);
}
const only = new RegExp(option("--only") ?? ".");
const pictures = option("--screenshots");
const pages = fs.readdirSync(site).filter((name) => name.endsWith(".html") && only.test(name)).sort();
if (pages.length === 0) {
  console.error("check-pages: there is no page in " + site);
  process.exit(1);
}

const widths = [1280, 375];
// Listings that Doxygen makes, alike but for their lines: all are opened, axe-core looks at every so many of them.
const of_one_shape = /(_source|_8cpp|-members)\.html$|^(dir_|functions|namespacemembers|globals)/;
const every_so_many = 20;
const faults = [];
const count = {pages: 0, formulas: 0, links: 0, accessibility_rules: 0};

// In the page: what is wrong with its formulas and its text, once MathJax is through.
async function look() {
  const raw = [];
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  for (let node = walker.nextNode(); node; node = walker.nextNode()) {
    if (node.parentElement.closest("script, style, pre, code, .fragment, .MathJax_SVG, .MathJax_SVG_Display, .MJX_Assistive_MathML")) continue;
    const found = /\\f[$[\]{}]?|\\[()[\]]|\$\$|source:[a-z]/.exec(node.textContent);
    if (found) raw.push(node.textContent.trim().slice(0, 80));
  }
  const wanted = document.querySelectorAll("script[type^='math/tex']").length;
  const made = window.MathJax ? MathJax.Hub.getAllJax().length : 0;
  const wrong = [...document.querySelectorAll(".merror, [data-mml-node='merror'], .MathJax_Error")].map((e) => e.textContent.slice(0, 80));
  const empty = [...document.querySelectorAll(".MathJax_SVG")].filter((e) => !e.querySelector("svg")).length;
  return {raw, wanted, made, wrong, empty, links: document.links.length};
}

async function check(browser, name, at) {
  const page = await browser.newPage();
  const say = (text) => faults.push(name + ": " + text);
  page.on("console", (message) => { if (message.type() === "error") say("console: " + message.text()); });
  page.on("pageerror", (error) => say("script: " + error.message));
  page.on("requestfailed", (request) => say("not loaded: " + request.url()));
  page.on("request", (request) => { if (!/^(file|data|blob):/.test(request.url())) say("calls another host: " + request.url()); });
  try {
    await page.setViewport({width: widths[0], height: 900});
    await page.goto(pathToFileURL(path.resolve(site, name)).href, {waitUntil: "load", timeout: 120000});
    await page.evaluate(() => window.MathJax ? new Promise((done) => MathJax.Hub.Queue(done)) : undefined);
    const seen = await page.evaluate(look);
    for (const text of seen.raw) say("raw formula in the text: " + text);
    for (const text of seen.wrong) say("MathJax rejects a formula: " + text);
    if (seen.made !== seen.wanted || seen.empty) say(seen.wanted - seen.made + seen.empty + " formulas are not rendered");
    count.formulas += seen.made;
    count.links += seen.links;
    for (const width of widths) {
      if (width !== widths[0]) await page.setViewport({width, height: 800});
      const wide = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
      if (wide > 0) say("is " + wide + " pixels too wide at " + width);
    }
    await page.setViewport({width: widths[0], height: 900});
    const asked = !of_one_shape.test(name) || at % every_so_many === 0;
    if (asked) await page.evaluate(axe);
    for (const scheme of asked ? ["light", "dark"] : []) {
      await page.emulateMediaFeatures([{name: "prefers-color-scheme", value: scheme}]);
      const options = scheme === "light" ? {resultTypes: ["violations"]} : {resultTypes: ["violations"], runOnly: ["color-contrast"]};
      const result = await page.evaluate((o) => axe.run({exclude: [".MathJax_SVG"]}, o), options);
      count.accessibility_rules += result.passes.length;
      for (const each of result.violations.filter((v) => v.impact === "serious" || v.impact === "critical"))
        say("axe, " + scheme + ": " + each.id + ", " + each.nodes.length + " times, first " + each.nodes[0].html.slice(0, 120));
      if (pictures)
        for (const width of widths) {
          await page.setViewport({width, height: 900});
          await page.screenshot({path: path.join(pictures, name + "-" + width + "-" + scheme + ".png")});
        }
    }
    if (++count.pages % 200 === 0) console.log(count.pages + " of " + pages.length + " pages");
  } catch (error) {
    say("could not be looked at: " + error.message);
  } finally {
    await page.close();
  }
}

// A browser for each processor: one tab in front of another would stand still.
const waiting = pages.map((name, at) => ({name, at}));
await Promise.all(Array.from({length: os.cpus().length}, async () => {
  const browser = await puppeteer.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: ["--allow-file-access-from-files", "--disable-dev-shm-usage", ...(process.getuid() === 0 ? ["--no-sandbox"] : [])],
    protocolTimeout: 120000,
  });
  for (let next = waiting.shift(); next; next = waiting.shift()) await check(browser, next.name, next.at);
  await browser.close();
}));

fs.writeFileSync(report, JSON.stringify({...count, faults}, null, 1) + "\n");
for (const fault of faults.sort()) console.error(fault);
console.log(count.pages + " pages at " + widths.join(" and ") + " pixels, " + count.formulas + " formulas, " + count.links + " links, " +
            faults.length + " faults");
process.exit(faults.length ? 1 : 0);
