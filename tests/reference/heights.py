#!/usr/bin/env python3
"""Reference values for heights of Johnson's system and of a table: generate.py's summation with other densities.

    python3 heights.py > heights.json          (needs numpy, mpmath; deterministic)
    python3 heights.py --out heights.json      the same, rewriting the file after every parameter set

Nothing here follows the library.  Johnson's curves are in their classical form, u = gamma + delta f((z - xi)/lambda) with
f(y) = arsinh y, ln y, ln(y/(1 - y)), and gamma, delta solve for skew and kurtosis at 40 digits: S_U by its closed moments
(Johnson 1949), S_B by the trapezoidal rule.  The density of a table is the derivative of a cubic Hermite interpolant of its
cumulative distribution, with exact moments of polynomials at 40 digits.

Parameters beyond those of generate.py: skew and kurtosis, or table_height and table_density; each None where not meant.
"""
import json, math, random, sys
import numpy as np
import mpmath as mp
import generate
from generate import LD, EPS, ld

# ---------------------------------------------------------------- Johnson's system
def su_moments(gamma, delta):
    """mean, variance, skew, kurtosis of sinh((u - gamma)/delta)"""
    w = mp.exp(1/delta**2); O = gamma/delta
    mean = -mp.sqrt(w)*mp.sinh(O)
    var = (w - 1)*(w*mp.cosh(2*O) + 1)/2
    m3 = -mp.sqrt(w)*(w - 1)**2*(w*(w + 2)*mp.sinh(3*O) + 3*mp.sinh(O))/4
    m4 = (w - 1)**2*(w**2*(w**4 + 2*w**3 + 3*w**2 - 3)*mp.cosh(4*O) + 4*w**2*(w + 2)*mp.cosh(2*O) + 3*(2*w + 1))/8
    return mean, var, m3/var**1.5, m4/var**2
def sb_moments(gamma, delta):
    """the same of 1/(1 + exp(-(u - gamma)/delta))"""
    h = min(mp.mpf(1)/4, delta/6)*20/mp.mp.dps; n = int(mp.mp.dps/h/4); s = [mp.mpf(0)]*5
    ys = [(mp.exp(-(k*h)**2/2), 1/(1 + mp.exp(-(k*h - gamma)/delta))) for k in range(-n, n + 1)]
    tot = sum(w for w, y in ys); mean = sum(w*y for w, y in ys)/tot
    c = [sum(w*(y - mean)**k for w, y in ys)/tot for k in (2, 3, 4)]
    return mean, c[0], c[1]/c[0]**1.5, c[2]/c[0]**2
def lognormal_kurtosis(S):
    S = mp.mpf(S)
    if S == 0: return mp.mpf(3), mp.mpf(1)
    lo, hi = mp.mpf(1), 2 + abs(S)
    for _ in range(200):
        w = (lo + hi)/2
        if (w + 2)**2*(w - 1) < S*S: lo = w
        else: hi = w
    return w**4 + 2*w**3 + 3*w**2 - 3, w
