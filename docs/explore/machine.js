// The machine: the steady motion of a scene, drawn and moving.
'use strict';
const { stateAt } = require('../../tests/conformance/adapters/javascript/contact_motion.js');
const P = require('./page.js');
const { byId, exactly, short } = P;
const { PI } = Math;

const presets = [
    ['Fig. 4a: five masses, contact and load on the first', '#N=5&z=0.01&r=0.9&b=0.2'],
    ['Fig. 4b: the same, more damping', '#N=5&z=0.1&r=0.9&b=0.2'],
    ['Fig. 5a: contact on the third', '#N=5&z=0.01&j=3&r=0.9&b=0.2'],
    ['Fig. 5b: the same, more damping', '#N=5&z=0.1&j=3&r=0.9&b=0.2'],
    ['Fig. 6, at resonance', '#z=0.1&r=1&b=0.2'],
    ['Fig. 8, near the stuck resonance', '#N=2&z=0.0161,0.00618&j=2&r=1.41&b=0.6'],
    ['Fig. 13, ζ = 0.001', '#z=0.001&r=0.1&b=0.2'],
    ['Fig. 13, ζ = 0.01', '#z=0.01&r=0.1&b=0.2'],
    ['Fig. 13, ζ = 0.1', '#z=0.1&r=0.1&b=0.2'],
];
const names = {
    continuous: 'The contact slides throughout',
    stick_slip: 'The contact sticks and slips',
    permanent_sticking: 'The contact never moves',
};
const samples = 480,
    counters = { frames: 0, renders: 0, evaluations: 0, changes: 0 };

function reasonOf(regime, c, limits) {
    const beta = short(c.beta, 6),
        at = short(limits.exact, 6),
        still = short(limits.sticking, 6);
    if (regime === 'continuous')
        return `β = ${beta} is below β_lim = ${at}, (69): the load on the contact never lets it rest, and the closed form holds.`;
    if (regime === 'permanent_sticking')
        return `β = ${beta} is not below ${still}, (88) with all forces: the load on the held contact never exceeds μβ.`;
    return `β = ${beta} is not below β_lim = ${at}, (69), but below ${still}, at which the contact stops moving altogether.`;
}
function sampled(motion, shown) {
    const all = [],
        { j } = motion;
    for (let s = 0; s <= samples; ++s) {
        const tau = (shown.period * s) / samples,
            at = stateAt(shown, tau);
        const friction = at.direction ? -at.direction * motion.beta : -motion.load(at.x, at.v, tau);
        all.push({ tau, ...at, friction, force: Math.cos(tau), x_j: at.x[j], v_j: at.direction ? at.v[j] : 0 });
    }
    return all;
}

