// Opens every page of the site in headless Chromium and looks for what a reader would trip over:
//
//   node check-pages.mjs SITE REPORT.json [--only REGEXP] [--screenshots FOLDER] [--limit SECONDS]
//        [--equations EQUATIONS.json]
//
// It looks for an error in the console, a file that is not there, a call to another host; raw \f or \( left in the text; a
// formula that is not drawn, was rejected, scrolls at 375 pixels, or says nothing to a listener; a folded part without a name; a tab stop within a
// formula, or on one that does not scroll; a page wider than the window at 375 or 1280 pixels, with folded parts closed and
// open; an equation of EQUATIONS.json without a page of its own; a serious fault by axe-core in light and dark, with folded
// parts open, on ten pages with all formulas as they are, on the others with each colour of a formula once, and on a sample of
// the pages that are alike but for their lines; a page that does not come to its end within the limit, 300 seconds. Standard
// error has a line for each fault; the exit status is 1 if there is any, 2 for usage. Run from the folder where axe-core and
// puppeteer-core are.
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
  console.error("usage: node check-pages.mjs SITE REPORT.json [--only REGEXP] [--screenshots FOLDER] [--limit SECONDS] " +
                "[--equations EQUATIONS.json]");
  process.exit(2);
}
const only = new RegExp(option("--only") ?? ".");
const pictures = option("--screenshots");
const limit = 1000 * (option("--limit") ?? 300);
const pages = fs.readdirSync(site).filter((name) => name.endsWith(".html") && only.test(name)).sort();
if (pages.length === 0) {
  console.error("check-pages: there is no page in " + site);
  process.exit(1);
}

const widths = [1280, 375];
// Pages that are alike but for their lines: all are opened, axe-core looks at every so many of them.
const of_one_shape = /(_source|_8cpp|_8hpp|_more)\.html$|^(struct|class|namespace)/;
const every_so_many = 20;
// axe-core looks at each stroke of a formula and takes a minute for the strokes of some hundred; on these pages it gets them all.
const with_all_formulas = /^(eq_(28|57|69|A_12)|index|errata|equation_graph|figure_fig08_\w+|accuracy_page|search_page)\.html$/;
const faults = [];
// Heading of each equation's page.
const headings = new Map(!option("--equations") ? [] : JSON.parse(fs.readFileSync(option("--equations"), "utf8"))
  .map(({equation}) => ["eq_" + equation.replace(".", "_") + ".html", "Equation (" + equation + ")"])
  .filter(([name]) => only.test(name)));
const seconds = {}, of_steps = {}; // that each page took, and each step on all pages
const count = {pages: 0, formulas: 0, links: 0, looked_at_by_axe: 0, accessibility_rules: 0};

// In the page: what is wrong with its formulas and its text.
async function look() {
  await document.fonts.ready;
  const raw = [];
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  for (let node = walker.nextNode(); node; node = walker.nextNode()) {
    if (node.parentElement.closest("script, style, pre, code, .fragment, annotation")) continue;
    const found = /\\f[$[\]{}]?|\\[()[\]]|\$\$|source:[a-z]|\\(?:frac|sqrt|beta|zeta|tau|left|right|overline)\b/.exec(node.textContent);
    if (found) raw.push(node.textContent.trim().slice(0, 80));
  }
  const formulas = [...document.querySelectorAll(".katex")];
  const wrong = [...document.querySelectorAll(".katex-error, .katex [color='#cc0000']")].map((e) => e.textContent.slice(0, 80));
  const mute = formulas.filter((e) => !e.querySelector(".katex-mathml math")?.textContent.trim()).length;
  const empty = formulas.filter((e) => {
    const drawn = e.querySelector(".katex-html");
    return !drawn || !drawn.textContent.trim() && !drawn.querySelector("svg");
  }).length;
  const unread = formulas.filter((e) => e.querySelector(".katex-html:not([aria-hidden='true'])")).length;
  const stops = [...document.querySelectorAll(".katex [tabindex], .katex a[href], .katex button")].length +
                [...document.querySelectorAll(".formulaDsp[tabindex]")].filter((e) => e.scrollWidth <= e.clientWidth + 1).length;
  const nameless = document.querySelectorAll("details:not(:has(> summary))").length;
  const folds = document.querySelectorAll("details").length;
  const heading = document.querySelector("h1")?.textContent.trim();
  return {raw, heading, folds, nameless, made: formulas.length, wrong, mute, empty, unread, stops, links: document.links.length};
}

// In the page: opens the folded parts, where axe-core does not look.
function unfold() {
  for (const each of document.querySelectorAll("details")) each.open = true;
}

