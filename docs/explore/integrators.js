// Errors of integrators: three approximations beside the exact motion, error over cost.
'use strict';
const { stateAt } = require('../../tests/conformance/adapters/javascript/contact_motion.js');
const A = require('./approximations.js');
const P = require('./page.js');
const { byId, short } = P;
const { PI, log10, max, min, abs } = Math;

const samples = 256,
    most = 400000;
const methods = {
    rk: {
        name: 'Runge-Kutta with events',
        style: 'm2',
        mark: 'c2',
        others: [1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8],
        says: (y) => 'tolerance ' + y,
        run: (scene, y, state) => A.rungeKutta(scene, { tolerance: y, periods: Number(state.periods), samples, most }),
    },
    tanh: {
        name: 'friction by tanh',
        style: 'm4',
        mark: 'c4',
        others: [0.3, 0.1, 0.03, 0.01, 3e-3],
        says: (y) => 'ε = ' + y,
        run: (scene, y, state) =>
            A.regularised(scene, { epsilon: y, tolerance: Number(state.tol), periods: Number(state.periods), samples, most }),
    },
    hb: {
        name: 'harmonic balance',
        style: 'm3',
        mark: 'c3',
        others: [1, 3, 5, 7, 9, 13, 17, 25],
        says: (y) => y + (y === 1 ? ' harmonic' : ' harmonics, odd ones'),
        run: (scene, y) => A.harmonicBalance(scene, { harmonics: y, samples }),
    },
};

const words = {
    continuous: 'The contact slides throughout.',
    stick_slip: 'The contact sticks and slips.',
    permanent_sticking: 'The contact never moves.',
};

