// Drives the explorable pages in headless Chromium, from the file system, as a reader would:
//
//   node drive_pages.mjs SITE/explore DENHARTOG REPORT.json [--states N]
//
// Sets sliders to N seeded states (200) and compares the numbers of the machine with those of `denhartog solve` to 9 digits;
// presses keys; types what breaks a rule; opens every table; reloads addresses; runs what "copy as command" shows; looks for
// console messages, requests, pages too wide, and whatever axe-core finds, in light and dark. Last a copy of the pages, in which
// friction is too small by a thousandth, has to be found out. Times are reported; what is gated on are counters. One line a fault
// on standard error; exit status 1 where there is any, 2 for usage. Run from the folder where axe-core and puppeteer-core are.
import { spawnSync } from "node:child_process";
import { createRequire } from "node:module";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { pathToFileURL } from "node:url";

const from_here = createRequire(path.join(process.cwd(), "package.json"));
const puppeteer = (await import(pathToFileURL(from_here.resolve("puppeteer-core")))).default;
const axe = fs.readFileSync(from_here.resolve("axe-core/axe.min.js"), "utf8");

const [site, denhartog, report, ...options] = process.argv.slice(2);
if (!site || !denhartog || !report) {
  console.error("usage: node drive_pages.mjs SITE/explore DENHARTOG REPORT.json [--states N]");
  process.exit(2);
}
const states = options[0] === "--states" ? Number(options[1]) : 200;
const names = ["index", "machine", "plane", "printed", "integrators", "digits"];
const faults = [];
const measured = { states: 0, compared: 0, largest_relative_difference: 0, without_answer: 0 };

const browser = await puppeteer.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--disable-dev-shm-usage", ...(process.getuid() === 0 ? ["--no-sandbox"] : [])],
  timeout: 300000,
  protocolTimeout: 300000,
});
browser.process().stderr.resume();
const [page] = await browser.pages();
let at = "";
const say = (text) => faults.push(at + ": " + text);
page.on("console", (message) => say("console: " + message.text()));
page.on("pageerror", (error) => say("script: " + error.message));
page.on("requestfailed", (request) => say("not loaded: " + request.url()));
page.on("request", (request) => {
  if (!/^(file|data|blob):/.test(request.url())) say("calls another host: " + request.url());
});

const wait = () => page.waitForFunction(() => !explore.page?.busy(), { timeout: 240000, polling: 20 });
async function open(name, hash = "", folder = site) {
  at = name + ".html" + hash;
  await page.goto("about:blank"); // so that another hash is another visit
  await page.goto(pathToFileURL(path.resolve(folder, name + ".html")).href + hash, { waitUntil: "load" });
  if (name !== "index") await wait();
}
// Moves a range as a pointer or a key does: its value, then its event.
const slide = (values) =>
  page.evaluate((all) => {
    for (const [key, value] of all) {
      const range = document.getElementById("range-" + key);
      range.value = value;
      range.dispatchEvent(new Event("input", { bubbles: true }));
    }
  }, values);
const numbers = () =>
  page.evaluate(() => ({
    regime: document.getElementById("regime").dataset.regime ?? "",
    scene: /'(.*)'/.exec(document.getElementById("command").textContent)[1],
    ...Object.fromEntries([...document.querySelectorAll("[data-number]")].map((e) => [e.dataset.number, e.textContent])),
  }));

let seed = 7;
const random = () => {
  seed = (seed * 48271) % 2147483647;
  return seed / 2147483647;
};
const stepped = (from, to, step) => Number((from + Math.floor((random() * (to - from)) / step) * step).toPrecision(6));
function state() {
  const N = 1 + Math.floor(5 * random()),
    choose = () => 1 + Math.floor(N * random());
  return [
    ["N", N],
    ["j", choose()],
    ["l", choose()],
    ["mu", random() < 0.7 ? 1 : stepped(1, 2, 0.01)],
    ["z", stepped(0.005, 0.3, 0.001)],
    ["r", stepped(0.1, 2.5, 0.005)],
    ["b", stepped(0.005, 1.2, 0.005)],
  ];
}
const one_turn = (x) => Math.abs(x - 2 * Math.PI * Math.round(x / (2 * Math.PI)));

