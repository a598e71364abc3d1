// Clicks and seconds from "I am at this equation" to its proof, function, figure and tests, in a site or in two:
//
//   node measure-ways.mjs SITE [SITE...] [--json FILE]
//
// Opens the pages of ten equations at 1280 by 900 pixels and looks for each of the four: a link to it that is in sight costs a
// click, a fold that hides it another, and without such a link one scrolls. What is told: clicks, pixels to scroll, seconds
// until the page is loaded and until the last formula in sight is drawn, height of the page. Needs puppeteer-core, as
// check-pages.mjs does.
import {createRequire} from "node:module";
import fs from "node:fs";
import path from "node:path";
import {pathToFileURL} from "node:url";

const from_here = createRequire(path.join(process.cwd(), "package.json"));
const puppeteer = (await import(pathToFileURL(from_here.resolve("puppeteer-core")))).default;

const options = process.argv.slice(2), at = options.indexOf("--json");
const file = at < 0 ? "" : options.splice(at, 2)[1];
if (options.length === 0) {
  console.error("usage: node measure-ways.mjs SITE [SITE...] [--json FILE]");
  process.exit(2);
}
const equations = ["12", "23", "28", "40", "46", "52", "57", "69", "86", "A_12"];

// In the page: the ways to what is looked for. Its own proof is the first claim whose name begins with the equation's number.
function ways(number) {
  const label = number.replace(".", "_"), height = innerHeight;
  const heading = (pattern) => [...document.querySelectorAll("h2, h3")].find((e) => pattern.test(e.textContent.trim()));
  const claim = document.querySelector("[id^='claim_" + label + "_']");
  const targets = {
    proof: claim?.closest("details, .claim") ?? heading(/proof/i),
    function: heading(/^the function|^functions?$/i),
    figure: heading(/^figures?$/i),
    tests: heading(/^tests?$/i),
  };
  const found = {};
  for (const [name, target] of Object.entries(targets)) {
    if (!target) {
      found[name] = null;
      continue;
    }
    const y = Math.round(target.getBoundingClientRect().top + scrollY), section = heading(new RegExp(name, "i"));
    const link = [...document.querySelectorAll("main a[href*='#'], body a[href^='#']")].find((a) => {
      const box = a.getBoundingClientRect(), id = a.hash.slice(1), place = id && document.getElementById(id);
      return box.height > 0 && box.bottom < height && place && Math.abs(place.getBoundingClientRect().top - (section ?? target).getBoundingClientRect().top) < 60;
    });
    const after = link ? document.getElementById(link.hash.slice(1)).getBoundingClientRect().top + scrollY : 0;
    const folded = target.closest("details:not([open])") ? 1 : 0;
    const scroll = Math.max(0, Math.round(y - after - 0.7 * height)); // until it is in sight with some lines below it
    found[name] = {clicks: (link && y > 0.7 * height ? 1 : 0) + folded, scroll: y > 0.7 * height ? scroll : 0, at: y};
  }
  return {found, height: document.documentElement.scrollHeight, raw: /\\\(|\\\[/.test(document.body.innerText)};
}

const results = [];
for (const site of options) {
  const browser = await puppeteer.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: ["--allow-file-access-from-files", "--disable-dev-shm-usage", ...(process.getuid() === 0 ? ["--no-sandbox"] : [])],
    protocolTimeout: 300000,
  });
  browser.process().stderr.resume();
  const [page] = await browser.pages();
  await page.setViewport({width: 1280, height: 900});
  for (const equation of equations) {
    const start = Date.now();
    await page.goto(pathToFileURL(path.resolve(site, "eq_" + equation + ".html")).href, {waitUntil: "load", timeout: 300000});
    const loaded = (Date.now() - start) / 1000;
    // MathJax draws in the browser, after the page is loaded.
    await page.evaluate(() => window.MathJax?.Hub ? new Promise((done) => MathJax.Hub.Queue(() => done())) : document.fonts.ready.then(() => 0));
    const drawn = (Date.now() - start) / 1000;
    const seen = await page.evaluate(ways, equation);
    results.push({site, equation: equation.replace("_", "."), loaded, drawn, height: seen.height, ...seen.found});
    const told = Object.entries(seen.found).map(([name, way]) => name + (way ? " " + way.clicks + " clicks, " + way.scroll + " px" : " none"));
    console.log(path.basename(path.resolve(site)) + " (" + equation.replace("_", ".") + "): " + told.join("; ") + "; loaded " + loaded.toFixed(2) + " s, drawn " +
                drawn.toFixed(2) + " s, " + seen.height + " px high");
  }
  await browser.close();
}
if (file) fs.writeFileSync(file, JSON.stringify(results, null, 1) + "\n");