def fit(S, K):
    """type, gamma, delta, xi, lambda of a standardised curve of skew S >= 0"""
    S, K = mp.mpf(S), mp.mpf(K); KL, w = lognormal_kurtosis(S)
    moments = su_moments if K > KL else sb_moments
    if abs(K/KL - 1) < mp.mpf(10)**-14:
        d = 1/mp.sqrt(mp.log(w)); scale = 1/mp.sqrt((w - 1)*w)      # z = xi + scale exp(u/delta)
        return "SL", mp.mpf(0), d, -scale*mp.sqrt(w), scale
    def f(g, ln_d):
        m = moments(g, mp.exp(ln_d)); return m[2] - S, (m[3] - K)/K
    if K - S*S - 1 < (S*S + 1)/8:                                   # nearly two heights: a start from these
        p = (1 - S/mp.sqrt(4 + S*S))/2; c = mp.sqrt(2)*mp.erfinv(1 - 2*p); v = p*(1 - p)
        start = (c, mp.log(6*(K - S*S - 1)*v*v*mp.sqrt(2*mp.pi)*mp.exp(c*c/2)))
        x = mp.findroot(f, start, tol=1e-20, maxsteps=60)
    else:
        with mp.workdps(16):                                        # a start from a grid
            grid = [(mp.mpf(float(g)), mp.log(mp.mpf(float(d)))) for d in np.geomspace(.3, 120, 48)
                    for g in np.concatenate([np.linspace(0, 8, 25), np.geomspace(10, 60, 8)])*(-1 if K > KL else 1)]
            x = mp.findroot(f, min(grid, key=lambda at: sum(e*e for e in f(*at))), tol=1e-20, maxsteps=60)
    with mp.workdps(80):                                            # near the Gaussian the moments cancel
        x = mp.findroot(f, tuple(x), tol=mp.mpf(10)**-80, maxsteps=60)
        g, d = x[0], mp.exp(x[1]); mean, var, s, k = moments(g, d)
        assert abs(s - S) < mp.mpf(10)**-38 and abs(k - K) < mp.mpf(10)**-38*K
        lam = 1/mp.sqrt(var); return ("SU" if K > KL else "SB"), g, d, -mean*lam, lam

class Johnson(generate.Model):
    def set_heights(self, p):
        self.om = None; self.endless = False
        S, K = p["skew"], p["kurtosis"]; self.mirror = S < 0
        self.kind, g, d, xi, lam = fit(abs(S), K)
        self.ga_j, self.de_j, self.xi, self.lam = ld(g), ld(d), ld(xi), ld(lam)
        lnd = ld(mp.log(d/mp.sqrt(2*mp.pi)))
        self.lnd = lnd
        def z_of(u):
            w = (u - g)/d
            y = mp.sinh(w) if self.kind == "SU" else mp.exp(w) if self.kind == "SL" else 1/(1 + mp.exp(-w))
            return xi + lam*y
        zs = [z_of(mp.mpf(u)/16) for u in range(-160, 161)]
        dens = self.lnphi_m(np.array([ld(z) for z in zs]))
        peaks = [i for i in range(1, 320) if dens[i] >= dens[i-1] and dens[i] > dens[i+1]]
        lo, hi = ld(z_of(-18)), ld(z_of(18))
        foot = None if self.kind == "SU" else xi
        head = xi + lam if self.kind == "SB" else None
        modes = [ld(zs[i]) for i in peaks]
        if self.mirror:
            lo, hi = -hi, -lo; foot, head = (None if head is None else -head), (None if foot is None else -foot); modes = [-m for m in modes]
        self.foot = None if foot is None else ld(foot)
        if self.foot is not None: self.zM = -self.foot
        self.lo_full, self.hi_full, self.mode = lo, hi, max(modes)
        if self.foot is not None: self.lo_full = self.foot
        if head is not None: self.hi_full = ld(head)
    def lnphi_m(self, z):           # of the unmirrored curve
        y = (z - self.xi)/self.lam
        with np.errstate(divide="ignore", invalid="ignore"):
            if self.kind == "SU":
                r = self.ga_j + self.de_j*np.arcsinh(y); out = self.lnd - r*r/2 - np.log1p(y*y)/2 - np.log(self.lam); return out
            if self.kind == "SL":
                r = self.de_j*np.log(y); return np.where(y > 0, self.lnd - r*r/2 - np.log(y) - np.log(self.lam), -LD(10)**4000)
            r = self.ga_j + self.de_j*(np.log(y) - np.log1p(-y))
            return np.where((y > 0) & (y < 1), self.lnd - r*r/2 - np.log(y) - np.log1p(-y) - np.log(self.lam), -LD(10)**4000)
    def lnphi(self, z): return self.lnphi_m(np.asarray(-z if self.mirror else z))
    def phi(self, z, x): return np.exp(np.maximum(self.lnphi(z), LD(-11000)))
    def noise(self, z):
        h = LD(1e-6); l = self.lnphi(z); slope = np.abs(self.lnphi(z*(1 - h)) - l)/h
        return EPS*(20 + 8*np.minimum(slope, LD(10)**6) + 4*np.minimum(np.abs(l), LD(10)**6))

