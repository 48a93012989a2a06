//! Surfaces that long sweeps over the box found wrong, refused without need or slow, each once.

use crate::common::second_evaluation::heights::{Heights, Johnson, Table};
use crate::common::second_evaluation::Surface;

#[rustfmt::skip]
pub fn surfaces() -> Vec<Surface> {
    let table = |height: &[f64], density: &[f64]| Heights::Table(Table::new(height.to_vec(), density.to_vec()));
    // alpha, beta, gamma, b/h; heights; epsilon, rho; attraction.
    let found: [([f64; 4], Heights, [f64; 2], bool); 14] = [
        // An end of a panel that was not found met a search for a kink: the library panicked.
        ([5.304071568985277e-2, 5.862277965328117e4, 2.2150197609801716e-3, 14.62455047397752],
         Heights::weibull(2.9071728339722447), [-0.9667968745343387, 48.42376957693709], false),
        ([5.376117480320232e-1, 1.3792672947357585e2, 2.8888200323380414e-1, 3.3573944009554624],
         table(&[0.8895449647088878, 2.773862606380649, 3.1757086378524355, 4.09115422933819,
               4.356416397143227],
             &[0.0, 0.12988249738358382, 0.5576502740440499, 0.04875718654561095, 0.0]),
         [-0.8320312495343387, 6.278437322850412e-1], true),
        // Radii that fall with height: a panel reached to where heights no longer follow from the parameter, or past that.
        ([7.914755447897558e-4, 3.8025779525129925e4, 5.4518655846326515e-3, 4.853891196504165],
         table(&[-5.813989844401888, -4.993904381351607, -3.0192620053854187, -2.406132263987151],
             &[0.032934182766894075, 0.039316241170361116, 0.04305982362420385, 0.09495684687996031]),
         [-0.9453124995343387, 1.9720679526084192e-1], true),
        ([1.388603084010749e-4, 7.870387121416084e5, 1.4391120808752794e-2, 1.6446693781391836e-1],
         table(&[-4.489961697568088, -3.417832110736553, -2.648617242861531, -1.858450684762728,
               -1.5407025887545258, -0.8816518578021593, 0.623045591036764],
             &[0.2444713824824588, 0.044550593043712415, 0.0728111200712733, 0.11853506338604237,
               0.056487329802766516, 2.9463952934654145, 1.5031925848685237]),
         [-0.5722656245343387, 1.6791815617550179], true),
        ([4.086280032286452e-1, 8.926549026510295e5, 6.70652266645981e-2, 9.294725592955211e-1],
         Heights::Johnson(Johnson::new(true, -4.511355037327726, 1.8353705043846105)), [-0.9785156245343387, 3.772768495305656], true),
        ([2.0305663643510564e-3, 9.36344249608463e4, 2.0507051057689425e-2, 5.229843984166102],
         Heights::Gaussian, [-0.9716796870343387, 1.2570867098020932], true),
        // Radii that grow steeply with height: as the end of a panel was hardly found, there were thousands.
        ([2.0908000435205257e-4, 1.4265824462018043e5, 1.6597859509616816e-3, 18.427013627578155],
         Heights::Gaussian, [0.8203125004656613, 78.08688986353269], false),
        // The foot of the heights breaks away to the last bit: refused.
        ([7.490515710136327e-4, 1.702468567705375e2, 2.9049239456449966e-7, 7.26576119649655e-2],
         Heights::weibull(1.2900835648769988), [0.0, 1.0], true),
        // The foot breaks away to the last bit, where a step of Newton's method next to the fold led off the branch: refused.
        ([2.567709565053962e-1, 3.0913118812920464e4, 3.1169292405082965e-3, 4.824691559451277],
         Heights::weibull(1.0298933394383276), [-6.823730422183871e-2, 1.249073904852301e-3], true),
        // Of two minima of the load, the first was not found from where the load had risen far behind it: refused.
        ([1.0084679716739637e-4, 3.540064959222074, 7.056104378931292e-1, 7.41188656693803e-1],
         Heights::weibull(89.1208460545219), [0.9645996098406613, 9.99859472574255], true),
        // Refused, wrong by 1e-6, or slow for one of these reasons.
        ([4.4084620834585766e-4, 2.15857668197466e5, 5.652112921818283e-3, 1.8630960734196111e-1],
         Heights::weibull(12.338911759372673), [-0.2697753901593387, 1.639769164822256e1], true),
        ([3.4096895943682743e-3, 7.585861052574494e4, 7.542629708698526e-1, 8.7839819593199e0],
         Heights::Gaussian, [0.9526367192156613, 3.9607581169073555e1], true),
        ([1.7358090710589943e-4, 3.216512583155971e6, 5.252803665456165e-1, 5.732602581787657e0],
         Heights::weibull(3.183622022996027), [0.9113769535906613, 1.772540602100253e0], false),
        ([2.8756778670488536e-2, 1.718091888888489e5, 1.9511774466711823e-1, 4.533057544911567e0],
         Heights::weibull(85.57692478317134), [-0.9592285151593387, 5.981284142477296e-1], true),
    ];
    let slip = [28.0, 1.0 / 43.0, 8e4, 1.0 / 1290.0];
    let surfaces = found.map(|([alpha, beta, gamma, b_over_h], heights, [epsilon, rho], attraction)| {
        Surface { alpha, beta, gamma, b_over_h, heights, epsilon, rho, attraction, slip }
    });
    surfaces.into()
}
