// Printed against corrected: one equation at a time.
'use strict';
const F = require('./printed.js');
const P = require('./page.js');
const { byId, short } = P;

// Verdict of the last run of the derivation on an equation; empty where no run has been.
const ledgerOf = (eq) =>
    (typeof denhartog_ledger === 'undefined' ? [] : denhartog_ledger).find((row) => row.equation === eq) ?? {};
const entryOf = (eq) => F.equations.find((e) => e.eq.includes(eq)) ?? F.equations[0];

module.exports = function printed() {
    const defaults = { ...P.sceneDefaults, eq: '46', N: 2, z: '0.1', j: 2, l: 1, r: 0.9, b: 0.2, m: 1, i: 1, x: '' };
    const counters = { renders: 0, values: 0 };
    let kept = null,
        points = [],
        position = 0,
        drawn = '';
    const changed = (state) => {
        const entry = entryOf(state.eq),
            scene = P.sceneOf(state),
            { from, to, key } = entry.over,
            axis = { r: scene.r, b: scene.beta, mu: scene.mu }[key];
        const k = Math.min(Number(state.m), scene.mass_ratios.length) - 1,
            i = Math.min(Number(state.i), scene.mass_ratios.length) - 1;
        P.copies(scene);
        for (const [id, shown] of [
            ['m', entry.of === 'mass' || entry.of === 'both'],
            ['i', entry.of === 'mode' || entry.of === 'both'],
            ['x', !key],
        ]) {
            const box = byId('range-' + id).closest('.control');
            box.hidden = !shown;
        }
        for (const id of ['range-x', 'number-x']) {
            byId(id).min = from;
            byId(id).max = to;
        }
        byId('range-x').step = (to - from) / 200;
        if (!key && !(state.x !== '' && Number(state.x) >= from && Number(state.x) <= to))
            state.x = entry.over.at ?? short((from + to) / 3, 4);
        position = key ? axis : Number(state.x);
        byId('range-x').value = byId('number-x').value = position;
        byId('label-x').innerHTML = P.lowered(entry.over.name);
        const c = F.exactly(F.at(entry, scene, position)),
            y = ['printed', 'corrected'].map((form) => F.value(entry, entry[form], c, position, k, i));
        counters.values += 2;
        const loss = Math.abs(y[0] - y[1]) / Math.abs(y[1]),
            rows = entry.eq.map(ledgerOf),
            row = rows[0];
        byId('regime').innerHTML =
            `<strong>${entry.eq.map(P.equationLink).join(', ')}: ${entry.what}.</strong> ` +
            (entry.slides && P.regimeOf(c) !== 'continuous'
                ? 'Here the contact does not slide throughout, and the form does not apply; lower <i>β</i>.'
                : '');
        const verdictOf = (r, n) => {
            if (!r.printed)
                return `${P.equationLink(entry.eq[n])}: no run of the derivation is at hand, so its verdict is not known here`;
            const loss = Number.isFinite(r.loss) ? `, loss over the run’s scenes ${short(r.loss, 3)}` : '';
            const verdict = P.escaped(r.printed);
            return `${P.equationLink(entry.eq[n])} as printed: <span class="verdict ${verdict}">${verdict}</span>${loss}`;
        };
        byId('verdict').innerHTML = rows.map(verdictOf).join('; ') + '.';
        byId('how').textContent = entry.how;
        byId('latex').textContent =
            rows
                .map((r) =>
                    r.statement
                        ? `(${r.equation}) printed:   ${r.statement}\n(${r.equation}) corrected: ${r.correction || r.statement}`
                        : '',
                )
                .join('\n') || 'The forms are in the ledger of a run.';
        byId('numbers').innerHTML = P.figures(
            [`at ${P.lowered(entry.over.name)} = ${short(position)}`, 'as printed', 'as corrected', 'loss, relative'],
            [[P.lowered(entry.y), ['printed', P.exactly(y[0])], ['corrected', P.exactly(y[1])], ['loss', short(loss, 6)]]],
        );
        P.announce(`Equation ${entry.eq.join(' and ')}: ${short(y[0], 5)} as printed, ${short(y[1], 5)} as corrected.`);
        const now = JSON.stringify([
            entry.eq,
            scene.mass_ratios,
            scene.stiffness_ratios,
            scene.damping_ratios,
            scene.contact,
            scene.load,
            key === 'mu' ? 0 : scene.mu,
            key === 'r' ? 0 : scene.r,
            key === 'b' ? 0 : scene.beta,
            k,
            i,
        ]);
        if (now !== drawn) {
            drawn = now;
            const own = (points = []);
            P.background('curve', curve(entry, scene, k, i, own), () => {
                if (own === points) draw(entry);
            });
        }
        draw(entry);
    };
    function* curve(entry, scene, k, i, own) {
        const { from, to } = entry.over,
            n = entry.heavy ? 200 : 240,
            ends = entry.ends ? 1e-3 : 0;
        let c = entry.over.key ? null : F.exactly(scene);
        for (let s = 0; s <= n; ++s) {
            const x = from + (to - from) * (ends + ((1 - 2 * ends) * s) / n);
            if (entry.over.key) c = F.exactly(F.at(entry, scene, x));
            own.push([
                x,
                ...['printed', 'corrected'].map((form) => F.value(entry, entry[form], c, x, k, i)),
                entry.first ? F.value(entry, entry.first, c, x, k, i) : NaN,
            ]);
            counters.values += 2;
            yield;
        }
    }
    const draw = (entry) => {
        if (points.length < 2) return;
        ++counters.renders;
        const { from, to, label, name } = entry.over,
            lines = [
                { name: 'as corrected', style: 'right', n: 2 },
                { name: 'as printed', style: 'wrong', n: 1 },
                ...(entry.first ? [{ name: '(57) as corrected', style: 'third', n: 3 }] : []),
            ];
        P.legend('legend', lines);
        byId('curve-caption').textContent = entry.what[0].toUpperCase() + entry.what.slice(1);
        // The corrected curve sets the scale; the printed one may leave it, by its own size at most.
        const right = P.span(points.map((p) => p[2])),
            all = P.span(points.map((p) => p[1])),
            size = right[1] - right[0];
        const span = [
            Math.max(Math.min(right[0], all[0]), right[0] - size),
            Math.min(Math.max(right[1], all[1]), right[1] + size),
        ];
        P.plot('curve', {
            x: { span: [from, to], label: label ?? name },
            y: { span: points.some((p) => Number.isFinite(p[2])) ? span : all, label: entry.y },
            rules: [{ at: position }],
            lines: lines.map(({ style, n }) => ({ style, points: points.map((p) => [p[0], p[n]]) })),
            title: `${entry.what}: as printed, dashed, and as corrected, solid`,
        });
        P.table('curve-table', [name, 'as printed', 'as corrected'], () =>
            points.filter((_, n) => n % 6 === 0).map((p) => [p[0], p[1], p[2]]),
        );
    };
    kept = P.controls({
        defaults,
        changed,
        choices: [
            { key: 'eq', label: 'equation', options: F.equations.map((e) => [e.eq[0], `(${e.eq.join('), (')}) ${e.what}`]) },
        ],
        own: [
            { key: 'x', label: '<span id="label-x">τ</span>', from: 0, to: 6.3, step: 0.01, free: true },
            { key: 'm', label: 'mass <i>k</i>', from: 1, to: 5, step: 1, whole: true, most: 'N' },
            { key: 'i', label: 'mode <i>i</i>', from: 1, to: 5, step: 1, whole: true, most: 'N' },
        ],
    });
    // Another equation opens with the scene in which it shows.
    byId('choice-eq').addEventListener('change', (e) => {
        const entry = entryOf(e.target.value);
        kept.set({ ...P.stateOf({ ...P.sceneDefaults, m: 1, i: 1, x: '' }, '#' + entry.open), eq: e.target.value });
    });
    P.resized(() => draw(entryOf(kept.get().eq)));
    return { set: kept.set, get: kept.get, counters, busy: P.busy };
};
