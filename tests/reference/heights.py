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

class Ends(Johnson):
    """S_B next to the edge of the feasible region, where nearly all summits lie next to one end or the other: sums over the
    logit x = ln(y/(1 - y)), in which the mass of summits is normal, on panels graded towards every edge, at two resolutions.
    Equal radii, or no adhesion.  Heights are written from both ends; what is known by its distance from an end stays so."""
    def set_heights(self, p):
        super().set_heights(p); assert self.kind == "SB"
        s = -1 if self.mirror else 1                # logit of the median, normal deviate per logit
        self.mid, self.slope = -s*self.ga_j/self.de_j, self.de_j
        self.head = self.foot + self.lam
    def mass(self, x): u = (x - self.mid)*self.slope; return np.exp(-u*u/2)*self.slope/np.sqrt(2*generate.PI)
    def above(self, x, z0, x0):     # the height of a logit above another height, which has the logit x0
        near = np.abs(x - x0) < 1
        diff = self.lam*np.sinh(np.clip((x - x0)/2, -1, 1))/(2*np.cosh(x/2)*np.cosh(np.clip(x0, -2000, 2000)/2))
        up, dn = self.lam/(1 + np.exp(-x)), self.lam/(1 + np.exp(x))
        return np.where(near, diff, np.where(x < 0, up + (self.foot - z0), (self.head - z0) - dn))
    def logit(self, z): return np.log(z - self.foot) - np.log(self.head - z)
    def sums(self, d, npts, ratio):
        d = LD(d); wb = self.edge1.w[0]; edge, low = d + self.H*wb, d - self.H
        attr = self.p["noncontacting"] and self.ga > 0
        xmin, xmax = self.mid - 16/self.slope, self.mid + 16/self.slope
        cuts = {xmin: None, xmax: None}; marks = {edge: 0}
        if attr: marks[low] = 1
        for z in marks:
            if self.foot < z < self.head: cuts[self.logit(z)] = z
        # heights at which the radius passes a kink of the slip law, by bisection in logit
        start = self.logit(edge) if self.foot < edge < self.head else xmin
        if edge < self.head:
            for lim in (self.a1, self.a2):
                lo, hi = max(start, xmin), xmax
                rad = lambda x: self.radius_at(np.array([x]), edge)[0] - lim
                if rad(lo) < 0 < rad(hi):
                    for _ in range(90):
                        m = (lo + hi)/2
                        if rad(m) < 0: lo = m
                        else: hi = m
                    cuts[(lo + hi)/2] = None
        xs = sorted(c for c in cuts if xmin <= c <= xmax); gx, gw = generate.gauss(npts)
        out, mag = np.zeros((2, generate.NQ), LD), np.zeros((2, generate.NQ), LD)
        for xa, xb in zip(xs, xs[1:]):
            m = (xa + xb)/2; z = self.height(m)
            con = z > edge
            if not con and (not attr or z < low): continue
            for x0, sg in ((xa, 1), (xb, -1)):
                S = np.sqrt((xb - xa)/2); K = int(math.ceil(24/math.log(ratio)))
                s = [S*LD(ratio)**-k for k in range(K + 1)] + [LD(0)]; pans = []
                for b, a in zip(s, s[1:]):          # in s = sqrt(|x - x0|); no panel longer than 1 in logit, where that counts
                    la, lb = a*a, b*b
                    n = max(1, int(math.ceil(float(min((lb - la)/LD(ratio - 1), 4000)))))
                    n = max(n, int(math.ceil(float((lb - la)*self.slope*2))))
                    pans += [(np.sqrt(la + (lb - la)*LD(i)/n), np.sqrt(la + (lb - la)*LD(i + 1)/n)) for i in range(n)]
                p0, p1 = np.array([q[0] for q in pans]), np.array([q[1] for q in pans])
                s = (p0[:, None] + (p1 - p0)[:, None]*gx).ravel(); w = ((p1 - p0)[:, None]*gw).ravel()*2*s
                x = x0 + sg*s*s; z0 = cuts[x0]
                zz = self.height(x)
                if z0 is None: z0 = self.foot if x0 < 0 else self.head; x00 = LD(-12000) if x0 < 0 else LD(12000); rise = zz - d
                else: rise = (z0 - d) + self.above(x, z0, x0)
                if con:
                    e = np.maximum(rise/self.H - wb, 0)
                    if cuts[x0] == edge: e = np.maximum(self.above(x, z0, x0)/self.H, 0)
                    th, de = generate.solve(e, self.edge1); v = self.at(zz, th, de)
                else:
                    r = rise/self.H
                    if cuts[x0] == low: r = -1 + self.above(x, z0, x0)/self.H
                    v = self.attract(zz, r)
                v = v*(self.mass(x)*w); j = 0 if con else 1
                out[j] += v.sum(axis=1); mag[j] += np.abs(v).sum(axis=1)
        ends = []
        for z, kind in marks.items():
            if not self.foot < z < self.head: continue
            x = self.logit(z); ph = self.mass(np.array([x]))[0]*self.lam/((z - self.foot)*(self.head - z)); za = np.array([z])
            if kind == 0:
                ends.append((-1, ph, self.at(za, self.edge1.th, self.edge1.de)))
                if attr and self.H*(1 + wb) > 0: ends.append((1, ph, self.attract(za, self.edge1.w)))
            else:
                if self.H*(1 + wb) > 0: ends.append((-1, ph, self.attract(za, np.array([LD(-1)]))))
        dP = sum(sg*ph*v[3][0] for sg, ph, v in ends); dF = sum(sg*ph*v[2][0] for sg, ph, v in ends)
        return out, mag, dP, dF
    def quick(self, d): r, _, _, _ = self.sums(d, 10, 3.); return float(r[0][3] + r[1][3]), float(r[0][2])
    def height(self, x):
        x = np.asarray(x); return np.where(x < 0, self.foot + self.lam/(1 + np.exp(-x)), self.head - self.lam/(1 + np.exp(x)))
    def radius_at(self, x, edge):
        z = self.height(x); th, de = generate.solve(np.maximum((z - edge)/self.H, 0), self.edge1); return self.at(z, th, de, True)
    def row(self, d):
        assert not self.vary
        (r1, s1, eP1, eF1), (r, s, eP, eF) = self.sums(d, 20, 2.), self.sums(d, 30, 1.7)
        load, labs = r[0][3] + r[1][3], s[0][4] + s[1][4]; rel = lambda x, y, c: float(abs(x - y)/c) if c > 0 else 0.
        err = max([rel(r1[0][k], r[0][k], r[0][k]) for k in (0, 1, 2)] + [rel(r1[0][3] + r1[1][3], load, labs), rel(r1[1][0], r[1][0], r[1][0])])
        dP, dF = -(r[0][5] + r[1][5]) + eP, -r[0][6] + eF; dP1, dF1 = -(r1[0][5] + r1[1][5]) + eP1, -r1[0][6] + eF1
        return dict(separation=float(d), load=float(load), load_contacting=float(r[0][3]), load_attracted=float(r[1][3]), friction=float(r[0][2]),
                    contacting=float(r[0][0]), area=float(r[0][1]), dload_dseparation=float(dP), dfriction_dload=float(dF/dP), attracted=float(r[1][0]),
                    load_absolute=float(labs), error=err), \
               dict(err=err, load_err=rel(r1[0][3] + r1[1][3], load, abs(load)), slope_err=max(float(abs(dP/dP1 - 1)), float(abs(dF/dP/(dF1/dP1) - 1))),
                    roots=1, intervals=1, rough=False)

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
    if p["kurtosis"] is None: return Table(p)
    return Ends(p) if p["kurtosis"] < 1.4 + 1.3*p["skew"]**2 else Johnson(p)

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
        out.append(("johnson %s %s" % (S, K), dict(surface(i), skew=S, kurtosis=K)))
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
    # next to the edge of the feasible region: with adhesion the roughness is small beside its range, else they part in steps
    edge = [(0., 1.39), (0., 1.2), (0., 1.05), (1., 2.5), (1., 2.1), (-1., 2.2), (2., 5.8), (2., 5.3), (-2., 6.), (5., 30.), (-5., 28.)]
    for i, (S, K) in enumerate(edge):
        root = math.hypot(S, 2); lower, upper = (S - root)/2, (S + root)/2; p = dict(surface(i), skew=S, kurtosis=K)
        p["separations"] = [float("%.6g" % (lower + (upper - lower)*q)) for q in (-.4, .003, .3, .97)]
        if i % 2: p["alpha"], p["beta"], p["gamma"], p["epsilon"] = lu(3e-3, 6e-3), lu(100, 200), lu(2e-3, 4e-3), 0.
        else: p["gamma"] = 0.
        out.append(("johnson %s %s" % (S, K), p))
    return out

if __name__ == "__main__":
    a = sys.argv[1:]; path = a[1] if a[:1] == ["--out"] else None
    cases = generate.generate(path, sets=sets(), Model=model)
    if not path: json.dump(cases, sys.stdout, indent=1); print()
