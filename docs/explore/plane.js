// The regime plane: amplitude or stops over (r, beta), the boundaries, and two slices.
'use strict';
const { ContactMotion } = require('../../tests/conformance/adapters/javascript/contact_motion.js');
const { equations } = require('./printed.js');
const P = require('./page.js');
const { byId, short } = P;
const { PI, cosh, sinh, abs, max, min, log10 } = Math;

const spring88 = equations.find(({ eq }) => eq[0] === '88').printed;
const switches = [
    { key: 'e', name: '(69), with the largest value of the sum', style: 'm1', of: (c) => c.beta_lim(c.demand()) },
    { key: 's', name: '(69) with (56), the sum of the largest values', style: 'm2', of: (c) => c.beta_lim(c.S_dj()) },
    { key: 'a', name: '(67), approximate', style: 'm3', of: (c) => c.beta_lim(0) },
    { key: 'p', name: '(88), permanent sticking by the spring', style: 'm4', of: spring88 },
    { key: 'h', name: 'permanent sticking with all forces', style: 'm5', of: (c) => c.held().limit },
    { key: 'n', name: '(85), at each resonance', style: 'm4' },
];
const presets = [
    ['Fig. 7, ζ = 0.001', '#z=0.001&r=0.7&b=0.4'],
    ['Fig. 7, ζ = 0.01', '#z=0.01&r=0.7&b=0.4'],
    ['Fig. 7, ζ = 0.1', '#z=0.1&r=0.7&b=0.4'],
    ...[0.001, 0.01, 0.1].map((zeta) => [
        'Fig. 10, ζ = ' + zeta + ' / r_n',
        `#N=2&z=${(zeta / 0.6180339887498949).toPrecision(12)},${(zeta / 1.618033988749895).toPrecision(12)}&j=2&l=1&r=0.9&b=0.2`,
    ]),
    ['Figs. 6 and 12, at resonance', '#z=0.05&r=1&b=0.3'],
    ['Figs. 8 and 9', '#N=2&z=0.0161803398875,0.0061803398875&j=2&l=1&r=1.2&b=0.2'],
];
const least = 0.04; // of r: below, a motion takes long to follow
// A colour between dark blue and yellow, lighter with t; all of them keep a light line and a dark one apart.
const stops = [
    [68, 1, 84],
    [59, 82, 139],
    [33, 145, 140],
    [94, 201, 98],
    [253, 231, 37],
];
function colour(t) {
    const u = max(0, min(1, t)) * (stops.length - 1),
        n = min(stops.length - 2, Math.floor(u)),
        part = u - n;
    return stops[n].map((a, i) => Math.round(a + part * (stops[n + 1][i] - a)));
}
// Amplitude of mass k (-1: the contact) or stops a period at a point; `near` is a state to start from, and becomes the one found.
function* seen(c, quantity, near) {
    const regime = c.regime(),
        k = quantity === 'stops' || quantity === '0' ? c.j : min(Number(quantity) - 1, c.gamma.length - 1);
    if (regime === 'permanent_sticking') return { value: quantity === 'stops' ? 0 : Math.hypot(...c.held().X[k]), regime };
    if (regime === 'continuous') return { value: quantity === 'stops' ? 0 : c.amplitudeAndPhase(k)[0], regime };
    const search = new P.Search(c, near.z);
    for (let n = 0; n < 13 && search.work(0); ++n) yield; // a motion that has not settled by then is shown as it is
    if (search.steady) near.z = search.steady.z;
    const { shown } = search;
    return {
        value: !shown ? NaN : quantity === 'stops' ? shown.stops.length / shown.periods : shown.masses[k].amplitude,
        regime,
        settled: Boolean(search.steady),
    };
}
function* seenOver(list, sceneAt, quantity, out) {
    const near = { z: null };
    for (const x of list) {
        let point = { value: NaN };
        try {
            point = yield* seen(sceneAt(x), quantity, near);
        } catch (fault) {
            if (!(fault instanceof RangeError)) throw fault;
        }
        out.push({ x, ...point });
        yield true; // a point is there
    }
}