// In the page, with folded parts open: draws all formulas of a long page, and counts those that scroll.
async function count_scrolling() {
  const places = () => [...document.querySelectorAll(".formulaDsp, table.equations td:nth-child(2)")];
  const scrolling = () => places().filter((each) => each.scrollWidth > each.clientWidth + 1).length;
  const drawn_later = document.querySelectorAll("math.later");
  for (let tries = 0; tries < 50 && !window.siteFormulas && (drawn_later.length || scrolling()); ++tries)
    await new Promise((done) => setTimeout(done, 100));
  if (!window.siteFormulas) return scrolling();
  for (const each of document.querySelectorAll("math.later")) window.siteFormulas.draw(each);
  places().forEach(window.siteFormulas.fit);
  return scrolling();
}

// In the page, in one scheme after the other: what the contrast of a stroke of a formula follows from.
function tell_colours() {
  for (const each of document.querySelectorAll(".katex-html, .katex-html *")) {
    const {color, fontSize, backgroundColor, opacity} = getComputedStyle(each);
    each.seen = (each.seen ?? "") + color + fontSize;
    each.behind = (each.behind ?? "") + each.parentElement.behind + (backgroundColor === "rgba(0, 0, 0, 0)" ? "" : backgroundColor) +
                  (opacity === "1" ? "" : opacity);
  }
}

// In the page: axe-core does not judge the contrast of a single character; what has one gets it twice.
function double_strokes() {
  for (const each of document.querySelectorAll(".katex-html *"))
    for (const node of each.childNodes)
      if (node.nodeType === Node.TEXT_NODE && node.data.trim().length === 1) node.data += node.data;
  dispatchEvent(new Event("resize")); // what is wider now may scroll, and is then a stop of the keyboard
}

// In the page: leaves of the strokes of a formula that have all this in common the first, within all that is around it.
function thin_out() {
  for (const formula of document.querySelectorAll(".katex-html")) {
    const kept = new Set(), kinds = new Set();
    for (const each of formula.querySelectorAll("*")) {
      if (each.matches("span, svg, svg *")) {
        const kind = each.seen + "|" + each.behind;
        if (![...each.childNodes].some((node) => node.nodeType === Node.TEXT_NODE) || kinds.has(kind)) continue;
        kinds.add(kind);
      }
      for (let around = each; around !== formula; around = around.parentElement) kept.add(around);
    }
    for (const each of formula.querySelectorAll("*")) if (!kept.has(each)) each.remove();
  }
}

// A browser with one tab, where one page is opened after the other. Puppeteer reads only the first lines that Chromium writes on
// standard error; with some 170 lines unread, Chromium's process for graphics waits in its write, and every page waits for it.
async function launch() {
  const browser = await puppeteer.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: ["--allow-file-access-from-files", "--disable-dev-shm-usage", ...(process.getuid() === 0 ? ["--no-sandbox"] : [])],
    timeout: limit,
    protocolTimeout: limit,
  });
  browser.process().stderr.resume();
  const [page] = await browser.pages();
  const tab = {browser, page, name: "", step: "", at: (step) => {
    const now = Date.now();
    if (tab.step) of_steps[tab.step] = (of_steps[tab.step] ?? 0) + (now - tab.since) / 1000;
    Object.assign(tab, {step, since: now});
  }, say: (text) => { faults.push(tab.name + ": " + text); console.error(faults.at(-1)); }};
  page.on("console", (message) => { if (message.type() === "error") tab.say("console: " + message.text()); });
  page.on("pageerror", (error) => tab.say("script: " + error.message));
  page.on("requestfailed", (request) => tab.say("not loaded: " + request.url()));
  page.on("request", (request) => {
    if (!/^(file|data|blob):/.test(request.url())) tab.say("calls another host: " + request.url());
  });
  return tab;
}

// A browser that does not close by itself within ten seconds is killed.
async function close({browser}) {
  const kill = setTimeout(() => browser.process().kill("SIGKILL"), 10000);
  await browser.close();
  clearTimeout(kill);
}

