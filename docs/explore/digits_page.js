// Where the digits go: (28) and (29) near their poles.
'use strict';
const D = require('./digits.js');
const P = require('./page.js');
const { byId, short } = P;

const at = (n, d) => (1 / (2 * n + 1)) * (1 + d);
const parts = [
    ['u', '28', '<i>u</i>'],
    ['g', '29', '<i>g</i>'],
];
// The digits of both functions in both forms.
function left(R, zeta) {
    const exact = D.reference(R, zeta);
    if (!exact) return [NaN, NaN, NaN, NaN];
    return ['u', 'g'].flatMap((key) => [
        D.digitsOf(D.printed(R, zeta)[key], exact[key]),
        D.digitsOf(D.shipped(R, zeta)[key], exact[key]),
    ]);
}
const lines = [
    { name: '<i>u</i> as printed', style: 'wrong' },
    { name: '<i>u</i> as shipped', style: 'right' },
    { name: '<i>g</i> as printed', style: 'm4' },
    { name: '<i>g</i> as shipped', style: 'm1' },
];

// Sign, exponent and fraction of x; bits in which it differs from `exact` are marked.
function bits(x, exact) {
    const all = D.bitsOf(x),
        wanted = D.bitsOf(exact);
    const marked = [...all].map((bit, i) => (bit !== wanted[i] ? `<b>${bit}</b>` : bit));
    const part = (from, to) =>
        `<span class="part">${marked
            .slice(from, to)
            .join('')
            .replace(/<\/b><b>/g, '')}</span>`;
    return part(0, 1) + part(1, 12) + part(12, 64);
}

module.exports = function digits() {
    const defaults = { n: 0, d: 1e-6, z: 1e-7, side: '1' },
        counters = { renders: 0, references: 0 };
    let curves = { d: [], z: [] },
        drawn = '',
        here = null;
    const changed = (state) => {
        const n = Number(state.n),
            d = Number(state.side) * Number(state.d),
            zeta = Number(state.z),
            R = at(n, d),
            exact = D.reference(R, zeta);
        ++counters.references;
        here = { n, d: Math.abs(d), zeta };
        P.copies({
            mass_ratios: [1],
            stiffness_ratios: [1],
            damping_ratios: [zeta],
            contact: 1,
            load: 1,
            mu: 1,
            r: R,
            beta: 0.25,
        });
        const forms = { printed: D.printed(R, zeta), shipped: D.shipped(R, zeta) };
        const distance = d === 0 ? 'the double nearest to' : short(Math.abs(d), 3) + (d > 0 ? ' above' : ' below');
        byId('regime').innerHTML = `<strong><i>R</i> = ${R}</strong>, ${distance} 1/${2 * n + 1}; <i>ζ</i> = ${zeta}.`;
        const ofForms = (f) => [...['printed', 'shipped'].map((form) => (exact ? f(form) : '…')), ''];
        const digitsLeft = (form, key) => D.digitsOf(forms[form][key], exact[key]).toFixed(1);
        byId('numbers').innerHTML = P.figures(
            ['function', 'as printed', 'as shipped', 'reference'],
            parts.flatMap(([key, eq, name]) => [
                [
                    `${name}, ${P.equationLink(eq)}`,
                    ...['printed', 'shipped'].map((form) => [`${key}-${form}`, forms[form][key]]),
                    [key + '-reference', exact ? exact[key] : 'a pole'],
                ],
                ['digits left', ...ofForms((form) => digitsLeft(form, key))],
                [
                    'units in the last place off',
                    ...ofForms((form) => [`${key}-${form}-units`, said(D.unitsApart(forms[form][key], exact[key]))]),
                ],
            ]),
        );
        byId('bits').innerHTML = !exact
            ? '<p>The reference has no value at the pole.</p>'
            : parts
                  .flatMap(([key, , name]) => [
                      `<p>${name}, reference<br>${bits(exact[key], exact[key])}</p>`,
                      ...['shipped', 'printed'].map((form) => {
                          const differ = [...D.bitsOf(forms[form][key])].filter(
                              (bit, i) => bit !== D.bitsOf(exact[key])[i],
                          ).length;
                          return `<p>${name}, as ${form}: ${differ} of 64 bits differ<br>
${bits(forms[form][key], exact[key])}</p>`;
                      }),
                  ])
                  .join('');
        const heard = ([key, eq]) =>
            `(${eq}): ${digitsLeft('printed', key)} digits as printed, ${digitsLeft('shipped', key)} as shipped`;
        if (exact) P.announce(parts.map(heard).join('. ') + '.');
        const now = JSON.stringify([n, state.side, d, zeta]);
        if (now !== drawn) {
            drawn = now;
            const own = (curves = { d: [], z: [] });
            P.background(
                'curves',
                (function* () {
                    for (let p = -15; p <= -0.5; p += 0.125) {
                        own.d.push([p, ...left(at(n, Number(state.side) * 10 ** p), zeta)]);
                        ++counters.references;
                        yield;
                    }
                    if (own === curves) draw();
                    for (let p = -15; p <= -0.25; p += 0.125) {
                        own.z.push([p, ...left(R, 10 ** p)]);
                        ++counters.references;
                        yield;
                    }
                })(),
                draw,
            );
        }
        draw();
    };
    const said = (units) => (Number.isFinite(units) ? short(units, 4) : 'another sign or no number');
    const draw = () => {
        ++counters.renders;
        P.legend('legend', lines);
        for (const [id, points, label, mark] of [
            ['over-d', curves.d, 'distance of R from the pole, relative', here.d],
            ['over-z', curves.z, 'ζ', here.zeta],
        ]) {
            if (points.length < 2) continue;
            P.plot(id, {
                x: { span: [-15, 0], label, log: true, ticks: [-15, -12, -9, -6, -3, 0] },
                y: { span: [-0.5, 16.8], label: 'digits', ticks: [0, 4, 8, 12, 16] },
                height: 250,
                rules: [{ at: mark > 0 ? Math.log10(mark) : -15 }],
                lines: lines.map(({ style }, n) => ({ style: style + ' thin', points: points.map((p) => [p[0], p[n + 1]]) })),
                title: `Digits that the forms of (28) and (29) keep over ${label}`,
            });
            P.table(id + '-table', [label, 'u as printed', 'u as shipped', 'g as printed', 'g as shipped'], () =>
                points.filter((_, n) => n % 4 === 0).map(([p, ...y]) => ['1e' + p, ...y]),
            );
        }
    };
    const kept = P.controls({
        defaults,
        scene: false,
        changed,
        choices: [
            {
                key: 'side',
                label: 'side of the pole',
                options: [
                    ['1', 'above'],
                    ['-1', 'below'],
                ],
            },
        ],
        own: [
            { key: 'n', label: 'pole <i>n</i>, at 1/(2<i>n</i>+1)', from: 0, to: 20, step: 1, whole: true },
            { key: 'd', label: 'distance of <i>R</i> from the pole, relative', from: 1e-15, to: 0.3, log: true, strict: true },
            { key: 'z', label: 'damping ratio <i>ζ</i>', from: 1e-15, to: 0.9, log: true, strict: true },
        ],
    });
    P.resized(draw);
    return { set: kept.set, get: kept.get, counters, busy: P.busy };
};