# ---------------------------------------------------------------- tables
class Table(generate.Model):
    def set_heights(self, p):
        self.om = None; self.endless = False
        x, f = [mp.mpf(v) for v in p["table_height"]], [mp.mpf(v) for v in p["table_density"]]
        pos = [i for i, v in enumerate(f) if v > 0]; a, b = max(pos[0] - 1, 0), min(pos[-1] + 2, len(x))
        x, f = x[a:b], f[a:b]; n = len(x) - 1
        h = [x[i+1] - x[i] for i in range(n)]; s = [(f[i+1] - f[i])/h[i] for i in range(n)]
        e = [s[0]] + [mp.mpf(0)]*(n - 1) + [s[-1]]
        for i in range(1, n):
            if s[i-1]*s[i] > 0: e[i] = 3*(h[i-1] + h[i])/((2*h[i] + h[i-1])/s[i-1] + (h[i] + 2*h[i-1])/s[i])
        mass = []
        for i in range(n):
            mean, third = (f[i] + f[i+1])/2, abs(f[i+1] - f[i])/6
            mass.append(h[i]*min(max(mean - h[i]*(e[i+1] - e[i])/12, mean - third), mean + third))
        # the Hermite cubic of the cumulative distribution on [0, 1]: its derivative by height, as coefficients of t^0, t^1, t^2
        q = [(f[i], 6*mass[i]/h[i] - 4*f[i] - 2*f[i+1], 3*(f[i] + f[i+1]) - 6*mass[i]/h[i]) for i in range(n)]
        def integral(k, c):         # of (x - c)^k times the density
            t = mp.mpf(0)
            for i in range(n):      # (x_i - c + h t)^k by the binomial theorem
                for j in range(k + 1):
                    w = mp.binomial(k, j)*(x[i] - c)**(k - j)*h[i]**j
                    t += h[i]*w*sum(q[i][r]/(j + r + 1) for r in range(3))
            return t
        total = integral(0, 0); mean = integral(1, 0)/total; sd = mp.sqrt(integral(2, mean)/total)
        self.skew, self.kurtosis = (integral(k, mean)/total/sd**k for k in (3, 4))
        self.zk = np.array([ld((v - mean)/sd) for v in x]); self.knots = tuple(self.zk[1:-1])
        self.q = np.array([[ld(c*sd/total) for c in r] for r in q])
        self.foot, self.zM = self.zk[0], -self.zk[0]; self.lo_full, self.hi_full = self.zk[0], self.zk[-1]
        self.mode = self.zk[-1]
    def phi(self, z, x):
        i = np.clip(np.searchsorted(self.zk, z, side="right") - 1, 0, len(self.q) - 1)
        t = (z - self.zk[i])/(self.zk[i+1] - self.zk[i]); q = self.q[i]
        v = np.maximum(q[:, 0] + t*(q[:, 1] + t*q[:, 2]), 0)
        return np.where((z >= self.zk[0]) & (z <= self.zk[-1]), v, LD(0))
    def lnphi(self, z): return LD(0)*z
    def noise(self, z): return EPS*(200 + 0*z)

# ---------------------------------------------------------------- parameter sets
def model(p):
    return Table(p) if p["kurtosis"] is None else Johnson(p)

def in_domain(S, K): return abs(S) <= 3 and 1.87 + 1.25*S*S <= K <= 100

