// Clicks from "I am at (57)" to what a reader wants of an equation:
//
//   node paths.mjs SITE [EQUATION...]
//
// Opens the page of each equation at 1280 by 900 pixels and looks, as a reader would, for its own proof, its function, a test and
// a figure: what is on the screen is there; what is further down costs a click on the contents, or a second for each screen that
// is scrolled; a folded part costs a click. Prints a line an equation with clicks, seconds until the page is drawn, and pixels to
// each target. Run from the folder where puppeteer-core is.
import {createRequire} from "node:module";
import path from "node:path";
import {pathToFileURL} from "node:url";

const from_here = createRequire(path.join(process.cwd(), "package.json"));
const puppeteer = (await import(pathToFileURL(from_here.resolve("puppeteer-core")))).default;
const [site, ...given] = process.argv.slice(2);
if (!site) {
  console.error("usage: node paths.mjs SITE [EQUATION...]");
  process.exit(2);
}
const equations = given.length ? given : ["26", "28", "38", "40", "46", "52", "57", "69", "A.7", "A.12"];
const browser = await puppeteer.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--allow-file-access-from-files", "--disable-dev-shm-usage", ...(process.getuid() === 0 ? ["--no-sandbox"] : [])],
});
browser.process().stderr.resume();
const [page] = await browser.pages();
await page.setViewport({width: 1280, height: 900});

// In the page: where the targets are, in pixels from the top, and whether they are folded up.
function targets(equation) {
  const label = "eq_" + equation.replace(".", "_");
  const place = (element) => {
    if (!element) return null;
    const folded = element.closest("details:not([open])");
    const at = folded ?? element;
    return {pixels: Math.round(at.getBoundingClientRect().top + scrollY), folded: folded !== null && folded !== undefined};
  };
  const own = [...document.querySelectorAll(".claim")].find((claim) => {
    const id = claim.querySelector("code")?.textContent ?? "";
    return id.startsWith(equation + "/") && claim.querySelector("ol.steps");
  });
  const any = [...document.querySelectorAll(".claim")].find((claim) => claim.querySelector("ol.steps, a[href*='claim_']"));
  const after = (key, selector) => {
    const heading = document.getElementById(label + "_" + key)?.closest("h1, h2, h3");
    if (!heading) return null;
    return [...document.querySelectorAll(selector)].find((e) => heading.compareDocumentPosition(e) & Node.DOCUMENT_POSITION_FOLLOWING);
  };
  return {
    function: place(after("functions", ".fragment, pre")),
    proof: place(own ?? any),
    test: place(after("tests", "ul.tests li, .tests li")),
    figure: place(document.querySelector(".thumbnail img")),
    height: document.documentElement.scrollHeight,
    stops: document.querySelectorAll("a[href], button, input, select, summary, [tabindex='0']").length,
    links: [...document.querySelectorAll(".eq-contents a")].map((a) => a.getAttribute("href").split("#")[1]),
  };
}

const shown = (target) => target === null ? "none" : target.pixels + " px, " + target.clicks + (target.clicks === 1 ? " click, " : " clicks, ") +
                                                     target.seconds.toFixed(1) + " s";
const sum = {clicks: 0, seconds: 0, count: 0};
for (const equation of equations) {
  const file = path.resolve(site, "eq_" + equation.replace(".", "_") + ".html"), from = Date.now();
  await page.goto(pathToFileURL(file).href, {waitUntil: "load", timeout: 0});
  await page.evaluate(() => window.MathJax ? new Promise((done) => MathJax.Hub.Queue(done)) : document.fonts.ready.then(() => {}));
  const drawn = (Date.now() - from) / 1000;
  const found = await page.evaluate(targets, equation);
  for (const name of ["function", "proof", "test", "figure"]) {
    const target = found[name];
    if (target === null) continue;
    const visible = target.pixels < 900, screens = target.pixels / 900;
    // Off the screen: one click on the contents, or scrolling at a second a screen where that is quicker.
    target.clicks = (target.folded ? 1 : 0) + (visible || screens < 2 ? 0 : 1);
    target.seconds = drawn + target.clicks * 1.5 + (visible ? 0 : Math.min(screens, 2));
    sum.clicks += target.clicks;
    sum.seconds += target.seconds;
    ++sum.count;
  }
  console.log("(" + equation + "): drawn in " + drawn.toFixed(1) + " s, " + found.height + " px, " + found.stops + " stops; function " +
              shown(found.function) + "; proof " + shown(found.proof) + "; test " + shown(found.test) + "; figure " + shown(found.figure));
}
console.log("mean over " + sum.count + " targets: " + (sum.clicks / sum.count).toFixed(2) + " clicks, " + (sum.seconds / sum.count).toFixed(1) +
            " s");
await browser.close();
