// The value of a formula in TeX, with a number of its own for each symbol: draw-formulas.mjs compares a formula with its lines.
//
// A product goes on to the next sign or relation; a function takes one bracket, or the factors up to the next bracket, sign or
// function. A formula with sums over an index, words or environments within it has no value here.

const left_out = new Set(["\\allowbreak", "\\nobreak", "\\left", "\\right", "\\bigl", "\\bigr", "\\Bigl", "\\Bigr", "\\big", "\\Big",
                          "\\quad", "\\qquad", "\\,", "\\;", "\\!", "\\ ", "&"]);
const functions = {"\\sin": Math.sin, "\\cos": Math.cos, "\\sinh": Math.sinh, "\\cosh": Math.cosh, "\\exp": Math.exp};
const with_argument = /^\\(overline|bar|mathrm|mathcal|hat|boldsymbol|mathbf)$/;
const without_value = /^\\(sum|lim|max|sup|int|text|prod|operatorname|angle|begin|end|tag|to|partial|forall|mathbb)$/;
const relation = /^([=<>,]|\\(ne|le|ge|cong|approx))$/;
const ends_product = /^([-+)\]}.;:]|\\\})$/;

// A number between 0.3 and 1.4 that follows from a name.
const number_of = (name) => 0.31 + [...name].reduce((sum, letter) => (31 * sum + letter.charCodeAt(0)) % 9973, 7) / 9973;

/** The values between the relations of a formula; undefined if it has none. */
export function values_of(tex) {
  const rows = tex.replace(/^\s*\\begin\{(aligned|gathered)\}([^]*)\\end\{\1\}\s*$/, "$2").replace(/\\\\|\{\}/g, " ");
  const words = (rows.match(/\\[A-Za-z]+|\\.|\d+(?:\.\d+)?|\S/g) || []).filter((word) => !left_out.has(word));
  let at = 0, open_bars = 0;
  const fail = () => { throw new RangeError("no value at " + words[at]); };
  const take = (wanted) => wanted.test(words[at]) ? words[at++] : fail();

  // An argument as it is written.
  function written() {
    let text = "", depth = 0;
    do {
      depth += words[at] === "{" ? 1 : words[at] === "}" ? -1 : 0;
      text += words[at++];
    } while (depth > 0 && at < words.length);
    return text;
  }
  function group() {
    if (words[at] !== "{") return atom();
    ++at;
    const value = sum();
    take(/^\}$/);
    return value;
  }
  // A number, bracket or symbol with its index, primes and exponent; a starred or numbered symbol is another symbol.
  function with_scripts(value, name) {
    let symbol = name, exponent = 1;
    for (;;) {
      if (words[at] === "'") symbol += words[at++];
      else if (words[at] === "_") { ++at; symbol += "_" + written(); }
      else if (words[at] === "^" && /^(\*|\(|\\prime)$/.test(words[at + 1] === "{" ? words[at + 2] : words[at + 1])) { ++at; symbol += written(); }
      else if (words[at] === "^") { ++at; exponent *= group(); }
      else break;
    }
    if (!name && symbol) fail();
    const base = name ? number_of(symbol) : value;
    return exponent === 1 ? base : Math.pow(Math.abs(base), exponent);
  }
  function atom() {
    const word = words[at];
    if (word === undefined || without_value.test(word)) fail();
    if (word === "{") return with_scripts(group(), "");
    if (/^(\d.*|[([|]|\\.|[A-Za-z]|\\[A-Za-z]+)$/.test(word)) ++at;
    else fail();
    if (/^\d/.test(word)) return with_scripts(Number(word), "");
    if (/^([([]|\\\{)$/.test(word)) {
      const bars = open_bars;
      open_bars = 0;
      const value = sum();
      open_bars = bars;
      take(/^([)\]]|\\\})$/);
      return with_scripts(value, "");
    }
    if (word === "|") {
      ++open_bars;
      const value = Math.abs(sum());
      --open_bars;
      take(/^\|$/);
      return with_scripts(value, "");
    }
    if (/frac$/.test(word)) return group() / group();
    if (word === "\\sqrt") return with_scripts(Math.sqrt(Math.abs(group())), "");
    if (functions[word]) {
      const exponent = words[at] === "^" ? (++at, group()) : 1, value = functions[word](argument());
      return exponent === 1 ? value : Math.pow(Math.abs(value), exponent);
    }
    return with_scripts(0, with_argument.test(word) ? word + written() : word);
  }
  const goes_on = () => words[at] !== undefined && !ends_product.test(words[at]) && !relation.test(words[at]) && !(open_bars && words[at] === "|");
  const is_bracket = () => /^[([]$/.test(words[at]);
  function argument() {
    if (is_bracket()) return atom();
    let value = atom();
    while (goes_on() && !functions[words[at]] && !is_bracket() && !/^(\/|\\cdot)$/.test(words[at])) value *= atom();
    return value;
  }
  function product() {
    let value = atom();
    while (goes_on()) {
      if (words[at] === "/") { ++at; value /= atom(); }
      else {
        if (words[at] === "\\cdot") ++at;
        value *= atom();
      }
    }
    return value;
  }
  function sum() {
    let value = 0;
    do {
      const sign = /^[+-]$/.test(words[at]) ? words[at++] : "+";
      value += sign === "-" ? -product() : product();
    } while (/^[+-]$/.test(words[at]));
    return value;
  }

  const values = [];
  try {
    while (at < words.length) {
      values.push(sum());
      if (at < words.length) take(relation);
      while (words[at] === ",") ++at;
    }
  } catch (error) {
    if (error instanceof RangeError) return undefined;
    throw error;
  }
  return values;
}