def sets():
    R = random.Random(20061949); out = []
    def lu(a, b): return float("%.4g" % math.exp(R.uniform(math.log(a), math.log(b))))
    def surface(i):
        p = dict(alpha=lu(3e-3, .05), beta=lu(100, 2e4), gamma=0. if i % 5 == 4 else lu(1e-4, .01), b_over_h=round(R.uniform(.4, 1.4), 3),
                 epsilon=0., rho=.5, weibull_shape=None, skew=None, kurtosis=None, table_height=None, table_density=None,
                 noncontacting=R.random() < .8, a1=28.0, tau1=1/43, a2=80000.0, tau2=1/1290)
        if i % 3 == 2: p["epsilon"] = round(R.uniform(-.9, .9), 3); p["rho"] = lu(.2, 2)
        if i % 4 == 3: p["a1"], p["tau1"] = lu(2, 200), lu(5e-3, .1); p["a2"], p["tau2"] = float("%.4g" % (p["a1"]*lu(3, 1e3))), float("%.4g" % (p["tau1"]/lu(1.5, 50)))
        return p
    near = lambda S: float(lognormal_kurtosis(S)[0])
    shapes = [(0., 3.5), (0., 2.4), (0., 6.), (0., 1.5), (.5, 3.2), (.5, 4.), (-.5, 3.1), (-.5, 4.5), (1., 3.4), (1., 6.), (-1., 3.6), (-1., 7.),
              (1., 2.8), (2., 8.), (-2., 9.5), (3., 25.), (-2., 30.), (0.2, 1.8), (.05, 3.01), (0., 3.0001), (0., 2.9999), (-.3, 2.),
              (1., near(1)), (-1., near(1)), (1., near(1)*(1 + 1e-7)), (1., near(1)*.99), (.6311106578189366, 3.2450893006876368)]
    for i, (S, K) in enumerate(shapes):
        p = dict(surface(i), skew=S, kurtosis=K)    # drawn for each, so that the others stay as they are
        if in_domain(S, K): out.append(("johnson %s %s" % (S, K), p))
    def table(name, i, x, f): out.append(("table " + name, dict(surface(i), table_height=[float(v) for v in x], table_density=[float(v) for v in f])))
    bell = lambda x, m, s: math.exp(-(x - m)**2/2/s/s)
    table("of three", 0, [0, 1, 3], [0, 2, 1])
    table("flat", 1, [-1, 0, 1], [1, 1, 1])
    table("gaussian 25", 2, [k*.4 - 4.8 for k in range(25)], ["%.6g" % bell(k*.4 - 4.8, 0, 1) for k in range(25)])
    table("rayleigh 20", 3, [k*.25 for k in range(20)], ["%.6g" % (k*.25*bell(k*.25, 0, 1)) for k in range(20)])
    table("two bumps", 4, [1e-6*(k*.15) for k in range(30)], ["%.4g" % (bell(k*.15, 1, .3) + .2*bell(k*.15, 3, .25)) for k in range(30)])
    table("two bumps apart", 5, [0, 1, 2, 3, 4, 8, 9, 10, 11], [0, 1, 3, 1, 0, 0, .5, 1, 0])
    table("steps", 6, [0, 1, 1 + 1e-9, 2, 2 + 1e-9, 3], [1, 1, 3, 3, .5, .5])
    table("uneven", 7, [-3, -2.9, -1, 0, .01, .5, 2, 2.2, 5], [0, .01, .3, 1, .9, .8, .2, .25, 0])
    table("measured", 8, [12.0 + .7*k for k in range(14)], [R.randrange(1, 40) for k in range(14)])
    table("far from its origin", 9, [1e6 + k for k in range(9)], [0, 1, 4, 9, 12, 8, 5, 2, 1])
    return out

if __name__ == "__main__":
    a = sys.argv[1:]; path = a[1] if a[:1] == ["--out"] else None
    cases = generate.generate(path, sets=sets(), Model=model)
    if not path: json.dump(cases, sys.stdout, indent=1); print()