async function check(tab, asked) {
  const {page, name, say} = tab;
  const tell_width = async (how) => {
    const {wide, width} = await page.evaluate(() => ({wide: document.documentElement.scrollWidth - innerWidth, width: innerWidth}));
    if (wide > 0) say("is " + wide + " pixels too wide at " + width + how);
  };
  tab.at("load");
  await page.emulateMediaFeatures([{name: "prefers-color-scheme", value: "light"}]);
  await page.setViewport({width: widths[0], height: 900});
  await page.goto(pathToFileURL(path.resolve(site, name)).href, {waitUntil: "load", timeout: 0});
  tab.at("text");
  const seen = await page.evaluate(look);
  if (headings.has(name) && seen.heading !== headings.get(name)) say("is not the page of an equation, but headed: " + seen.heading);
  for (const text of seen.raw) say("raw formula in the text: " + text);
  for (const text of seen.wrong) say("a formula was rejected: " + text);
  if (seen.nameless) say(seen.nameless + " folded parts have no name");
  if (seen.empty) say(seen.empty + " formulas are not drawn");
  if (seen.mute) say(seen.mute + " formulas have nothing for who listens");
  if (seen.unread) say(seen.unread + " formulas would be read stroke by stroke");
  if (seen.stops) say(seen.stops + " needless stops of the keyboard at formulas");
  count.formulas += seen.made;
  count.links += seen.links;
  tab.at("width");
  for (const width of widths) {
    if (width !== widths[0]) await page.setViewport({width, height: 800});
    await tell_width("");
  }
  const schemes = asked ? ["light", "dark"] : [];
  const show = (scheme) => page.emulateMediaFeatures([{name: "prefers-color-scheme", value: scheme}]);
  for (const scheme of pictures ? schemes : [])
    for (const width of widths) {
      await show(scheme);
      await page.setViewport({width, height: 900});
      await page.screenshot({path: path.join(pictures, name + "-" + width + "-" + scheme + ".png")});
    }
  if (seen.folds) {
    tab.at("width, unfolded");
    if (pictures) await page.setViewport({width: widths[1], height: 800});
    await page.evaluate(unfold);
    await tell_width(", unfolded");
  }
  tab.at("formulas that scroll");
  await page.setViewport({width: widths[1], height: 800});
  const scrolling = await page.evaluate(count_scrolling);
  if (scrolling) say(scrolling + " formulas scroll at " + widths[1]);
  if (asked) {
    tab.at("axe, preparing");
    await page.setViewport({width: widths[0], height: 900});
    if (!with_all_formulas.test(name)) {
      for (const scheme of schemes.toReversed()) {
        await show(scheme);
        await page.evaluate(tell_colours);
      }
      await page.evaluate(thin_out);
    }
    await page.evaluate(double_strokes);
    await page.evaluate(axe);
    ++count.looked_at_by_axe;
  }
  for (const scheme of schemes) {
    tab.at("axe, " + scheme);
    await show(scheme);
    const rules = scheme === "light" ? {} : {runOnly: ["color-contrast"]};
    const result = await page.evaluate((o) => axe.run(document, o), {preload: false, resultTypes: ["violations"], ...rules});
    count.accessibility_rules += result.passes.length;
    for (const each of result.violations.filter((v) => v.impact === "serious" || v.impact === "critical"))
      say("axe, " + scheme + ": " + each.id + ", " + each.nodes.length + " times, first " + each.nodes[0].html.slice(0, 120));
  }
  if (++count.pages % 200 === 0) console.log(count.pages + " of " + pages.length + " pages");
}

// The check of the page that is open in a tab, or its fault where the page crashes or time is over; tells which page takes long.
async function within_limit(tab, checked) {
  let tell, end;
  const over = new Promise((_, fail) => {
    tab.page.once("error", fail);
    tell = setInterval(() => console.log(tab.name + " takes long at: " + tab.step), limit / 4);
    end = setTimeout(() => fail(new Error("no end within " + limit / 1000 + " s")), limit);
  });
  await Promise.race([checked, over]).finally(() => {
    clearInterval(tell);
    clearTimeout(end);
    tab.page.removeAllListeners("error");
  });
}

// Puppeteer ends its browsers with this process, but not this process.
process.on("SIGTERM", () => process.exit(143));

// A browser for each processor: one tab in front of another would stand still. After a page without end comes a new browser.
const waiting = pages.map((name, at) => ({name, asked: !of_one_shape.test(name) || at % every_so_many === 0}));
await Promise.all(Array.from({length: os.cpus().length}, async () => {
  let tab = await launch();
  for (let next = waiting.shift(); next; next = waiting.shift()) {
    tab.name = next.name;
    const start = Date.now();
    try {
      await within_limit(tab, check(tab, next.asked));
    } catch (error) {
      tab.say("could not be looked at, at: " + tab.step + ": " + error.message);
      await close(tab);
      console.log("a new browser after " + tab.name);
      tab = await launch();
    }
    tab.at("");
    seconds[next.name] = (Date.now() - start) / 1000;
  }
  await close(tab);
}));

for (const [name, heading] of headings) {
  if (pages.includes(name)) continue;
  faults.push(heading + " has no page " + name);
  console.error(faults.at(-1));
}
const slowest = Object.entries(seconds).sort((a, b) => b[1] - a[1]).slice(0, 10);
const found = {...count, seconds: of_steps, slowest: Object.fromEntries(slowest), faults: faults.sort()};
fs.writeFileSync(report, JSON.stringify(found, null, 1) + "\n");
console.log(count.pages + " pages, " + headings.size + " of equations, at " + widths.join(" and ") + " pixels, " +
            count.looked_at_by_axe + " of them by axe; " + count.formulas + " formulas, " + count.links + " links, " +
            faults.length + " faults");
process.exit(faults.length ? 1 : 0);
