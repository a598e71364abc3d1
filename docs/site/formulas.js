// Formulas that the browser sets: those of a long page, which comes with MathML alone, when they come near the window; and a
// displayed formula wider than its place, anew in lines. reader.js loads this file and KaTeX for a page that has such a formula.
// Without them the first stay MathML, and the second scroll.
(function () {
  "use strict";

  // The end of what opens at a place in TeX: a group, an environment, or brackets with \left and \right.
  function end_of(tex, at, opens, closes) {
    for (let depth = 0; at < tex.length;) {
      opens.lastIndex = closes.lastIndex = at;
      const opening = opens.exec(tex), closing = closes.exec(tex);
      depth += opening ? 1 : closing ? -1 : 0;
      at += (opening || closing || [tex[at] === "\\" ? "\\." : "."])[0].length;
      if (closing && depth === 0) break;
    }
    return at;
  }

  // TeX in parts: a command with its groups, an index, an exponent, \left( ... \right), an environment, a character. A
  // part keeps the blanks that follow it.
  function parts_of(tex) {
    const found = [], blanks = /\s*/y;
    const next = (at) => {
      if (/^\\left(?![A-Za-z])/.test(tex.slice(at, at + 6)))
        return end_of(tex, at, /\\left(?![A-Za-z])/y, /\\right\s*(?:\\[A-Za-z]+|\\?.)/y);
      if (tex.startsWith("\\begin{", at)) return end_of(tex, at, /\\begin\{/y, /\\end\{[a-z]*\}/y);
      if (tex[at] === "{") return end_of(tex, at, /\{/y, /\}/y);
      if (/[_^]/.test(tex[at])) return next(at + 1);
      if (tex[at] !== "\\") return at + 1;
      const command = /^\\(?:[A-Za-z]+|[^])/.exec(tex.slice(at))[0];
      at += command.length;
      for (let groups = /frac$|^\\html/.test(command) ? 2 : 1; groups > 0 && tex[at] === "{"; --groups)
        at = end_of(tex, at, /\{/y, /\}/y);
      return at;
    };
    for (let at = 0; at < tex.length;) {
      blanks.lastIndex = next(at);
      blanks.test(tex);
      found.push(tex.slice(at, blanks.lastIndex));
      at = blanks.lastIndex;
    }
    return found;
  }

  const relation = /^(=|<|>|\\(le|ge|leq|geq|ne|cong|approx|equiv)(?![A-Za-z]))/;
  const is_sum = (parts) => parts.some((each, at) => at > 0 && /^[+-]/.test(each));
  const is_atom = (parts) => parts.slice(1).every((each) => /^[_^']/.test(each));
  const is_function = /^\\(sin|cos|tan|sinh|cosh|tanh|exp|ln|log|arctan|angle|mathrm|operatorname)(?![A-Za-z])/;
  const ends_factor = /^[-+,;.)\]|>=<]|^\\(right|q?quad|[bB]igr|\}|to|text|ne|le|ge|cong|approx)(?![A-Za-z])/; // what follows is no factor
  const long = 44; // characters of TeX

  // TeX with places to break a line: before signs and relations and after commas, also within brackets of \left and \right, which
  // get a fixed size. From level 2 on also between factors, and a long fraction becomes a quotient; at level 3 also within other
  // brackets, and a long root becomes a power. What a function is applied to stays as it is.
  function with_breaks(tex, level) {
    const parts = parts_of(tex);
    let out = "", before = "", depth = 0, applied = false; // whether a function stands before, without brackets
    for (const [at, part] of parts.entries()) {
      const starts = before === "" || /^[([,+-]|^\\(l?brace|\{|[bB]igl|q?quad)/.test(before) || relation.test(before);
      const brackets = /^\\left\s*(\\[A-Za-z]+|\\?.)([^]*)\\right\s*(\\[A-Za-z]+|\\?.)\s*$/.exec(part);
      const fraction = level > 1 && !applied && part.length > long && /^\\t?frac(\{[^]*\})\s*$/.exec(part);
      const root = level > 2 && !applied && part.length > long && /^\\sqrt\{([^]*)\}\s*$/.exec(part);
      const marked = /^\\(?:misprint|mended)(?=\{)/.exec(part);
      if (/^[([]/.test(part)) ++depth;
      if (/^[)\]]/.test(part)) --depth;
      const is_factor = is_function.test(part) || !applied && /^\\(left|frac|sqrt)/.test(part);
      if (level > 1 && !starts && is_factor) out += "\\allowbreak ";
      if ((/^[+-]/.test(part) || relation.test(part)) && !starts) {
        out += (level > 2 || depth === 0 ? "\\allowbreak " : "") + part + "\\nobreak ";
      } else if (brackets && (is_sum(parts_of(brackets[2])) || level > 2 && part.length > long)) {
        const size = /\\(frac|sum)/.test(brackets[2]) ? "\\Big" : /\\(sqrt|tfrac|left)/.test(brackets[2]) ? "\\big" : "";
        const side = (mark, letter) => mark === "." ? "" : (size && size + letter) + mark + " ";
        out += side(brackets[1], "l") + with_breaks(brackets[2], level) + side(brackets[3], "r");
      } else if (fraction) {
        const above_end = end_of(fraction[1], 0, /\{/y, /\}/y);
        const above = fraction[1].slice(1, above_end - 1), below = fraction[1].slice(above_end + 1, -1);
        const over = with_breaks(above, level), follows = parts[at + 1];
        out += (is_sum(parts_of(above)) ? "\\bigl(" + over + "\\bigr)" : over) + "\\allowbreak\\big/\\nobreak " +
               (is_atom(parts_of(below)) ? below + " " : "\\bigl(" + with_breaks(below, level) + "\\bigr)") +
               (follows && !ends_factor.test(follows) ? "\\cdot " : "");
      } else if (root) {
        out += "\\bigl(" + with_breaks(root[1], level) + "\\bigr)^{1/2}";
      } else if (marked) {
        out += with_breaks(part.trim().slice(marked[0].length + 1, -1), level).split("\\allowbreak ")
          .map((each) => each && marked[0] + "{" + each + "}").join("\\allowbreak ");
      } else if (part.startsWith("{") && is_sum(parts_of(part.trim().slice(1, -1)))) {
        out += with_breaks(part.trim().slice(1, -1), level);
      } else {
        out += part + (/^\\q?quad/.test(part) || part[0] === "," && depth === 0 ? "\\allowbreak " : "");
      }
      applied = is_function.test(part) || applied && !/^[-+([,]|^\\left/.test(part) && !relation.test(part);
      before = part;
    }
    return out;
  }

  // The rows of a formula, each with places to break; the number at its end comes last.
  function rows_of(tex, level) {
    const [, body, number] = /^([^]*?)(?:\\tag\{([^}]*)\})?\s*$/.exec(tex);
    const around = /^\s*\\begin\{(aligned|gathered|cases|split)\}([^]*)\\end\{\1\}\s*([.,;]?)$/.exec(body);
    const rows = [""];
    for (const part of parts_of(around ? around[2] + around[3] : body)) {
      if (/^\\\\/.test(part)) rows.push("");
      else if (part[0] === "&") rows[rows.length - 1] += around && around[1] === "cases" ? "\\quad " : "";
      else rows[rows.length - 1] += part;
    }
    const broken = rows.filter((row) => row.trim()).map((row) => with_breaks(row.trim(), level));
    if (number) broken[broken.length - 1] += "\\quad\\allowbreak\\text{(" + number + ")}";
    return broken;
  }

  const tex_of = (math) => math.dataset.tex || math.querySelector("annotation").textContent;
  function drawn(tex, displayed) {
    const macros = {"\\misprint": "\\htmlClass{misprint}{#1}", "\\mended": "\\htmlClass{mended}{#1}"};
    return window.katex.renderToString(tex, {displayMode: displayed, throwOnError: true, trust: true, strict: false, macros});
  }

  // A formula that came as MathML, drawn.
  function draw(math) {
    const place = document.createElement("span");
    place.innerHTML = drawn(tex_of(math), math.getAttribute("display") === "block");
    place.querySelector("math").dataset.tex = tex_of(math);
    math.replaceWith(...place.childNodes);
  }

  // A formula fits its place: as it is stated, a little smaller, or in lines.
  const least_size = 0.84, stated = new WeakMap();
  const too_wide = (place) => place.scrollWidth > place.clientWidth + 1;
  const shrink = (place, least) => {
    const ratio = (place.clientWidth - 4) / place.scrollWidth;
    if (ratio < 1 && ratio > least) place.style.fontSize = Math.floor(100 * ratio) + "%";
  };
  function fit(place) {
    if (stated.has(place)) {
      place.innerHTML = stated.get(place);
      place.classList.remove("in-lines");
      place.style.fontSize = "";
    }
    const math = place.querySelectorAll("math");
    if (math.length !== 1 || !too_wide(place)) return;
    stated.set(place, place.innerHTML);
    shrink(place, least_size);
    if (!too_wide(place)) return;
    const tex = tex_of(math[0]), displayed = math[0].getAttribute("display") === "block";
    place.classList.add("in-lines");
    for (let level = 1; level === 1 || level <= 3 && too_wide(place); ++level)
      place.innerHTML = rows_of(tex, level).map((row) => drawn(row, displayed)).join(displayed ? "" : "<br>");
    shrink(place, least_size * least_size);
  }

  window.siteFormulas = {draw, fit, rows_of};
})();
