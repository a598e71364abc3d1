// Answers the questions of `denhartog conform` in the json dialect: by closed_form.js, motions with stops by contact_motion.js.
'use strict';
const { ContactMotion, wrapped } = require('./contact_motion.js');
const quantities = { // c: the closed form of the scene; k: the mass, from 0; q: the question
    natural_frequency_ratios: (c) => c.modes.map((m) => m.r_n),
    modal_frequency_ratios: (c) => c.modes.map((m) => m.R),
    mode_shape_products: (c, k) => c.modes.map((m) => m.phi[k] * m.phi[c.j] / c.r ** 2),
    complex_response: (c, k) => c.V[k],
    first_damping_function: (c, k) => c.U[k],
    second_damping_function: (c, k) => c.G[k],
    H_j: (c) => c.H_j,
    S_j: (c) => c.demand(),
    amplitude: (c, k) => c.amplitudeAndPhase(k)[0],
    phase: (c, k) => (c.amplitudeAndPhase(k)[0] > 0 ? wrapped(c.amplitudeAndPhase(k)[1]) : NaN),
    amplitude_monoharmonic: (c, k) => Math.hypot(...c.slide().start[k]),
    phase_monoharmonic: (c, k) => wrapped(c.slide().phi_j + Math.atan2(c.slide().start[k][1], c.slide().start[k][0])),
    initial_displacement: (c, k) => c.slide().start[k][0],
    initial_velocity: (c, k) => c.slide().start[k][1],
    displacement: (c, k, q) => c.motion(k, c.slide().W, q.tau)[0],
    beta_lim_exact: (c) => c.beta_lim(c.demand()),
    beta_lim_paper: (c) => c.beta_lim(c.S_dj()),
    beta_lim_approximate: (c) => c.beta_lim(0),
    beta_lim_sticking: (c) => c.held().limit,
    beta_lim_high_frequency: (c) => 2 / Math.hypot(2 * c.mu, Math.PI), // (86) as corrected, j = l
    regime: (c) => c.regime(),
    rest_interval: (c) => (c.regime() === 'permanent_sticking' ? c.held().rest : NaN),
    stops_per_period: (c) => c.stopsPerPeriod(),
    stop_durations: (c) => c.stops().map(({ from, to }) => to - from).sort((a, b) => a - b),
    motion_under_force: (c, k, q) => c.motionUnderForce(k, [...Array(q.samples).keys()].map((n) => 2 * Math.PI * n / q.samples)),
};
const isOfPaper = (s) => [s.contact, s.load].every(Number.isInteger) && !Object.keys(s).some((key) => key.endsWith('matrix'));
function brokenRule({ scene: s, mass = 1, tau = 0, samples = 1 }) {
    const springs = s.stiffness_ratios, ratios = [...s.mass_ratios, ...springs], N = s.mass_ratios.length;
    const finite = [...ratios, ...s.damping_ratios, s.mu, s.r, s.beta].every(Number.isFinite);
    if (N === 0 || springs.length !== N || s.damping_ratios.length !== N || !finite) return 'finite numbers, N of each ratio';
    if (Math.min(...ratios) <= 0 || Math.min(...s.damping_ratios) < 0) return 'positive ratios, damping ratios not negative';
    if (ratios[0] !== 1 || springs[0] !== 1) return 'the first ratio of masses and of stiffnesses 1';
    if (![s.contact, s.load, mass].every((k) => Number.isInteger(k) && k >= 1 && k <= N)) return 'masses from 1 to N';
    if (s.mu < 1 || s.r <= 0 || s.beta < 0) return 'mu at least 1, r positive, beta not negative';
    return tau >= 0 && tau < 2 * Math.PI && samples >= 1 ? null : '0 <= tau < 2 pi, one sample or more';
}

function reply(q) {
    if (!isOfPaper(q.scene)) return { skip: 'not a scene of the paper' };
    const broken = brokenRule(q);
    if (broken) return { reject: broken };
    if (!(q.quantity in quantities)) return { skip: 'not among what this program computes' };
    try {
        const value = quantities[q.quantity](new ContactMotion(q.scene), (q.mass || 1) - 1, q);
        return typeof value === 'string' || [value].flat().every(Number.isFinite) ? { value } : { skip: 'at a pole' };
    } catch (reason) {
        return { skip: reason.message };
    }
}

require('readline').createInterface({ input: process.stdin }).on('line', (line) => {
    if (line.startsWith('denhartog-conform')) return console.log('denhartog-conform 1 json exact motion in JavaScript');
    const question = JSON.parse(line);
    console.log(JSON.stringify({ id: question.id, ...reply(question) }));
});
