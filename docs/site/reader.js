// Actions of the pages besides being read: symbols and equations explained where they stand, code to copy, a reader's number
// checked, and a box that goes to an equation, a figure or a section. Without this script every page is complete and its links
// work.
(function () {
  "use strict";
  const base = new URL(".", document.currentScript.src).href;

  // A box beside what it explains; closed by Escape, by a click elsewhere, or when the pointer leaves.
  const tip = document.createElement("div");
  tip.id = "tip";
  tip.setAttribute("role", "tooltip");
  tip.hidden = true;
  let of = null;
  function show(element, content) {
    hide();
    tip.innerHTML = content;
    tip.hidden = false;
    if (!tip.isConnected) document.body.appendChild(tip);
    const place = element.getBoundingClientRect(), width = Math.min(tip.offsetWidth, innerWidth - 16);
    tip.style.left = Math.max(8, Math.min(place.left, innerWidth - width - 8)) + scrollX + "px";
    const below = place.bottom + tip.offsetHeight + 12 < innerHeight || place.top < tip.offsetHeight + 12;
    tip.style.top = (below ? place.bottom + 6 : place.top - tip.offsetHeight - 6) + scrollY + "px";
    of = element;
    if (element.matches("a")) element.setAttribute("aria-describedby", "tip");
  }
  function hide() {
    if (of && of.matches("a")) of.removeAttribute("aria-describedby");
    of = null;
    tip.hidden = true;
  }

  const loading = {};
  function load(name) {
    loading[name] = loading[name] || new Promise((done, fail) => {
      const script = document.createElement("script");
      script.src = base + name;
      script.onload = done;
      script.onerror = fail;
      document.head.appendChild(script);
    });
    return loading[name];
  }

  const target = (event) => event.target instanceof Element && event.target.closest("[data-symbol], a[href]");
  const equation_of = (link) => {
    const found = /(?:^|\/)eq_((?:A_)?\d+)\.html$/.exec(link.getAttribute("href") || "");
    return found && !link.closest(".eq-nav, header, svg") ? found[1].replace("_", ".") : "";
  };
  let wanted = null;
  async function explain(element) {
    wanted = element;
    if (element.dataset.symbol !== undefined) {
      await load("symbols.js");
      const symbol = window.siteSymbols[+element.dataset.symbol];
      if (wanted !== element || !symbol) return;
      const links = symbol.equations.map((n) => "<a href=\"" + base + "eq_" + n.replace(".", "_") + ".html\">(" + n + ")</a>");
      show(element, symbol.symbol + ": " + symbol.meaning + (symbol.units ? "; " + symbol.units : "") +
                    (links.length ? "; " + links.join(", ") : ""));
    } else if (equation_of(element)) {
      await load("statements.js");
      const number = equation_of(element), statement = window.siteStatements[number];
      if (wanted === element && statement) show(element, "<p>(" + number + ") " + statement.said + "</p>" + statement.drawn);
    }
  }
  for (const kind of ["mouseover", "focusin"])
    document.addEventListener(kind, (event) => {
      const element = target(event);
      if (element && element !== of && !tip.contains(element)) explain(element);
      else if (!element && !tip.contains(event.target)) { wanted = null; if (kind === "mouseover") hide(); }
    });
  document.addEventListener("click", (event) => {
    const element = target(event);
    if (element && element.dataset.symbol !== undefined) explain(element);
    else if (!tip.contains(event.target)) hide();
  });
  document.addEventListener("keydown", (event) => { if (event.key === "Escape") hide(); });

  // Code to copy.
  document.addEventListener("click", async (event) => {
    const button = event.target instanceof Element && event.target.closest("button.copy-code");
    if (!button) return;
    const code = button.parentElement.querySelector("code");
    try {
      await navigator.clipboard.writeText(code.textContent);
    } catch {
      getSelection().selectAllChildren(code);
      document.execCommand("copy");
    }
    button.textContent = "Copied";
    setTimeout(() => { button.textContent = "Copy"; }, 1500);
  });

  // A reader's number: right where six digits agree, else the mistake with which six digits agree and that is not right, else
  // neither.
  const numbers = (text) => text.trim().split(/[\s,;]+/).filter(Boolean).map((each) => Number(each.replace("−", "-")));
  const shown = (values) => values.map((value) => Number(value.toPrecision(12))).join(", ");
  const agree = (a, b) => {
    const size = Math.max(...b.map(Math.abs));
    return a.length === b.length && a.every((value, i) => Math.abs(value - b[i]) <= 1e-6 * (size || 1));
  };
  for (const form of document.querySelectorAll("form.check")) {
    const check = window.checks[form.id], select = form.elements.scene, inputs = form.querySelector("fieldset.inputs");
    const chosen = () => select && select.value !== "" ? check.scenes[+select.value] : null;
    const fit = () => { if (inputs) inputs.hidden = chosen() !== null; form.querySelector(".verdict-of-number").textContent = ""; };
    if (select) select.addEventListener("change", fit);
    fit();
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      const place = form.querySelector(".verdict-of-number"), given = numbers(form.elements.number.value), scene = chosen();
      place.className = "verdict-of-number";
      if (!given.length || given.some((value) => !Number.isFinite(value))) {
        place.textContent = "Enter a number, such as 0.123, or two numbers for a complex value.";
        return;
      }
      let right, mistakes = [];
      if (scene) {
        right = scene.right;
        mistakes = scene.mistakes;
      } else {
        const values = [];
        for (const name of check.arguments) {
          const read = numbers(form.elements[name].value);
          if (!read.length || read.some((value) => !Number.isFinite(value))) {
            place.textContent = name + " must be a number.";
            return;
          }
          values.push(check.ofModes.includes(name) ? read : read[0]);
        }
        const counts = new Set(check.arguments.map((name, i) => check.ofModes.includes(name) ? values[i].length : 0).filter(Boolean));
        if (counts.size > 1) {
          place.textContent = "All lists over the modes must have the same number of values.";
          return;
        }
        right = check.holds(...values);
        if (right.some((value) => !Number.isFinite(value))) {
          place.textContent = "The formula has no finite value there: these inputs are outside its domain.";
          return;
        }
        if (check.printed) mistakes = [{what: "The equation as printed.", value: check.printed(...values)}];
      }
      const explains = (mistake) => agree(given, mistake.value) && !agree(mistake.value, right);
      if (agree(given, right)) {
        place.classList.add("proved");
        place.textContent = "Right: it agrees with " + shown(right) + " to six digits or more.";
      } else {
        const found = mistakes.filter(explains);
        place.classList.add("refuted");
        place.textContent = found.length
          ? "Not right. " + found.map((each) => "This mistake gives your number: " + each.what).join(" ") + " The right value is " + shown(right) + "."
          : "This is neither the right value nor that of a known mistake. The right value is " + shown(right) + ".";
      }
    });
  }

  // The boxes to go somewhere: an exact number leads to its page, anything else to the search.
  const sections = window.siteSections || {};
  function place_of(text) {
    const words = text.trim().toLowerCase();
    let found = /^(?:eq(?:uation|n)?s?\.?\s*)?\(?(a\.?)?\s*(\d{1,2})\)?[ab]?$/.exec(words);
    if (found && (found[1] ? +found[2] >= 1 && +found[2] <= 15 : +found[2] >= 1 && +found[2] <= 88))
      return "eq_" + (found[1] ? "A_" : "") + +found[2] + ".html";
    found = /^fig(?:ure)?s?\.?\s*(\d{1,2})[a-d]?$/.exec(words);
    if (found && sections["figure " + +found[1]]) return sections["figure " + +found[1]];
    found = /^(?:sec(?:tion)?\.?|§)\s*([2-4](?:\.\d){1,2})$/.exec(words) || /^([2-4]\.\d)(?:\.\d)?$/.exec(words);
    if (found && sections["section " + found[1].slice(0, 3)]) return sections["section " + found[1].slice(0, 3)];
    return /^app(?:endix|\.)?$/.test(words) ? sections["section Appendix"] : "";
  }
  for (const form of document.querySelectorAll("form.search, form.go"))
    form.addEventListener("submit", (event) => {
      const place = place_of(form.querySelector("input").value);
      if (!place) return;
      event.preventDefault();
      location.href = base + place;
    });

  // An exact number that came to the search page leads on.
  if (document.getElementById("search-results")) {
    const place = place_of(new URLSearchParams(location.search).get("q") || "");
    if (place) location.replace(base + place);
  }

  // A formula of a long page is drawn when it comes near the window; one wider than its place is set in lines. What is still too
  // wide scrolls, and can then be scrolled by the keyboard; no other formula is a stop.
  const places = document.querySelectorAll(".formulaDsp, .katex-wide, table.equations td:nth-child(2)");
  const later = document.querySelectorAll("math.later");
  const is_wide = (place) => place.scrollWidth > place.clientWidth + 1;
  const with_formulas = (done) => load("katex.min.js").then(() => load("formulas.js")).then(() => done(window.siteFormulas));
  function stops() {
    for (const each of places) {
      if (is_wide(each)) each.tabIndex = 0;
      else each.removeAttribute("tabindex");
    }
  }
  function fit(within) {
    const asked = [...places].filter((each) => within.contains(each));
    if (window.siteFormulas || asked.some(is_wide)) with_formulas((formulas) => { asked.forEach(formulas.fit); stops(); });
    else stops();
  }
  const near = new IntersectionObserver((entries) => {
    const seen = entries.filter((entry) => entry.isIntersecting).map((entry) => entry.target);
    for (const each of seen) near.unobserve(each);
    if (seen.length) with_formulas((formulas) => {
      for (const each of seen) {
        const place = each.closest(".formulaDsp, table.equations td");
        formulas.draw(each);
        if (place) formulas.fit(place);
      }
      stops();
    });
  }, {rootMargin: "100% 0px"});
  for (const each of later) near.observe(each);
  if ([...places].some(is_wide)) with_formulas(() => {}); // on their way while the page loads
  let width = innerWidth;
  addEventListener("resize", () => { if (innerWidth !== width) { width = innerWidth; fit(document); } else stops(); });
  addEventListener("load", () => fit(document));
  document.addEventListener("toggle", (event) => fit(event.target), true);

  // The graph: an equation shows what it rests on and what uses it, all the way; the chosen one can be read below. Graphviz has
  // the equation as the title of a node, and those of a line, 1->7.
  const graph = document.querySelector(".equation-graph");
  if (graph) {
    const panel = document.getElementById("graph-statement"), find = document.querySelector("form.find");
    const titled = (kind) => Array.from(graph.querySelectorAll("g." + kind),
                                        (each) => [each.querySelector("title").textContent, each]);
    const nodes = new Map(titled("node")), edges = titled("edge").map(([title, mark]) => [...title.split("->"), mark]);
    let chosen = null;
    const light = (number) => {
      graph.classList.toggle("lit", number !== null);
      for (const each of graph.querySelectorAll(".below, .above, .at")) each.classList.remove("below", "above", "at");
      if (number === null) return;
      nodes.get(number).classList.add("at");
      for (const [near, far, mark] of [[1, 0, "below"], [0, 1, "above"]]) {
        const seen = new Set([number]);
        for (const at of seen) // grows on the way
          for (const edge of edges.filter((each) => each[near] === at)) {
            seen.add(edge[far]);
            for (const each of [edge[2], nodes.get(edge[far])]) each.classList.add(mark);
          }
      }
    };
    const choose = async (number) => {
      await load("statements.js");
      chosen = number;
      light(chosen);
      const statement = window.siteStatements[number], [, , rests_on, used_by] = document.getElementById("at-" + number).cells;
      const page = nodes.get(number).querySelector("a").getAttribute("href");
      panel.innerHTML = "<p>(" + number + ") " + statement.said + " <a href=\"" + page + "\">The page of (" + number +
                        ")</a></p><p class=\"near\">It rests on " + rests_on.innerHTML.trim() + "; used by " + used_by.innerHTML.trim() + ".</p>" +
                        "<div class=\"formulaDsp\">" + statement.drawn + "</div>";
      const place = panel.querySelector(".formulaDsp"), math = place.querySelector("math");
      with_formulas((formulas) => { if (math) formulas.draw(math); formulas.fit(place); });
    };
    for (const [number, node] of nodes) {
      for (const kind of ["mouseover", "focusin"]) node.addEventListener(kind, () => light(number));
      for (const kind of ["mouseout", "focusout"]) node.addEventListener(kind, () => light(chosen));
    }
    document.addEventListener("click", (event) => {
      const link = event.target.closest("g.node a, #graph-statement .near a");
      if (!link) return;
      event.preventDefault();
      const [number] = [...nodes].find(([, node]) => node.contains(link)) || [equation_of(link)];
      choose(number).then(() => panel.scrollIntoView({block: "nearest"}));
    });
    find.hidden = false;
    const find_it = async (text) => {
      const number = (/^eq_(.+)\.html$/.exec(place_of(text)) || ["", ""])[1].replace("_", ".");
      if (!document.getElementById("at-" + number)) { panel.textContent = "The equations are (1) to (88) and (A.1) to (A.15)."; return; }
      await choose(number);
      nodes.get(number).scrollIntoView({block: "center", inline: "center"});
    };
    find.addEventListener("submit", (event) => { event.preventDefault(); find_it(find.elements.number.value); });
    if (location.hash.startsWith("#at-")) find_it(location.hash.slice(4));
  }

  // All folded parts are printed.
  addEventListener("beforeprint", () => { for (const each of document.querySelectorAll("details")) each.open = true; });
})();