module.exports = function integrators() {
    const defaults = { ...P.sceneDefaults, tol: 1e-4, eps: 0.03, n: 5, periods: 30 },
        counters = { renders: 0, evaluations: 0 };
    let search = null,
        found = {},
        others = [],
        exact = [],
        scene = null,
        state = null,
        drawn = '';
    const setting = (key) => ({ rk: Number(state.tol), tanh: Number(state.eps), hb: Number(state.n) })[key];
    const changed = (next) => {
        state = next;
        scene = P.sceneOf(state);
        P.copies(scene);
        const here = JSON.stringify([scene, state.periods]);
        if (here !== drawn) {
            drawn = here;
            search = new P.Search(scene);
            found = {};
            others = [];
            const more = search.work(16);
            exactMotion();
            if (more)
                P.background(
                    'search',
                    (function* (own) {
                        while (own === search && own.work(12)) yield;
                    })(search),
                    () => {
                        exactMotion();
                        rate();
                        draw();
                    },
                );
        }
        if (search.failed && !search.shown) return draw();
        P.background('yours', yours(), () => {
            draw();
            if (!others.length) P.background('others', elsewhere(), draw);
        });
        draw();
    };
    const exactMotion = () => {
        if (!search.shown) return;
        exact = Array.from({ length: samples }, (_, s) => stateAt(search.shown, (2 * PI * s) / samples).x[search.motion.j]);
    };
    const outcome = (key, y, result) => ({
        key,
        y,
        ...result,
        error: search.steady ? A.errorOf(result.samples, search.steady, search.motion.j) : NaN,
    });
    function* attempt(key, y) {
        // one run; a fault of it is an outcome too
        const run = methods[key].run(scene, y, state);
        try {
            for (;;) {
                const { done, value } = run.next();
                if (done) {
                    counters.evaluations += value.evaluations;
                    return outcome(key, y, value);
                }
                yield;
            }
        } catch (fault) {
            if (!(fault instanceof RangeError)) throw fault;
            return { key, y, fault: fault.message, error: NaN, evaluations: NaN };
        }
    }
    function* yours() {
        for (const key of ['hb', 'rk', 'tanh']) {
            if (found[key] && found[key].y === setting(key) && (key !== 'tanh' || found[key].tol === state.tol)) continue;
            delete found[key];
            found[key] = { ...(yield* attempt(key, setting(key))), tol: state.tol };
            draw();
        }
    }
    function* elsewhere() {
        const all = (others = []);
        for (const key of ['hb', 'rk', 'tanh'])
            for (const y of methods[key].others) {
                all.push(yield* attempt(key, y));
                if (all === others) draw();
            }
    }
    const rate = () => {
        for (const each of [...Object.values(found), ...others])
            if (each.samples && search.steady) each.error = A.errorOf(each.samples, search.steady, search.motion.j);
    };
    const draw = () => {
        ++counters.renders;
        if (!search.shown) {
            byId('regime').textContent = search.failed ? 'There is no steady motion to compare with: ' + search.failed + '.' : '';
            for (const id of ['legend', 'motion', 'errors', 'cost', 'numbers']) byId(id).innerHTML = '';
            return;
        }
        const { motion, steady, shown } = search,
            x = { span: [0, 2 * PI], label: 'τ, from the maximum of the force' },
            at = (s) => (2 * PI * s) / samples;
        const closed = (y) => [...y.map((v, s) => [at(s), v]), [2 * PI, y[0]]],
            keys = Object.keys(methods).filter((key) => found[key]?.samples);
        const bands = shown.stops.flatMap(({ from, to }) => [
            [from, to],
            [from - shown.period, to - shown.period],
        ]);
        byId('regime').innerHTML =
            `<strong>${words[shown.regime]}</strong> ` +
            (steady
                ? `Its exact amplitude is <span data-number="amplitude">${P.exactly(steady.masses[motion.j].amplitude)}</span>.`
                : search.failed
                  ? search.failed + '.'
                  : 'The search for the steady motion goes on.') +
            (shown.regime === 'permanent_sticking'
                ? ' It may rest anywhere within an interval, so that errors mean nothing here; lower <i>β</i>.'
                : '');
        const all = [
            { name: 'exact', style: 'exact' },
            ...Object.entries(methods).map(([key, m]) => ({ name: `${m.name}, ${m.says(setting(key))}`, style: m.style })),
        ];
        P.legend('legend', all);
        P.plot('motion', {
            x,
            y: { span: P.span(exact, 0.25, 1e-3), label: 'displacement' },
            bands,
            height: 260,
            title: 'Displacement of the contact, exact and by each method',
            lines: [
                { points: closed(exact), style: 'exact' },
                ...keys.map((key) => ({
                    points: closed(found[key].samples.map((y) => y[motion.j])),
                    style: methods[key].style + ' thin',
                })),
            ],
        });
        const size = max(1e-300, ...exact.map(abs)),
            off = (key) => found[key].samples.map((y, s) => max(-14, log10(abs(y[motion.j] - exact[s]) / size)));
        P.plot('errors', {
            x,
            y: { span: [-12, 1], label: 'error / amplitude', log: true, ticks: [-12, -9, -6, -3, 0] },
            bands,
            height: 230,
            title: 'Size of the error of each method over time',
            lines: keys.map((key) => ({ points: closed(off(key)), style: methods[key].style + ' thin' })),
        });
        const cloud = [...others.map((o) => ({ ...o, size: 4 })), ...keys.map((key) => ({ ...found[key], size: 8 }))].filter(
            (o) => o.error > 0 && o.evaluations > 0,
        );
        const cost = log10(max(1, motion.evaluations)),
            reach = [1, max(6, ...cloud.map((o) => log10(o.evaluations)))];
        P.plot('cost', {
            x: { span: reach, label: 'evaluations', log: true, ticks: [1, 2, 3, 4, 5, 6] },
            y: { span: [-15.5, 1], label: 'error / amplitude', log: true, ticks: [-15, -12, -9, -6, -3, 0] },
            height: 280,
            title: 'Error over cost of each method',
            lines: Object.entries(methods).map(([key, m]) => ({
                style: m.style + ' thin',
                points: others.filter((o) => o.key === key && o.error > 0).map((o) => [log10(o.evaluations), log10(o.error)]),
            })),
            marks: [
                ...cloud.map((o) => ({ at: [log10(o.evaluations), log10(o.error)], style: methods[o.key].mark, size: o.size })),
                ...(steady ? [{ at: [cost, log10(max(1e-15, steady.closes / max(size, 1e-300)))], size: 7 }] : []),
            ],
        });
        P.table('motion-table', ['τ', 'exact', ...keys.map((key) => methods[key].name)], () =>
            exact.flatMap((y, s) => (s % 8 ? [] : [[at(s), y, ...keys.map((key) => found[key].samples[s][motion.j])]])),
        );
        P.table('errors-table', ['τ', ...keys.map((key) => methods[key].name)], () =>
            exact.flatMap((y, s) =>
                s % 8 ? [] : [[at(s), ...keys.map((key) => abs(found[key].samples[s][motion.j] - y) / size)]],
            ),
        );
        P.table('cost-table', ['method', 'setting', 'evaluations', 'error'], () =>
            [...others, ...Object.values(found)].map((o) => [
                methods[o.key].name,
                methods[o.key].says(o.y),
                o.evaluations,
                o.fault ?? o.error,
            ]),
        );
        const figuresOf = ([key, m]) => {
            const o = found[key];
            if (!o || o.fault) return [m.name, o ? P.escaped(o.fault) : '…', '…', m.says(setting(key))];
            const error = (o.converged === false ? 'did not converge, ' : '') + short(o.error, 3);
            return [m.name, ['error-' + key, error], ['cost-' + key, o.evaluations], m.says(setting(key))];
        };
        const closes = steady ? short(steady.closes, 2) : '…';
        byId('numbers').innerHTML = P.figures(
            ['method', 'error', 'evaluations', 'setting'],
            [
                ['exact', 'closes to ' + closes, ['cost-exact', motion.evaluations], 'from event to event'],
                ...Object.entries(methods).map(figuresOf),
            ],
        );
        if (keys.length === 3)
            P.announce(keys.map((key) => `${methods[key].name}: error ${short(found[key].error, 2)}`).join('. ') + '.');
    };
    const kept = P.controls({
        defaults,
        changed,
        own: [
            { key: 'tol', label: 'tolerance of Runge-Kutta', from: 1e-10, to: 1e-1, log: true, strict: true },
            { key: 'eps', label: '<i>ε</i> of tanh(<i>v</i>/<i>ε</i>)', from: 1e-4, to: 1, log: true, strict: true },
            { key: 'n', label: 'harmonics <i>n</i>', from: 1, to: 31, step: 2, whole: true },
            { key: 'periods', label: 'periods that integrators wait', from: 5, to: 200, step: 5, whole: true },
        ],
    });
    P.resized(draw);
    return { set: kept.set, get: kept.get, counters, busy: () => P.busy('others') };
};