// The numbers of the machine at seeded states against those of the program; returns how many differ.
async function compare(count, folder) {
  await open("machine", "", folder);
  await page.evaluate(() => explore.page.pause());
  const seen = [];
  for (let n = 0; n < count; ++n) {
    await slide(state());
    await wait();
    seen.push(await numbers());
  }
  const run = spawnSync(denhartog, ["solve", "-", "--json", "--digits", "10"], {
    input: seen.map((s) => s.scene).join("\n") + "\n",
    encoding: "utf8",
    maxBuffer: 1 << 28,
  });
  const answers = run.stdout
    .trim()
    .split("\n")
    .map((line) => JSON.parse(line));
  if (answers.length !== count)
    throw new Error("denhartog solve gave " + answers.length + " answers to " + count + " scenes: " + run.stderr.slice(0, 300));
  let different = 0;
  for (const [n, s] of seen.entries()) {
    const a = answers[n],
      wrong = [];
    const same = (name, x, y, size = Math.abs(y)) => {
      const difference = Math.abs(Number(x) - y) / Math.max(size, 1e-300);
      ++measured.compared;
      if (!(difference <= 1e-9)) wrong.push(name + " is " + x + ", by denhartog solve " + y);
      else measured.largest_relative_difference = Math.max(measured.largest_relative_difference, difference);
    };
    ++measured.states;
    const none = s.regime === "searching" || a.error || !a.masses;
    if (none) ++measured.without_answer;
    if (a.beta_lim)
      for (const [key, name] of [
        ["exact", "beta_lim_exact"],
        ["paper", "beta_lim_paper"],
        ["approximate", "beta_lim_approximate"],
        ["sticking", "beta_sticking"],
      ])
        if (a.beta_lim[key] !== undefined) same(name, s[name], Number(a.beta_lim[key]));
    if (none) {
      // several motions, or none: both must say so, but for a search that one of them gives more time
      if (Number(JSON.parse(s.scene).mu) === 1) wrong.push("there is no answer with mu = 1");
    } else {
      if (s.regime !== a.regime) wrong.push("the regime is " + s.regime + ", by denhartog solve " + a.regime);
      for (const m of a.masses) {
        const amplitude = Number(m.amplitude);
        if (amplitude === 0) continue;
        same("amplitude " + m.mass, s["amplitude-" + m.mass], amplitude);
        if (
          m.phase !== undefined &&
          m.phase !== null &&
          one_turn(Number(s["phase-" + m.mass]) - Number(m.phase)) > 1e-9 &&
          one_turn(Number(s["phase-" + m.mass]) - Number(m.phase) - Math.PI) > 1e-9
        )
          // of an extremum and its mirror image
          wrong.push("phase " + m.mass + " is " + s["phase-" + m.mass] + ", by denhartog solve " + m.phase);
      }
      if (a.regime === "stick_slip") {
        const stops = a.stops.length / a.periods; // of a period of the force
        if (Math.abs(Number(s.stops) - stops) > 1e-5)
          wrong.push("stops per period are " + s.stops + ", by denhartog solve " + stops);
        // A motion of several periods begins at any of its maxima of the force, and its list at any of its stops.
        const list = (a.stops ?? []).map((stop) => Number(stop.x)),
          shown = list.map((_, i) => Number(s["stop-at-" + (i + 1)]));
        const apart = (first) => Math.max(...shown.map((x, i) => Math.abs(x - list[(i + first) % list.length])));
        const firsts = a.periods > 1 ? [...list.keys()] : [0];
        const first = firsts.reduce((best, each) => (apart(each) < apart(best) ? each : best), 0);
        for (const i of list.keys())
          same("stop " + (i + 1), s["stop-at-" + (i + 1)], list[(i + first) % list.length]);
      }
    }
    if (wrong.length) {
      ++different;
      say(s.scene + ": " + wrong.join("; "));
    }
  }
  return different;
}

