// Parts that every page shares: the state in the address, controls, pictures in SVG with their tables, what is announced and copied.
'use strict';
const { ContactMotion } = require('../../tests/conformance/adapters/javascript/contact_motion.js');

const escaped = (text) => String(text).replace(/[&<>"]/g, (c) => ({ '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' })[c]);
const byId = (id) => document.getElementById(id);
const list = (text) =>
    String(text)
        .split(',')
        .map((word) => (word.trim() === '' ? NaN : Number(word)));
const short = (x, digits = 6) => (Number.isFinite(x) ? String(Number(x.toPrecision(digits))) : 'none');
const exactly = (x) => (Number.isFinite(x) ? x.toPrecision(12) : 'none');

// The state is a flat record of words; the address holds those that are not the defaults.
function stateOf(defaults, hash = location.hash) {
    const state = { ...defaults };
    for (const part of hash.replace(/^#/, '').split('&')) {
        const [key, value] = part.split('=');
        if (key in defaults && value !== undefined) state[key] = decodeURIComponent(value);
    }
    return state;
}
const hashOf = (state, defaults = {}) =>
    '#' +
    Object.entries(state)
        .filter(([key, value]) => String(value) !== String(defaults[key]))
        .map(([key, value]) => key + '=' + encodeURIComponent(value).replace(/%2C/g, ','))
        .join('&');

// The scene of a state, as `denhartog solve` takes it. Lists may be shorter than N: their last number goes on.
const sceneDefaults = { N: 1, g: '1', k: '1', z: '0.05', j: 1, l: 1, mu: 1, r: 0.5, b: 0.4 };
const sceneKeys = Object.keys(sceneDefaults);
function sceneOf(state) {
    const N = Number(state.N),
        filled = (text) => {
            const all = list(text);
            return Array.from({ length: N }, (_, n) => all[Math.min(n, all.length - 1)]);
        };
    return {
        mass_ratios: filled(state.g),
        stiffness_ratios: filled(state.k),
        damping_ratios: filled(state.z),
        contact: Math.min(N, Number(state.j)),
        load: Math.min(N, Number(state.l)),
        mu: Number(state.mu),
        r: Number(state.r),
        beta: Number(state.b),
    };
}
// The rule that a scene breaks, in words with the value; null where it breaks none.
function brokenRule(scene) {
    const say = (quantity, rule, value) => quantity + ' must ' + rule + ', but is ' + value;
    const lists = [
        ['mass_ratios', 'mass ratios'],
        ['stiffness_ratios', 'stiffness ratios'],
    ];
    for (const [key, name] of lists) {
        for (const [n, y] of scene[key].entries())
            if (!(y > 0 && y < Infinity)) return say(name + ', number ' + (n + 1), 'be positive', y);
        if (scene[key][0] !== 1) return say('the first of the ' + name, 'be 1', scene[key][0]);
    }
    for (const [n, y] of scene.damping_ratios.entries())
        if (!(y >= 0 && y < Infinity)) return say('damping ratio ' + (n + 1), 'not be negative', y);
    if (!(scene.mu >= 1 && scene.mu < Infinity)) return say('mu', 'be at least 1', scene.mu);
    if (!(scene.r > 0 && scene.r < Infinity)) return say('r', 'be positive', scene.r);
    if (!(scene.beta >= 0 && scene.beta < Infinity)) return say('beta', 'not be negative', scene.beta);
    return null;
}
const commandOf = (scene, options = '') => `echo '${JSON.stringify(scene)}' | denhartog solve -${options}`;

// The regime that the boundaries tell; null at a pole, where a mode without damping is at its resonance.
function regimeOf(motion) {
    try {
        return motion.regime();
    } catch (fault) {
        if (!(fault instanceof RangeError)) throw fault;
        return null;
    }
}

// The motion of a scene, shared out over frames: work(budget in milliseconds) goes on until { steady } is there.
// Before that, `shown` is the motion over one period from where the search is.
class Search {
    constructor(scene, start = null) {
        this.motion = scene instanceof ContactMotion ? scene : new ContactMotion(scene);
        try {
            // With mu > 1 there may be several steady motions: as denhartog solve does, the one from rest is looked for.
            const found = this.motion.mu > 1 && this.motion.beta > 0 ? null : this.motion.formula();
            if (found) this.steady = this.motion.steady(found);
            else this.search = this.motion.search(start);
        } catch (fault) {
            this.fails(fault);
        }
    }
    fails(fault) {
        // what has no answer is told; a mistake of the program is not hidden
        if (!(fault instanceof RangeError)) throw fault;
        this.failed = fault.message;
    }
    work(milliseconds) {
        const end = performance.now() + milliseconds;
        while (!this.steady && !this.failed) {
            try {
                const { done, value } = this.search.next();
                if (done) this.steady = this.motion.steady(value);
                else this.at = value;
            } catch (fault) {
                this.fails(fault);
            }
            if (performance.now() > end) break;
        }
        return !this.steady && !this.failed;
    }
    get shown() {
        if (this.steady || !this.at) return this.steady;
        if (this.seen?.z !== this.at) {
            try {
                this.seen = this.motion.steady({ z: this.at, h: 1, residual: NaN, half_periods: 0 });
            } catch (fault) {
                this.fails(fault);
            }
        }
        return this.seen;
    }
}

// Work that lasts longer than a frame: a generator whose steps are taken some milliseconds a frame. A later call
// of the same name ends the one before.
function background(name, generator, done = () => {}) {
    const key = {};
    background.running ??= {};
    background.running[name] = key;
    const go = () => {
        if (background.running[name] !== key) return;
        const end = performance.now() + 10;
        for (;;) {
            if (generator.next().done) {
                delete background.running[name];
                return done();
            }
            if (performance.now() > end) break;
        }
        setTimeout(go, 0);
    };
    setTimeout(go, 0);
}
const busy = (...apart) => Object.keys(background.running ?? {}).some((name) => !apart.includes(name));

// A range with its number field. The range may be a logarithm's; the number field takes what lies beyond the range.
function control({ key, label, from, to, step, log = false, note = '' }) {
    const range = log
        ? `min="${Math.log10(from)}" max="${Math.log10(to)}" step="0.005"`
        : `min="${from}" max="${to}" step="${step}"`;
    return (
        `<div class="control"><label for="number-${key}">${label}</label>
<input type="range" id="range-${key}" ${range} aria-label="${escaped(label.replace(/<[^>]+>/g, ''))}, slider">
<input type="number" id="number-${key}" step="any" inputmode="decimal"></div>` +
        (note ? `<p class="note" id="note-${key}">${note}</p>` : '')
    );
}
const choice = ({ key, label, options }) =>
    `<div class="control"><label for="choice-${key}">${label}</label><select id="choice-${key}">` +
    options.map(([value, text]) => `<option value="${escaped(value)}">${escaped(text)}</option>`).join('') +
    '</select></div>';
const words = ({ key, label }) =>
    `<div class="control"><label for="words-${key}">${label}</label>` +
    `<input type="text" id="words-${key}" autocomplete="off" spellcheck="false"></div>`;
const sceneControls = [
    { key: 'r', label: 'frequency ratio <i>r</i>', from: 0.05, to: 3, step: 0.005 },
    { key: 'b', label: 'friction ratio <i>β</i>', from: 0, to: 1.5, step: 0.005 },
    { key: 'z', label: 'damping ratio <i>ζ</i>, all modes', from: 0, to: 0.5, step: 0.001 },
    { key: 'mu', label: 'static over kinetic friction <i>μ</i>', from: 1, to: 2, step: 0.01 },
    { key: 'N', label: 'masses <i>N</i>', from: 1, to: 5, step: 1, whole: true },
    { key: 'j', label: 'mass in contact <i>j</i>', from: 1, to: 5, step: 1, whole: true, most: 'N' },
    { key: 'l', label: 'loaded mass <i>l</i>', from: 1, to: 5, step: 1, whole: true, most: 'N' },
];
const sceneWords = [
    { key: 'g', label: 'mass ratios <i>γ</i>' },
    { key: 'k', label: 'stiffness ratios <i>κ</i>' },
    { key: 'zs', label: 'damping ratios <i>ζ</i>, mode by mode', of: 'z' },
];

// Builds the controls of a page into #controls, keeps state and address, and calls `changed(state)` after each change.
function controls({ defaults, own = [], after = [], choices = [], scene = true, presets = [], changed }) {
    const ranges = [...own, ...(scene ? sceneControls : []), ...after],
        texts = scene ? sceneWords : [];
    let state = stateOf(defaults);
    byId('controls').innerHTML =
        (presets.length
            ? choice({
                  key: 'preset',
                  label: 'open',
                  options: [['', 'a scene of the paper …'], ...presets.map(([name, hash]) => [hash, name])],
              })
            : '') +
        choices.map(choice).join('') +
        ranges.map(control).join('') +
        (texts.length
            ? `<details><summary>Unequal masses, springs and damping</summary>${texts.map(words).join('')}
<p class="note">Numbers with commas between them, from the first on. Where there are fewer than masses, the last one goes
on.</p></details>`
            : '') +
        '<p id="fault" role="alert"></p>';
    const show = (except) => {
        for (const { key, log } of ranges) {
            const value = list(state[key])[0];
            if (!Number.isFinite(value)) continue; // the page places it
            for (const [id, y] of [
                ['range-' + key, log ? Math.log10(value) : value],
                ['number-' + key, value],
            ])
                if (byId(id) !== except) byId(id).value = y;
            byId('range-' + key).setAttribute('aria-valuetext', short(value));
        }
        for (const { key, of = key } of texts) if (byId('words-' + key) !== except) byId('words-' + key).value = state[of];
        for (const { key } of choices) byId('choice-' + key).value = state[key];
        for (const { key, most } of ranges)
            if (most) for (const kind of ['range-', 'number-']) byId(kind + key).max = state[most];
    };
    const ruleBroken = (next) => {
        for (const { key, label, from, to, whole, strict, free } of ranges) {
            if (free && next[key] === '') continue;
            const y = list(next[key])[0],
                name = label.replace(/<[^>]+>/g, '');
            if (!Number.isFinite(y)) return name + ' must be a number, but is ' + (next[key] === '' ? 'empty' : next[key]);
            if (whole && !(Number.isInteger(y) && y >= from && y <= to))
                return `${name} must be a whole number from ${from} to ${to}, but is ${y}`;
            if (strict && !(y >= from && y <= to)) return `${name} must be from ${from} to ${to}, but is ${y}`;
        }
        return scene ? brokenRule(sceneOf(next)) : null;
    };
    const take = (next, except) => {
        const broken = ruleBroken(next);
        byId('fault').textContent = broken ?? '';
        if (broken) return;
        if (scene) for (const key of ['j', 'l']) next[key] = Math.min(Number(next[key]), Number(next.N));
        state = next;
        show(except);
        keepAddress(hashOf(state, defaults));
        changed(state);
    };
    for (const { key, log } of ranges) {
        byId('range-' + key).addEventListener('input', (e) =>
            take({ ...state, [key]: log ? short(10 ** e.target.value, 4) : e.target.value }, e.target),
        );
        byId('number-' + key).addEventListener('input', (e) => take({ ...state, [key]: e.target.value }, e.target));
    }
    for (const { key, of = key } of texts)
        byId('words-' + key).addEventListener('change', (e) =>
            take({ ...state, [of]: e.target.value.replace(/\s/g, '') }, e.target),
        );
    for (const { key } of choices)
        byId('choice-' + key).addEventListener('change', (e) => take({ ...state, [key]: e.target.value }));
    if (presets.length)
        byId('choice-preset').addEventListener('change', (e) => {
            if (e.target.value) take(stateOf({ ...defaults }, e.target.value));
        });
    addEventListener('hashchange', () => take(stateOf(defaults)));
    const set = (part) => take({ ...state, ...part });
    take(state);
    return { set, get: () => state };
}

// Writes the state into the address: at once after a pause, else once the slider rests, as browsers allow few such calls.
function keepAddress(hash) {
    clearTimeout(keepAddress.timer);
    const write = () => {
        keepAddress.last = performance.now();
        history.replaceState(null, '', hash === '#' ? location.pathname : hash);
    };
    if (performance.now() - (keepAddress.last ?? -1e9) > 400) write();
    else keepAddress.timer = setTimeout(write, 150);
}

// Says the last of several texts, politely, once nothing has changed for a while.
function announce(text) {
    if (announce.pending === text) return;
    announce.pending = text;
    clearTimeout(announce.timer);
    announce.timer = setTimeout(() => {
        byId('status').textContent = text;
    }, 400);
}
function copies(scene, options = '') {
    const texts = { 'copy-command': commandOf(scene, options), 'copy-scene': JSON.stringify(scene) };
    byId('command').textContent = texts['copy-command'];
    for (const [id, text] of Object.entries(texts)) byId(id).onclick = () => copied(text, byId(id));
}
async function copied(text, button) {
    const said = button.textContent;
    try {
        await navigator.clipboard.writeText(text);
    } catch {
        const area = document.createElement('textarea');
        area.value = text;
        document.body.append(area);
        area.select();
        document.execCommand('copy');
        area.remove();
        button.focus();
    }
    byId('status').textContent = 'Copied.';
    clearTimeout(button.timer);
    button.textContent = 'Copied';
    button.timer = setTimeout(() => {
        button.textContent = button.dataset.says ?? said;
    }, 1200);
}

// A table under a picture, filled while it is open.
const tables = {};
function table(id, heads, rows) {
    tables[id] = { heads, rows };
    if (byId(id)?.open) fill(id);
}
function fill(id) {
    const { heads, rows } = tables[id],
        all = typeof rows === 'function' ? rows() : rows;
    byId(id).querySelector('.table-box').innerHTML =
        `<table class="facts"><thead><tr>${heads.map((h) => `<th scope="col">${h}</th>`).join('')}</tr></thead><tbody>` +
        all
            .map(
                (row) =>
                    '<tr>' +
                    row.map((cell) => `<td>${typeof cell === 'number' ? short(cell, 8) : escaped(cell)}</td>`).join('') +
                    '</tr>',
            )
            .join('') +
        '</tbody></table>';
}
function openTables() {
    for (const details of document.querySelectorAll('details.table-view')) {
        const box = details.querySelector('.table-box');
        box.tabIndex = 0;
        box.setAttribute('role', 'region');
        box.setAttribute('aria-label', details.querySelector('summary').textContent);
        details.addEventListener('toggle', () => {
            if (details.open && tables[details.id]) fill(details.id);
        });
    }
}

// A table of figures. A row's first cell heads it; a cell is text, or [name, text], by which name the tests find it.
function figures(heads, rows) {
    const cell = (c) => (Array.isArray(c) ? `<td data-number="${c[0]}">${c[1]}</td>` : `<td>${c}</td>`);
    const head = heads ? `<thead><tr>${heads.map((h) => `<th scope="col">${h}</th>`).join('')}</tr></thead>` : '';
    const body = rows.map(([first, ...cells]) => `<tr><th scope="row">${first}</th>${cells.map(cell).join('')}</tr>`).join('');
    return `<table class="facts">${head}<tbody>${body}</tbody></table>`;
}

// Axes with round numbers.
function ticks([from, to], most = 6) {
    const raw = (to - from) / most,
        power = 10 ** Math.floor(Math.log10(raw)),
        step = power * [1, 2, 5, 10].find((s) => s * power >= raw);
    const all = [];
    for (let n = Math.ceil(from / step - 1e-9); n * step <= to + 1e-9 * step; ++n) all.push(Number((n * step).toPrecision(10)));
    return all;
}
function span(values, around = 0.06, least = 1e-12) {
    let low = Infinity,
        high = -Infinity;
    for (const y of values)
        if (Number.isFinite(y)) {
            if (y < low) low = y;
            if (y > high) high = y;
        }
    if (!(low <= high)) return [0, 1];
    const more = Math.max((high - low) * around, least, Math.abs(high) * 1e-9);
    return [low - more, high + more];
}
// Draws axes, bands, lines and marks into an <svg>: x and y are { span, label, log, ticks }, lines { points, style }.
const shapes = { width: 640, height: 300, left: 62, right: 14, top: 14, bottom: 44 };
// The width of a picture, read once until the window changes: reading it makes the browser lay out all that was just drawn.
const widths = {};
const widthOf = (id) => (widths[id] ??= Math.max(260, Math.round(byId(id).clientWidth || shapes.width)));
const resized = (redraw) =>
    addEventListener('resize', () => {
        for (const id of Object.keys(widths)) delete widths[id];
        redraw();
    });
function frameOf(id, { x, y, height = shapes.height }) {
    const width = widthOf(id);
    const { left, right, top, bottom } = shapes;
    return {
        width,
        height,
        X: (v) => left + ((v - x.span[0]) / (x.span[1] - x.span[0])) * (width - left - right),
        Y: (v) => height - bottom - ((v - y.span[0]) / (y.span[1] - y.span[0])) * (height - top - bottom),
    };
}
// An element of a drawing; numbers to a tenth of a pixel.
function tag(name, attributes, inside = '') {
    const said = (y) => (typeof y === 'number' ? Math.round(10 * y) / 10 : y);
    const all = Object.entries(attributes).map(([key, y]) => ` ${key}="${said(y)}"`);
    return `<${name}${all.join('')}>${inside}</${name}>`;
}
function into(id, width, height, title, inside) {
    const svg = byId(id);
    svg.setAttribute('viewBox', `0 0 ${width} ${height}`);
    svg.setAttribute('role', 'img');
    svg.setAttribute('aria-label', title);
    svg.style.height = height + 'px';
    svg.innerHTML = tag('title', {}, escaped(title)) + inside;
}
function plot(id, { x, y, bands = [], lines = [], marks = [], height, title, rules = [] }) {
    const f = frameOf(id, { x, y, height }),
        { left, right, top, bottom } = shapes,
        out = [];
    const all = { x: left, y: top, width: f.width - left - right, height: f.height - top - bottom },
        end = f.width - right,
        foot = f.height - bottom;
    const xs = x.ticks ?? ticks(x.span, f.width < 500 ? 5 : 7),
        ys = y.ticks ?? ticks(y.span, 5);
    const inside = (v, [a, b]) => v >= a - 1e-9 * (b - a) && v <= b + 1e-9 * (b - a);
    const said = (axis, v) => (axis.log ? '10' + tag('tspan', { dy: -5, class: 'power' }, v) : v);
    const upright = (v, style) => tag('line', { class: style, x1: f.X(v), x2: f.X(v), y1: top, y2: foot });
    for (const [from, to] of bands) {
        const a = f.X(Math.max(from, x.span[0])),
            b = f.X(Math.min(to, x.span[1]));
        if (b > a) out.push(tag('rect', { ...all, class: 'band', x: a, width: b - a }));
    }
    for (const v of xs.filter((each) => inside(each, x.span)))
        out.push(
            upright(v, 'grid'),
            tag('text', { class: 'tick', x: f.X(v), y: foot + 17, 'text-anchor': 'middle' }, said(x, v)),
        );
    for (const v of ys.filter((each) => inside(each, y.span)))
        out.push(
            tag('line', { class: 'grid', x1: left, x2: end, y1: f.Y(v), y2: f.Y(v) }),
            tag('text', { class: 'tick', x: left - 7, y: f.Y(v) + 4, 'text-anchor': 'end' }, said(y, v)),
        );
    const middle = (top + foot) / 2,
        turned = { x: 14, y: middle, transform: `rotate(-90 14 ${middle})` };
    out.push(
        tag('rect', { ...all, class: 'frame' }),
        tag('text', { class: 'axis', x: (left + end) / 2, y: f.height - 6, 'text-anchor': 'middle' }, indexed(x.label)),
        tag('text', { class: 'axis', ...turned, 'text-anchor': 'middle' }, indexed(y.label)),
    );
    const paths = lines.map(({ points, style }) => ({ style, d: pathOf(points, f, y.span) })),
        halos = paths.filter(({ style }) => style.includes('over')); // below lines that lie over colours
    const drawn = [
        ...halos.map(({ d }) => tag('path', { class: 'halo', d })),
        ...paths.map(({ style, d }) => tag('path', { class: 'line ' + style, d })),
    ];
    for (const { at, style = '' } of rules) drawn.push(upright(at, 'rule ' + style));
    for (const { at, style = '', size = 5, id: name } of marks)
        if (at.every(Number.isFinite))
            drawn.push(
                tag('circle', { class: 'mark ' + style, ...(name ? { id: name } : {}), cx: f.X(at[0]), cy: f.Y(at[1]), r: size }),
            );
    out.push(
        tag('clipPath', { id: 'clip-' + id }, tag('rect', all)),
        tag('g', { 'clip-path': `url(#clip-${id})` }, drawn.join('')),
    );
    into(id, f.width, f.height, title, out.join(''));
    return f;
}
function pathOf(points, f, [low, high]) {
    let d = '',
        pen = 'M';
    const far = 3 * (high - low);
    for (const [a, b] of points) {
        if (!Number.isFinite(b) || !Number.isFinite(a)) {
            pen = 'M';
            continue;
        }
        d += pen + f.X(a).toFixed(1) + ' ' + f.Y(Math.max(low - far, Math.min(high + far, b))).toFixed(1);
        pen = 'L';
    }
    return d;
}
// x_k and the like, with their indices low; for pictures and for text.
const indexed = (text) =>
    text.replace(/_([A-Za-z0-9∞]+)/g, '<tspan dy="3" class="power">$1</tspan><tspan dy="-3">\u200b</tspan>');
const lowered = (text) => text.replace(/_([A-Za-z0-9∞]+)/g, '<sub>$1</sub>');
const sample = (style) =>
    `<svg class="sample" viewBox="0 0 26 10" aria-hidden="true">${tag('path', { class: 'line ' + style, d: 'M1 5H25' })}</svg>`;
const legend = (id, lines) => {
    byId(id).innerHTML = lines.map(({ name, style }) => `<li>${sample(style)}${name}</li>`).join('');
};
const equationLink = (eq) => `<a href="../eq_${eq.replace('.', '_')}.html">(${eq})</a>`;

module.exports = {
    escaped,
    byId,
    list,
    short,
    exactly,
    stateOf,
    hashOf,
    sceneDefaults,
    sceneKeys,
    sceneOf,
    brokenRule,
    commandOf,
    Search,
    background,
    busy,
    controls,
    announce,
    copies,
    table,
    openTables,
    regimeOf,
    tag,
    into,
    widthOf,
    resized,
    sample,
    figures,
    ticks,
    span,
    plot,
    pathOf,
    legend,
    lowered,
    shapes,
    equationLink,
};