const linked = (name) => name.replace(/\((\d+)\)/, (_, eq) => P.equationLink(eq));
const words = {
    continuous: 'the contact slides throughout',
    stick_slip: 'it sticks and slips',
    permanent_sticking: 'it never moves',
    none: 'an undamped mode is at its resonance',
};

module.exports = function plane() {
    const defaults = { ...P.sceneDefaults, r: 0.7, q: '0', rmax: 2.5, bmax: 1.25, on: 'eah' };
    let drawn = '',
        state = null,
        scene = null,
        curves = [],
        cells = null,
        f = null,
        slices = null,
        kept = null,
        begun = false;
    const counters = { cells: 0, renders: 0 };
    byId('switches').insertAdjacentHTML(
        'beforeend',
        switches
            .map(
                ({ key, name, style }) =>
                    `<label><input type="checkbox" id="on-${key}">${P.sample(style)}<span>${linked(name)}</span></label>`,
            )
            .join(''),
    );
    for (const { key } of switches)
        byId('on-' + key).onchange = (e) => kept.set({ on: state.on.replace(key, '') + (e.target.checked ? key : '') });

    const rs = (n) => Array.from({ length: n }, (_, i) => least + ((Number(state.rmax) - least) * (i + 0.5)) / n);
    const bs = (n) => Array.from({ length: n }, (_, i) => (Number(state.bmax) * (i + 0.5)) / n);
    const changed = (next) => {
        state = next;
        scene = P.sceneOf(state);
        P.copies(scene);
        for (const { key } of switches) byId('on-' + key).checked = state.on.includes(key);
        byId('to-machine').href =
            'machine.html' + P.hashOf(Object.fromEntries(P.sceneKeys.map((key) => [key, state[key]])), P.sceneDefaults);
        const c = new ContactMotion(scene),
            here = JSON.stringify([
                state.N,
                state.g,
                state.k,
                state.z,
                state.j,
                state.l,
                state.mu,
                state.q,
                state.rmax,
                state.bmax,
            ]);
        const lim = c.beta_lim(c.demand()),
            { limit } = c.held(),
            regime = P.regimeOf(c) ?? 'none';
        byId('regime').innerHTML =
            `<strong>r = ${short(scene.r)}, β = ${short(scene.beta)}: ${words[regime]}.</strong> Sliding ends at
β = <span data-number="beta_lim_exact">${P.exactly(lim)}</span>; the contact never moves from
β = <span data-number="beta_sticking">${P.exactly(limit)}</span>.`;
        P.announce(`r ${short(scene.r)}, beta ${short(scene.beta)}. ${regime.replace('_', ' ')}.`);
        if (here !== drawn) {
            drawn = here;
            curves = [];
            cells = {
                columns: 96,
                rows: 64,
                values: new Float64Array(96 * 64).fill(NaN),
                regimes: new Uint8Array(96 * 64),
                low: Infinity,
                high: -Infinity,
            };
            P.background('lines', lines(), () => draw());
            begun = false;
            P.background('cells', (function* () {})());
        }
        P.background('slices', both(), () => {
            drawSlices();
            if (!begun) P.background('cells', fill(), paint); // the plane comes last: what stands beside it answers the hand
            begun = true;
        });
        draw();
    };
    function* lines() {
        const found = switches.map(() => []);
        for (const r of rs(160)) {
            const c = new ContactMotion({ ...scene, r });
            for (const [n, { of }] of switches.entries())
                if (of) {
                    let y = NaN;
                    try {
                        y = of(c);
                    } catch (fault) {
                        if (!(fault instanceof RangeError)) throw fault;
                    }
                    found[n].push([r, y]);
                }
            yield;
        }
        curves = found;
    }
    // Columns from coarse to fine, those of high r first, which cost least; in a column upwards, each search from the motion
    // below.
    function* fill() {
        const own = cells,
            { columns, rows } = own,
            allR = rs(columns),
            allB = bs(rows),
            quantity = state.q,
            base = scene;
        for (const [stride, first] of [
            [8, 0],
            [8, 4],
            [4, 2],
            [2, 1],
        ])
            for (let column = columns - stride + first; column >= 0; column -= stride) {
                const c = new ContactMotion({ ...base, r: allR[column] }),
                    out = [];
                for (const there of seenOver(allB, (beta) => c.withFriction(beta), quantity, out)) {
                    if (!there) {
                        yield;
                        continue;
                    }
                    ++counters.cells;
                    const row = out.length - 1,
                        { value, regime } = out[row],
                        width = stride === 8 && first === 0 ? 8 : stride === 8 ? 4 : stride / 2;
                    for (let n = column; n < min(columns, column + width); ++n) {
                        own.values[n * rows + row] = value;
                        own.regimes[n * rows + row] = { continuous: 1, stick_slip: 2, permanent_sticking: 3 }[regime] ?? 0;
                    }
                    if (Number.isFinite(value) && value > 0) {
                        own.low = min(own.low, value);
                        own.high = max(own.high, value);
                    }
                    yield;
                }
                if (own === cells) paint();
            }
    }
    function* both() {
        const atR = [],
            atB = [],
            { beta } = scene,
            c = new ContactMotion(scene),
            low = least;
        slices = { atR, atB };
        yield* seenOver(bs(90), (b) => c.withFriction(b), state.q, atB);
        drawSlices();
        yield* seenOver(
            Array.from({ length: 140 }, (_, n) => low + ((Number(state.rmax) - low) * (n + 0.5)) / 140),
            (x) => new ContactMotion({ ...scene, r: x, beta }),
            state.q,
            atR,
        );
    }
    const quantityName = () =>
        state.q === 'stops'
            ? 'stops per period'
            : state.q === '0'
              ? 'amplitude of the contact'
              : 'amplitude of mass ' + min(Number(state.q), Number(state.N));
    const draw = () => {
        ++counters.renders;
        const x = { span: [0, Number(state.rmax)], label: 'frequency ratio r' },
            y = { span: [0, Number(state.bmax)], label: 'friction ratio β' };
        const shown = switches.flatMap((s, n) =>
            state.on.includes(s.key) && curves[n]?.length ? [{ points: curves[n], style: s.style + ' over' }] : [],
        );
        const marks = [{ at: [scene.r, scene.beta], size: 7, style: 'here' }];
        const c = new ContactMotion(scene);
        const peaks = c.modes.map((m) => {
            const t = PI * m.zeta,
                ratio = abs(m.phi[c.l] / m.phi[c.j]);
            return [m.r_n, ratio * (t > 1e-8 ? (cosh(t) - 1) / (2 * m.zeta * sinh(t)) : PI / 4)];
        });
        if (state.on.includes('n')) for (const at of peaks) marks.push({ at, size: 7, style: 'ring' });
        byId('plane-caption').textContent = 'Colour: ' + quantityName();
        f = P.plot('lines', {
            x,
            y,
            lines: shown,
            marks,
            height: 430,
            title: `Regime plane: ${quantityName()} over frequency ratio and friction ratio`,
        });
        P.table('plane-table', ['r', ...switches.filter((s) => s.of).map((s) => s.name)], () =>
            (curves[0] ?? [])
                .filter((_, n) => n % 4 === 0)
                .map(([r], n) => [r, ...switches.filter((s) => s.of).map((_, i) => curves[i][4 * n]?.[1])]),
        );
        paint();
    };
    const paint = () => {
        if (!f) return;
        const canvas = byId('colours'),
            { left, right, top, bottom } = P.shapes,
            { columns, rows, values, regimes, low, high } = cells;
        canvas.style.left = left + 'px';
        canvas.style.top = top + 'px';
        canvas.style.width = f.width - left - right + 'px';
        canvas.style.height = f.height - top - bottom + 'px';
        canvas.width = columns * 4;
        canvas.height = rows * 4;
        const context = canvas.getContext('2d'),
            image = context.createImageData(columns * 4, rows * 4),
            stopsShown = state.q === 'stops';
        const part = (v) =>
            stopsShown ? v / max(2, high) : high > low ? (log10(max(v, low)) - log10(low)) / (log10(high) - log10(low)) : 0.5;
        for (let py = 0; py < rows * 4; ++py)
            for (let px = 0; px < columns * 4; ++px) {
                const n = (px >> 2) * rows + (rows - 1 - (py >> 2)),
                    v = values[n],
                    at = 4 * (py * columns * 4 + px);
                if (!regimes[n] || !Number.isFinite(v)) continue;
                const still = regimes[n] === 3,
                    rgb = still && !(v > 0) ? [128, 128, 128] : colour(part(v));
                const hatch = still && (px + py) % 8 < 2 ? 0.45 : regimes[n] === 2 && (px + rows * 4 - py) % 8 === 0 ? 0.8 : 1;
                for (let i = 0; i < 3; ++i) image.data[at + i] = rgb[i] * hatch;
                image.data[at + 3] = 255;
            }
        context.putImageData(image, 0, 0);
        const bar = Array.from({ length: 11 }, (_, n) => `rgb(${colour(n / 10)})`).join(',');
        const end = (value, digits) => (Number.isFinite(value) ? short(value, digits) : '…');
        byId('scale').innerHTML = `<span>${stopsShown ? 0 : end(low, 2)}</span><span class="bar" aria-hidden="true"
style="background: linear-gradient(90deg, ${bar})"></span><span>${end(stopsShown ? max(2, high) : high, 3)},
${quantityName()}${stopsShown ? '' : ', logarithmic'}</span><span>thin strokes: sticks and slips; thick: never moves</span>`;
    };
    const drawSlices = () => {
        const { atR, atB } = slices,
            label = quantityName();
        for (const [id, points, x, here] of [
            ['over-r', atR, { span: [0, Number(state.rmax)], label: 'frequency ratio r' }, scene.r],
            ['over-b', atB, { span: [0, Number(state.bmax)], label: 'friction ratio β' }, scene.beta],
        ]) {
            if (!points.length) continue;
            const line = (regime) =>
                points.map((p, n) => [p.x, p.regime === regime || points[n - 1]?.regime === regime ? p.value : NaN]);
            P.plot(id, {
                x,
                y: { span: [0, P.span(points.map((p) => p.value))[1]], label },
                height: 240,
                rules: [{ at: here }],
                lines: [
                    { points: line('continuous'), style: 'm1' },
                    { points: line('stick_slip'), style: 'm2' },
                    { points: line('permanent_sticking'), style: 'm5' },
                ],
                title: `${label} over ${x.label}: solid where the contact slides, dashed where it sticks`,
            });
            P.table(id + '-table', [x.label, label, 'regime'], () =>
                points.map((p) => [p.x, p.value, (p.regime ?? 'none').replace('_', ' ')]),
            );
        }
    };
    const to = (r, b) =>
        kept.set({ r: short(max(least, min(Number(state.rmax), r)), 4), b: short(max(0, min(Number(state.bmax), b)), 4) });
    byId('plane').addEventListener('click', (e) => {
        const box = byId('lines').getBoundingClientRect(),
            { left, right, top, bottom } = P.shapes;
        to(
            ((e.clientX - box.left - left) / (f.width - left - right)) * Number(state.rmax),
            ((f.height - bottom - (e.clientY - box.top)) / (f.height - top - bottom)) * Number(state.bmax),
        );
    });
    byId('plane').addEventListener('keydown', (e) => {
        const move = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[e.key],
            far = e.shiftKey ? 10 : 1;
        if (!move || e.altKey || e.ctrlKey || e.metaKey) return;
        e.preventDefault();
        to(scene.r + move[0] * 0.01 * far, scene.beta + move[1] * 0.01 * far);
    });
    kept = P.controls({
        defaults,
        presets,
        changed: (s) => changed(s),
        choices: [
            {
                key: 'q',
                label: 'colour and slices show',
                options: [
                    ['0', 'amplitude of the contact'],
                    ...[1, 2, 3, 4, 5].map((k) => [String(k), 'amplitude of mass ' + k]),
                    ['stops', 'stops per period'],
                ],
            },
        ],
        after: [
            { key: 'rmax', label: 'plane up to <i>r</i> =', from: 0.2, to: 6, step: 0.1, strict: true },
            { key: 'bmax', label: 'plane up to <i>β</i> =', from: 0.1, to: 3, step: 0.05, strict: true },
        ],
    });
    P.resized(() => {
        draw();
        if (slices) drawSlices();
    });
    return { set: kept.set, get: kept.get, counters, busy: () => P.busy('cells') };
};