// Links that lead nowhere; those to the rest of the site only where the pages stand in one.
const whole = fs.existsSync(path.join(site, "../equations.html"));
async function follow() {
  const links = await page.evaluate(() => [...document.querySelectorAll("a[href]")].map((e) => e.getAttribute("href")));
  for (const link of new Set(links)) {
    const file = link.replace(/[#?].*/, "");
    if (file && (whole || !file.startsWith("../")) && !fs.existsSync(path.join(site, file)))
      say("leads to " + link + ", which is not there");
  }
}

async function look_everywhere() {
  for (const name of names) {
    await open(name);
    await follow();
    for (const details of await page.$$("main details"))
      await details.evaluate((e) => {
        e.open = true;
      });
    await new Promise((done) => setTimeout(done, 100));
    if (name !== "index") {
      const empty = await page.evaluate(() =>
        [...document.querySelectorAll("details.table-view")]
          .filter((e) => e.querySelectorAll("tbody tr").length < 2)
          .map((e) => e.id),
      );
      for (const id of empty) say("the table " + id + " is empty");
      const pictures = await page.evaluate(
        () =>
          [...document.querySelectorAll("figure")].filter(
            (f) => f.querySelector("svg[role=img]") && f.querySelector("details") && !f.querySelector("details table"),
          ).length,
      );
      if (pictures) say(pictures + " pictures have no table");
      if (
        !(await page.evaluate(
          () =>
            document.getElementById("status").textContent !== "" ||
            new Promise((done) => setTimeout(() => done(document.getElementById("status").textContent !== ""), 900)),
        ))
      )
        say("nothing is announced");
    }
    for (const scheme of ["light", "dark"]) {
      await page.emulateMediaFeatures([{ name: "prefers-color-scheme", value: scheme }]);
      for (const width of [1280, 375]) {
        await page.setViewport({ width, height: 900 });
        await new Promise((done) => setTimeout(done, 60));
        if (name !== "index") await wait();
        const wide = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
        if (wide > 0) say("is " + wide + " pixels too wide at " + width);
        await page.evaluate(axe);
        const result = await page.evaluate(() => axe.run(document, { preload: false, resultTypes: ["violations"] }));
        for (const each of result.violations)
          say(
            "axe, " +
              scheme +
              ", " +
              width +
              ": " +
              each.id +
              ", " +
              each.nodes.length +
              " times, first " +
              each.nodes[0].html.slice(0, 160),
          );
      }
    }
    await page.emulateMediaFeatures([]);
    await page.setViewport({ width: 1280, height: 900 });
  }
}

// With the keyboard alone: every control is reached by Tab and moved by arrows; the plane's point and the motion too.
async function press_keys() {
  await open("machine", "#N=3&j=2&r=0.9&b=0.2");
  const reached = new Set();
  for (let n = 0; n < 80; ++n) {
    await page.keyboard.press("Tab");
    reached.add(await page.evaluate(() => document.activeElement.id));
  }
  const wanted = await page.evaluate(() =>
    [...document.querySelectorAll("main input, main select, main button")]
      .filter((e) => e.offsetParent && !e.closest("details:not([open])"))
      .map((e) => e.id),
  );
  for (const id of wanted) if (!reached.has(id)) say("Tab does not reach " + id);
  await page.focus("#range-r");
  await page.keyboard.press("ArrowRight");
  await wait();
  if (!/r=0\.905/.test(await page.evaluate(() => location.hash)))
    say("an arrow key on r leads to " + (await page.evaluate(() => location.hash)));
  if (JSON.parse((await numbers()).scene).r !== 0.905) say("an arrow key on r does not change the scene");
  await page.focus("#play");
  const frames = () => page.evaluate(() => explore.page.counters.frames);
  await page.keyboard.press("Space");
  const paused = await frames();
  await new Promise((done) => setTimeout(done, 300));
  if ((await frames()) !== paused) say("Space on Pause does not stop the motion");
  await page.focus("#number-mu");
  await page.keyboard.down("Control");
  await page.keyboard.press("a");
  await page.keyboard.up("Control");
  await page.keyboard.type("0.5");
  const fault = await page.evaluate(() => document.getElementById("fault").textContent);
  if (!/mu must be at least 1, but is 0.5/.test(fault)) say("mu = 0.5 is answered by: " + fault);
  if (JSON.parse((await numbers()).scene).mu < 1) say("a scene that breaks a rule is offered as a command");

  const before = await (await open("machine", "#N=2&j=2&z=0.1&r=0.7&b=0.3&g=1,2&k=1,0.5"), numbers());
  await page.reload({ waitUntil: "load" });
  await wait();
  if (JSON.stringify(before) !== JSON.stringify(await numbers())) say("the address does not bring the state back");

  await open("plane", "#r=0.7&b=0.4");
  await page.focus("#plane");
  for (const key of ["ArrowRight", "ArrowUp", "ArrowUp"]) await page.keyboard.press(key);
  await wait();
  const scene = JSON.parse((await numbers()).scene);
  if (scene.r !== 0.71 || scene.beta !== 0.42) say("the arrow keys lead to r = " + scene.r + ", beta = " + scene.beta);
  const link = await page.evaluate(() => document.getElementById("to-machine").getAttribute("href"));
  if (!/^machine.html#.*r=0.71&b=0.42/.test(link)) say("the point leads to " + link);
  const box = await (await page.$("#plane")).boundingBox();
  await page.mouse.click(box.x + box.width / 2, box.y + 100);
  await wait();
  if (JSON.parse((await numbers()).scene).r === 0.71) say("a click does not move the point");
  const shown = await numbers(),
    [answer] = ask([shown.scene]);
  if (Math.abs(Number(shown.beta_lim_exact) - answer.beta_lim.exact) > 1e-9)
    say("the plane ends sliding at " + shown.beta_lim_exact + ", denhartog solve at " + answer.beta_lim.exact);
}
function ask(scenes) {
  const run = spawnSync(denhartog, ["solve", "-", "--json"], { input: scenes.join("\n") + "\n", encoding: "utf8" });
  return run.stdout
    .trim()
    .split("\n")
    .map((line) => JSON.parse(line));
}

// Scenes at the ends of what is allowed, undamped resonances among them: no page may stumble.
async function go_to_the_ends() {
  const ends = [
    "#z=0&r=1&b=0.2",
    "#z=0&r=0.5&b=0",
    "#r=40",
    "#b=0",
    "#r=0.03&b=0.9",
    "#z=3&r=0.5",
    "#N=5&z=0&j=3&r=0.9&b=0.2",
    "#mu=3&r=0.5&b=0.4",
  ];
  for (const name of ["machine", "plane", "integrators", "printed"])
    for (const hash of name === "plane" ? ends.slice(0, 3) : ends) {
      await open(name, hash);
      if (!(await page.evaluate(() => document.getElementById("regime").textContent))) say("says nothing");
    }
}

async function read_the_others() {
  await open("printed");
  const equations = await page.evaluate(() => [...document.getElementById("choice-eq").options].map((o) => o.value));
  for (const eq of equations) {
    await page.select("#choice-eq", eq);
    await wait();
    at = "printed.html, (" + eq + ")";
    if (await page.evaluate(() => document.getElementById("fault").textContent)) say("opens with a fault");
    await follow();
    if ((await page.evaluate(() => document.querySelectorAll("#curve .line").length)) < 2) say("does not draw both curves");
    if ((await page.evaluate(() => document.querySelector("#curve .right").getAttribute("d").length)) < 20)
      say("draws no corrected curve");
  }
  measured.equations_as_printed = equations.length;
  await open("digits", "#n=1&d=0.000001&z=0.0000001");
  const d = await numbers();
  if (Number(d["u-shipped-units"]) > 64 || Number(d["u-printed-units"]) < 1e6) say("units off: " + JSON.stringify(d));
  const [functions] = ask_functions(d.scene);
  for (const key of ["u", "g"])
    if (Math.abs(functions.modes[0][key] / Number(d[key + "-shipped"]) - 1) > 1e-13)
      say(key + " as shipped is " + d[key + "-shipped"] + ", by denhartog functions " + functions.modes[0][key]);
  await open("integrators", "#r=0.5&b=0.4");
  const i = await numbers(),
    [answer] = ask([i.scene]);
  if (Math.abs(Number(i.amplitude) / answer.contact.amplitude - 1) > 1e-9) say("the exact amplitude is " + i.amplitude);
  for (const key of ["rk", "tanh", "hb"])
    if (!(Number(i["error-" + key]) > 0 && Number(i["cost-" + key]) > 0)) say("no error or cost of " + key);
  await slide([["tol", -8]]);
  await wait();
  const finer = await numbers();
  if (!(Number(finer["error-rk"]) < Number(i["error-rk"]) && Number(finer["cost-rk"]) > Number(i["cost-rk"])))
    say("a finer tolerance does not cost more and err less");
}
function ask_functions(scene) {
  const run = spawnSync(denhartog, ["functions", "-", "--json"], { input: scene + "\n", encoding: "utf8" });
  return [JSON.parse(run.stdout)];
}

// Pastes the text of "copy as command" into a shell.
async function paste() {
  for (const hash of ["", "#N=3&j=2&l=3&r=0.6&b=0.5&mu=1.2&g=1,2.5,0.75", "#N=5&j=3&z=0.01&r=0.9&b=0.2"]) {
    await open("machine", hash);
    const command = await page.evaluate(() => document.getElementById("command").textContent),
      shown = await numbers();
    const run = spawnSync("bash", ["-c", command + " --json"], {
      encoding: "utf8",
      env: { ...process.env, PATH: path.dirname(path.resolve(denhartog)) + ":" + process.env.PATH },
    });
    if (run.status !== 0) say("the command ends with status " + run.status + ": " + run.stderr.slice(0, 200));
    else if (
      Math.abs(JSON.parse(run.stdout).contact.amplitude / Number(shown["amplitude-" + JSON.parse(run.stdout).contact.mass]) - 1) >
      1e-9
    )
      say("the command answers otherwise than the page");
    await page.click("#copy-command");
    await page
      .waitForFunction(() => document.getElementById("copy-command").textContent === "Copied", { timeout: 10000 })
      .catch(() => say("nothing tells that the command was copied"));
  }
}

// Frames and answers at N = 5. Times are reported; gated on: a change is drawn within its event, by few evaluations.
async function hurry() {
  const session = await browser.target().createCDPSession();
  const cpu = async () => {
    const { processInfo } = await session.send("SystemInfo.getProcessInfo"); // seconds, of the page's process
    return processInfo.filter((each) => each.type === "renderer").reduce((sum, each) => sum + each.cpuTime, 0);
  };
  await open("machine", "#N=5&j=3&z=0.05&r=0.9&b=0.7");
  const before = await cpu();
  const found = await page.evaluate(async () => {
    const range = document.getElementById("range-b"),
      times = [],
      frame = () => new Promise(requestAnimationFrame),
      evaluations = [];
    let late = 0;
    explore.page.pause();
    for (let n = 0; n < 60; ++n) {
      await frame();
      const renders = explore.page.counters.renders,
        start = performance.now();
      range.value = 0.6 + 0.005 * (n % 40);
      range.dispatchEvent(new Event("input", { bubbles: true }));
      if (explore.page.counters.renders === renders) ++late;
      times.push(performance.now() - start);
      evaluations.push(explore.page.counters.evaluations);
      while (explore.page.busy()) await frame();
    }
    times.sort((a, b) => a - b);
    return { late, most_evaluations: Math.max(...evaluations), median_ms: times[30], p95_ms: times[57] };
  });
  found.cpu_ms_a_change = (((await cpu()) - before) * 1000) / 60;
  await open("machine", "#N=5&j=3&z=0.05&r=0.9&b=0.7");
  const resting = await cpu();
  const moved = await page.evaluate(async () => {
    const frames = explore.page.counters.frames,
      start = performance.now();
    await new Promise((done) => setTimeout(done, 3000));
    return { frames: explore.page.counters.frames - frames, seconds: (performance.now() - start) / 1000 };
  });
  found.frames_a_second = moved.frames / moved.seconds;
  found.cpu_ms_a_frame = (((await cpu()) - resting) * 1000) / moved.frames;
  Object.assign(measured, found);
  if (found.late) say(found.late + " of 60 changes are not drawn within their event");
  if (found.most_evaluations > 20000) say("a step of a slider takes " + found.most_evaluations + " evaluations");
  await page.emulateMediaFeatures([{ name: "prefers-reduced-motion", value: "reduce" }]);
  await open("machine", "#N=5&j=3&r=0.9&b=0.2");
  await new Promise((done) => setTimeout(done, 300));
  if ((await page.evaluate(() => explore.page.counters.frames)) !== 0) say("moves although less motion is asked for");
  await page.emulateMediaFeatures([]);
}

// Tells how far the drive has come.
async function stage(part) {
  const start = Date.now();
  await part();
  console.log(part.name.replaceAll("_", " ") + ": " + Math.round((Date.now() - start) / 1000) + " s");
}

await stage(press_keys);
await stage(read_the_others);
await stage(go_to_the_ends);
await stage(paste);
await stage(hurry);
await stage(look_everywhere);
await compare(states, site);

// The comparison has to fail if friction is a thousandth too small.
const copy = fs.mkdtempSync(path.join(os.tmpdir(), "explore-"));
fs.cpSync(site, copy, { recursive: true });
const script = fs.readFileSync(path.join(copy, "explore.js"), "utf8"),
  mutated = script.replace("this.beta * direction", "0.999 * this.beta * direction");
fs.writeFileSync(path.join(copy, "explore.js"), mutated);
const true_faults = faults.length,
  true_measured = { ...measured };
const different = mutated === script ? 0 : await compare(20, copy);
faults.length = true_faults;
Object.assign(measured, true_measured, { mutated_found: different });
at = "mutated copy";
if (different === 0) say("friction a thousandth too small is not found out");
fs.rmSync(copy, { recursive: true });

await browser.close();
fs.writeFileSync(report, JSON.stringify({ ...measured, faults }, null, 1) + "\n");
for (const fault of faults) console.error(fault);
console.log(JSON.stringify(measured));
console.log(
  "explorable pages: " + measured.states + " states, " + measured.compared + " numbers compared, " + faults.length + " faults",
);
process.exit(faults.length ? 1 : 0);