module.exports = function machine() {
    let search = null,
        picture = null,
        standing = '', // the chain that is drawn
        geometry = null,
        parts = null,
        start = null,
        tau = 0;
    const still = matchMedia('(prefers-reduced-motion: reduce)');
    let playing = !still.matches,
        before = 0;
    const changed = (state) => {
        const scene = P.sceneOf(state),
            shape = JSON.stringify([scene.mass_ratios, scene.stiffness_ratios, scene.contact]);
        ++counters.changes;
        search = new P.Search(scene, start?.shape === shape ? start.z : null);
        const own = search;
        P.copies(scene);
        const more = search.work(16);
        show(scene);
        if (more)
            P.background(
                'search',
                (function* () {
                    while (own === search && own.work(12)) {
                        yield;
                    }
                })(),
                () => {
                    if (own === search) show(scene);
                },
            );
        function* nothing() {}
        if (!more) P.background('search', nothing());
        if (search.steady?.regime === 'stick_slip') start = { shape, z: search.steady.z };
    };
    // A scene without an answer: what was drawn before goes.
    const nothing = () => {
        byId('regime').textContent = 'There is no steady motion to show: ' + search.failed + '.';
        byId('regime').dataset.regime = 'none';
        for (const id of ['machine', 'motion', 'forces', 'law', 'portrait', 'legend', 'forces-legend', 'numbers']) byId(id).innerHTML = '';
        picture = null;
        standing = '';
        P.announce('No steady motion: ' + search.failed + '.');
    };
    const show = (scene) => {
        if (!search.shown) return nothing();
        const { motion, shown, steady, failed } = search,
            all = sampled(motion, shown),
            { j } = motion;
        counters.evaluations = motion.evaluations;
        ++counters.renders;
        if (steady && steady.regime === 'stick_slip')
            start = { shape: JSON.stringify([scene.mass_ratios, scene.stiffness_ratios, scene.contact]), z: steady.z };
        const limits = {
            exact: motion.beta_lim(motion.demand()),
            paper: motion.beta_lim(motion.S_dj()),
            approximate: motion.beta_lim(0),
            sticking: motion.held().limit,
        };
        const told = motion.regime(),
            besides = ` It is the motion from rest; the boundaries tell another, in which ${names[told].replace('The contact', 'the contact')}.`;
        const reason = reasonOf(told, motion, limits) + (steady && shown.regime !== told ? besides : '');
        const state = failed
            ? ' ' + failed + '; the pictures show where the search ended.'
            : steady
              ? ''
              : ' The search for the steady motion goes on; the pictures show where it is.';
        byId('regime').innerHTML =
            `<strong>${names[shown.regime]}.</strong> ${P.escaped(reason + state).replace(/β_lim/g, 'β<sub>lim</sub>')}`;
        byId('regime').dataset.regime = steady ? shown.regime : 'searching';
        picture = { scene, motion, shown, all, scale: Math.max(1e-9, ...all.flatMap((s) => s.x.map(Math.abs))) };
        const bands = shown.stops.flatMap(({ from, to }) => [
            [from, to],
            [from - shown.period, to - shown.period],
        ]);
        const x = { span: [0, shown.period], label: 'τ, from the maximum of the force' };
        const lines = scene.mass_ratios.map((_, k) => ({
            points: all.map((s) => [s.tau, s.x[k]]),
            name: `<i>x</i><sub>${k + 1}</sub>` + (k === j ? ', contact' : ''),
            style: 'm' + (k + 1),
        }));
        P.legend('legend', lines);
        picture.f = P.plot('motion', {
            x,
            y: { span: P.span(lines.flatMap((l) => l.points.map((p) => p[1]))), label: 'displacement' },
            bands,
            lines,
            rules: [{ at: 0, style: 'now' }],
            title: `Displacements of ${scene.mass_ratios.length} masses over a period`,
        });
        const top = Math.max(1, motion.holds) * 1.08;
        const forces = [
            { points: all.map((s) => [s.tau, s.force]), name: 'load', style: 'm1' },
            { points: all.map((s) => [s.tau, s.friction]), name: 'friction', style: 'm2' },
        ];
        P.legend('forces-legend', forces);
        picture.g = P.plot('forces', {
            x,
            y: { span: [-top, top], label: 'in units of P' },
            bands,
            height: 230,
            rules: [{ at: 0, style: 'now' }],
            lines: forces,
            title: 'The load, solid, and friction, dashed, over a period',
        });
        const fast = Math.max(1e-9, ...all.map((s) => Math.abs(s.v_j))) * 1.08,
            { beta, holds } = motion,
            high = Math.max(holds, 0.05) * 1.15;
        picture.law = P.plot('law', {
            x: { span: [-fast, fast], label: 'velocity of the contact' },
            y: { span: [-high, high], label: 'friction force / P' },
            height: 230,
            lines: [
                {
                    points: [
                        [-fast, beta],
                        [0, beta],
                        [0, holds],
                        [0, -holds],
                        [0, -beta],
                        [fast, -beta],
                    ],
                    style: 'm1',
                },
            ],
            marks: [{ at: [0, 0], id: 'law-now', size: 6 }],
            title: 'Friction over velocity by Coulomb’s law, (2) with (3), and where the contact is on it',
        });
        picture.portrait = P.plot('portrait', {
            x: {
                span: P.span(
                    all.map((s) => s.x_j),
                    0.1,
                    1e-6,
                ),
                label: 'displacement of the contact',
            },
            y: {
                span: P.span(
                    all.map((s) => s.v_j),
                    0.1,
                    1e-6,
                ),
                label: 'velocity',
            },
            height: 260,
            lines: [{ points: all.map((s) => [s.x_j, s.v_j]), style: 'm1' }],
            marks: [{ at: [0, 0], id: 'portrait-now', size: 6 }],
            title: 'Velocity over displacement of the contact',
        });
        const some = all.filter((_, n) => n % 15 === 0),
            masses = scene.mass_ratios.map((_, k) => k);
        P.table('motion-table', ['τ', ...masses.map((k) => `x<sub>${k + 1}</sub>`), 'contact'], () =>
            some.map((s) => [s.tau, ...s.x, s.direction ? 'slides' : 'rests']),
        );
        P.table('forces-table', ['τ', 'load', 'friction'], () => some.map((s) => [s.tau, s.force, s.friction]));
        P.table('law-table', ['velocity', 'friction'], () => some.map((s) => [s.v_j, s.friction]));
        P.table('portrait-table', ['displacement', 'velocity'], () => some.map((s) => [s.x_j, s.v_j]));
        numbers(scene, shown, steady, limits);
        const chain = JSON.stringify([scene.mass_ratios.length, scene.contact, scene.load, P.widthOf('machine')]);
        if (chain !== standing) draw(scene);
        standing = chain;
        Object.assign(picture, { geometry, parts });
        for (const [key, id] of [
            ['law', 'law-now'],
            ['portrait', 'portrait-now'],
        ])
            parts[key] = byId(id);
        parts.rules = document.querySelectorAll('#motion .now, #forces .now');
        byId('instant').max = shown.period;
        if (tau > shown.period) tau = 0;
        move();
        const stopsSaid = shown.regime === 'stick_slip' ? short(shown.stops.length / shown.periods) + ' stops a period.' : '';
        P.announce(`${names[shown.regime]}. Amplitude of the contact ${short(shown.masses[j].amplitude, 5)}. ${stopsSaid}`);
    };
    const numbers = (scene, shown, steady, limits) => {
        const cell = (name, y) => [name, steady || name.startsWith('beta') ? exactly(y) : '…'];
        const stops = shown.regime === 'permanent_sticking' ? 0 : shown.stops.length / shown.periods;
        const periods = shown.periods === 1 ? 'one period' : short(shown.periods) + ' periods';
        byId('numbers').innerHTML =
            P.figures(
                ['mass', 'amplitude', 'phase'],
                shown.masses.map((m, k) => [
                    k + 1 + (k + 1 === scene.contact ? ', contact' : ''),
                    cell('amplitude-' + (k + 1), m.amplitude),
                    cell('phase-' + (k + 1), m.amplitude > 0 ? m.lag : NaN),
                ]),
            ) +
            P.figures(null, [
                ['stops per period', ['stops', steady ? short(stops) : '…']],
                ['<i>β</i><sub>lim</sub> exact', cell('beta_lim_exact', limits.exact)],
                [`<i>β</i><sub>lim</sub> with ${P.equationLink('56')}`, cell('beta_lim_paper', limits.paper)],
                [`<i>β</i><sub>lim</sub> approximate, ${P.equationLink('67')}`, cell('beta_lim_approximate', limits.approximate)],
                ['never moves from <i>β</i> =', cell('beta_sticking', limits.sticking)],
            ]);
        if (shown.regime === 'stick_slip')
            byId('numbers').innerHTML += P.figures(
                ['rest', 'from <i>τ</i>', 'to', 'at'],
                shown.stops.map((s, n) => [n + 1, ...['from', 'to', 'at'].map((key) => cell(`stop-${key}-${n + 1}`, s[key]))]),
            );
        if (steady)
            byId('numbers').innerHTML +=
                `<p class="note">Followed over ${periods} from event to event, the state returns to within
${short(shown.closes, 2)} of itself; the search evaluated ${search.motion.evaluations} Taylor coefficients.</p>`;
    };
    // The drawing: what stands still once a scene, what moves in groups of its own.
    const draw = (scene) => {
        const N = scene.mass_ratios.length,
            width = P.widthOf('machine'),
            height = 190,
            gap = Math.min(260, (width - 36) / N),
            left = Math.max(26, (width - gap * N) / 2),
            body = Math.min(64, gap * 0.4);
        geometry = { left, gap, body, height, travel: Math.min(gap - body, 100) * 0.3, base: 108 };
        const place = (k) => left + gap * (k + 0.58),
            { base, travel } = geometry,
            j = scene.contact - 1,
            wall = [place(j) - body / 2 - travel - 4, place(j) + body / 2 + travel + 4];
        const line = (style, x1, y1, x2, y2) => P.tag('line', { class: style, x1, y1, x2, y2 }),
            box = (style, w, y, h) => P.tag('rect', { class: 'solid ' + style, x: -w / 2, y, width: w, height: h, rx: 3 }),
            path = (style, id) => P.tag('path', { class: style, id });
        let out = line('ground', left, 40, left, 130) + line('ground', wall[0], base + 34, wall[1], base + 34);
        for (let n = 0; n < 11; ++n) out += line('hatch', left - 9, 50 + 8 * n, left, 42 + 8 * n);
        for (let x = wall[0]; x + 7 < wall[1]; x += 7) out += line('hatch', x, base + 44, x + 7, base + 36);
        for (let k = 0; k < N; ++k) {
            const name = 'm' + P.tag('tspan', { dy: 3, class: 'power' }, k + 1),
                text = P.tag('text', { class: 'said', x: 0, y: base - 10, 'text-anchor': 'middle' }, name),
                rubs = k === j ? box('', body / 2, base + 26, 8) : '';
            out += path('wire', 'spring-' + k) + path('wire', 'dashpot-' + k);
            out += P.tag(
                'g',
                { id: 'body-' + k },
                box(k === j ? 'contact-body' : '', body, base - 44, k === j ? 70 : 60) + text + rubs,
            );
        }
        out += path('arrow', 'load-arrow') + path('arrow friction', 'friction-arrow');
        geometry.place = place;
        P.into(
            'machine',
            width,
            height,
            `${N} masses in a chain; contact on mass ${scene.contact}, load on mass ${scene.load}`,
            out,
        );
        parts = {
            bodies: scene.mass_ratios.map((_, k) => byId('body-' + k)),
            springs: scene.mass_ratios.map((_, k) => byId('spring-' + k)),
            dashpots: scene.mass_ratios.map((_, k) => byId('dashpot-' + k)),
            load: byId('load-arrow'),
            friction: byId('friction-arrow'),
        };
    };
    const spring = (a, b, y) => {
        // eight turns between a and b
        let d = `M${a.toFixed(1)} ${y}`;
        const end = Math.min(8, (b - a) / 6),
            step = (b - a - 2 * end) / 16;
        for (let n = 0; n <= 16; ++n)
            d += `L${(a + end + n * step).toFixed(1)} ${n === 0 || n === 16 ? y : y + (n % 2 ? -6 : 6)}`;
        return d + `L${b.toFixed(1)} ${y}`;
    };
    const dashpot = (a, b, y) => {
        const m = (a + b) / 2,
            at = (x) => (m + x).toFixed(1);
        const pot = `M${at(7)} ${y - 7}H${at(-6)}V${y + 7}H${at(7)}`,
            piston = `M${at(2)} ${y - 5}V${y + 5}M${at(2)} ${y}`;
        return `M${a.toFixed(1)} ${y}H${at(-6)}${pot}${piston}H${b.toFixed(1)}`;
    };
    const arrow = (x, y, length) => {
        const s = Math.sign(length),
            shaft = s * Math.max(0, Math.abs(length) - 7);
        return Math.abs(length) < 1 ? '' : `M${x.toFixed(1)} ${y}h${shaft.toFixed(1)}v-4l${7 * s} 4l${-7 * s} 4v-4`;
    };
    // Brings everything that moves to the instant tau.
    const move = () => {
        const {
                scene,
                motion,
                shown,
                all,
                scale,
                geometry: { left, body, travel, base, place },
                parts,
            } = picture,
            u = (tau / shown.period) * samples;
        const n = Math.min(samples - 1, Math.floor(u)),
            t = u - n,
            s = all[n],
            next = all[n + 1],
            mix = (a, b) => a + t * (b - a);
        let edge = left;
        for (let k = 0; k < scene.mass_ratios.length; ++k) {
            const at = place(k) + (travel * mix(s.x[k], next.x[k])) / scale;
            parts.bodies[k].setAttribute('transform', `translate(${at.toFixed(2)} 0)`);
            parts.springs[k].setAttribute('d', spring(edge, at - body / 2, base - 32));
            parts.dashpots[k].setAttribute('d', dashpot(edge, at - body / 2, base - 2));
            if (k === motion.l) parts.load.setAttribute('d', arrow(at, base - 58, 46 * Math.cos(tau)));
            if (k === motion.j)
                parts.friction.setAttribute(
                    'd',
                    arrow(at, base + 62, 46 * (s.direction ? s.friction : mix(s.friction, next.friction))),
                );
            edge = at + body / 2;
        }
        byId('machine').classList.toggle('holds', s.direction === 0);
        parts.law.setAttribute('cx', picture.law.X(s.direction ? mix(s.v_j, next.v_j) : 0));
        parts.law.setAttribute('cy', picture.law.Y(s.friction));
        parts.portrait.setAttribute('cx', picture.portrait.X(mix(s.x_j, next.x_j)));
        parts.portrait.setAttribute('cy', picture.portrait.Y(s.direction ? mix(s.v_j, next.v_j) : 0));
        for (const rule of parts.rules) {
            const f = rule.closest('svg').id === 'motion' ? picture.f : picture.g;
            rule.setAttribute('x1', f.X(tau));
            rule.setAttribute('x2', f.X(tau));
        }
        byId('instant').value = tau;
        byId('instant-says').textContent = tau.toFixed(2);
    };
    const frame = (now) => {
        if (playing && picture) {
            tau = (tau + (Math.min(0.1, (now - before) / 1000) * 2 * PI) / 4) % picture.shown.period;
            ++counters.frames;
            move();
        }
        before = now;
        requestAnimationFrame(frame);
    };
    const says = () => {
        byId('play').textContent = playing ? 'Pause' : 'Play';
    };
    byId('play').onclick = () => {
        playing = !playing;
        says();
    };
    still.addEventListener('change', () => {
        playing = !still.matches;
        says();
    });
    byId('instant').addEventListener('input', (e) => {
        playing = false;
        says();
        tau = Number(e.target.value);
        move();
    });
    const kept = P.controls({ defaults: P.sceneDefaults, presets, changed });
    P.resized(() => {
        if (picture) show(picture.scene);
    });
    says();
    requestAnimationFrame(frame);
    return {
        set: kept.set,
        get: kept.get,
        counters,
        busy: () => P.busy() || !(search.steady || search.failed),
        pause: () => {
            playing = false;
            says();
        },
    };
};
