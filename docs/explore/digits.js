// The damping functions (28), (29) of one mode: as printed in double, in the form that is shipped, and to hundreds of bits.
'use strict';
const ClosedForm = require('../../tests/conformance/adapters/javascript/closed_form.js');

// Numbers of F bits behind the point, as BigInt.
function arithmetic(F) {
    const bits = BigInt(F),
        one = 1n << bits,
        half = one >> 1n;
    const times = (a, b) => (a * b + half) >> bits,
        over = (a, b) => (a << bits) / b;
    const root = (a) => {
        // of a >= 0
        const n = a << bits;
        let x = 1n << BigInt(Math.ceil(n.toString(2).length / 2));
        for (;;) {
            const next = (x + n / x) >> 1n;
            if (next >= x) return x;
            x = next;
        }
    };
    const arctangentOfInverse = (n) => {
        let term = one / n,
            sum = term;
        for (let k = 3n, sign = -1n; term !== 0n; k += 2n, sign = -sign) {
            term /= n * n;
            sum += (sign * term) / k;
        }
        return sum;
    };
    const pi = 4n * (4n * arctangentOfInverse(5n) - arctangentOfInverse(239n));
    const exponential = (x) => {
        // halved until it is small, the series squared as often
        const turns = 24n;
        let y = x >> turns,
            term = one,
            sum = one;
        for (let n = 1n; term !== 0n && n < 400n; ++n) {
            term = times(term, y) / n;
            sum += term;
        }
        for (let n = 0n; n < turns; ++n) sum = times(sum, sum);
        return sum;
    };
    const sineAndCosine = (x) => {
        const y = x - 2n * pi * ((x + pi) / (2n * pi)),
            square = times(y, y);
        let s = y,
            c = one,
            sine = y,
            cosine = one;
        for (let n = 1n; (s !== 0n || c !== 0n) && n < 400n; ++n) {
            c = -times(c, square) / ((2n * n - 1n) * 2n * n);
            s = -times(s, square) / (2n * n * (2n * n + 1n));
            cosine += c;
            sine += s;
        }
        return [sine, cosine];
    };
    const ofDouble = (x) => {
        // exactly, as long as F holds it
        let exponent = 0;
        while (!Number.isInteger(x)) {
            x *= 2;
            ++exponent;
        }
        return (BigInt(x) << bits) >> BigInt(exponent);
    };
    return { F, one, times, over, root, pi, exponential, sineAndCosine, ofDouble };
}
// The double nearest to v / 2^F, ties to even.
function toDouble(v, F) {
    if (v === 0n) return 0;
    const size = v < 0n ? -v : v,
        shift = size.toString(2).length - 53;
    let kept = size,
        exponent = -F;
    if (shift > 0) {
        const cut = BigInt(shift),
            rest = size & ((1n << cut) - 1n),
            middle = 1n << (cut - 1n);
        kept = size >> cut;
        if (rest > middle || (rest === middle && kept & 1n)) ++kept;
        exponent += shift;
    }
    let x = Number(kept);
    for (; exponent < -500; exponent += 500) x *= 2 ** -500;
    for (; exponent > 500; exponent -= 500) x *= 2 ** 500;
    x *= 2 ** exponent;
    return v < 0n ? -x : x;
}
// (28) and (29) to F bits; with sinh and cosh by exponentials. Small zeta and R need the extra bits.
function reference(R, zeta, F = 420) {
    const a = arithmetic(F),
        { one, times, over, ofDouble } = a,
        z = ofDouble(zeta),
        r = ofDouble(R);
    const w = a.root(one - times(z, z)),
        theta = over(times(a.pi, w), r),
        delta = over(times(a.pi, z), r);
    const E = a.exponential(delta),
        inverse = over(one, E),
        [sine, cosine] = a.sineAndCosine(theta);
    const below = ((E + inverse) >> 1n) + cosine;
    if (below <= 0n) return null; // a pole
    return {
        u: toDouble(over(sine, times(times(r, w), below)), F),
        g: toDouble(over(((E - inverse) >> 1n) - over(times(z, sine), w), below), F),
    };
}
// As they stand in the paper, in double.
function printed(R, zeta) {
    const w = Math.sqrt(1 - zeta ** 2),
        theta = (Math.PI * w) / R,
        delta = (zeta * Math.PI) / R,
        below = Math.cosh(delta) + Math.cos(theta);
    return { u: Math.sin(theta) / (R * w * below), g: (Math.sinh(delta) - (zeta / w) * Math.sin(theta)) / below };
}
// In the form that is shipped: near an odd 1 / R by the distance from it, the denominator as a sum of squares.
function shipped(R, zeta) {
    const { u, g } = ClosedForm.modeFunctions(R, zeta);
    return { u, g };
}
function bitsOf(x) {
    const view = new DataView(new ArrayBuffer(8));
    view.setFloat64(0, x);
    return view.getBigUint64(0).toString(2).padStart(64, '0');
}
// Doubles between two doubles of one sign, as a number; infinite where the signs differ.
function unitsApart(x, y) {
    if (!Number.isFinite(x) || !Number.isFinite(y) || x < 0 !== y < 0) return x === y ? 0 : Infinity;
    const difference = BigInt('0b' + bitsOf(Math.abs(x))) - BigInt('0b' + bitsOf(Math.abs(y)));
    return Number(difference < 0n ? -difference : difference);
}
// Significant decimal digits of x against the reference, at most 16.
function digitsOf(x, exact) {
    if (x === exact) return 16;
    if (!Number.isFinite(x) || exact === 0) return 0;
    return Math.max(0, Math.min(16, -Math.log10(Math.abs((x - exact) / exact))));
}
module.exports = { arithmetic, toDouble, reference, printed, shipped, bitsOf, unitsApart, digitsOf };
