"""Errata of equations, theorems and prose; those of tables and figures are in `errata`."""

from __future__ import annotations

from typing import Final

from stochgeom.thesis.errata import Erratum

COLUMNS_OF_6_4: Final = Erratum(
    "Fig. 6.4, columns of the text copy",
    "13",
    "12",
    "there are twelve states; no counts give even the first row with 13 columns, and 177 trials "
    "give the whole matrix, but for two digits, with 12; columns 4 to 11 are alike, so that it "
    "does not matter which one is spare",
)

HOUSE_DENSITY: Final = Erratum(
    "Tables 3.1 and C.1, captions, and Fig. E.8, the house",
    "all parts have uniform mass density",
    "the house of the catalogue has its cells with the centre of mass at (0, 0), not at its "
    "centroid, and with no centre of mass both them and Fig. E.8",
    "with the centre at the centroid of this outline, (0, 4/15), one of six cells holds, and Fig. "
    "E.8 does not; centres that give Fig. E.8 are within .05 of the axis at heights of .28 to .43, "
    "where the cell .90 of Table C.1 is below .88, or, should the .20 not be the base's, beside a "
    "corner of the base, where the cell .72 is below .68. This is shown for all centres, but for "
    "this outline: whether a uniform house with other walls or another roof has the printed cells "
    "is open",
)

OTHER_DENSITIES: Final = Erratum(
    "Tables 3.1 and C.1, captions, the 4gon, 5gon, wrench, tuning-fork and key",
    "all parts have uniform mass density",
    "not shown to be wrong: a uniform key with eleven sides has all its cells; of the 5gon, the "
    "wrench and the tuning-fork no uniform outline is known that has them, nor a proof that there "
    "is none",
    "the outlines of the catalogue have their centres of mass elsewhere than at their centroids, "
    "where the 5gon and the wrench have none of their six cells, the tuning-fork two and the key "
    "three; the 4gon has all six there, but not the first row of Fig. E.5 to the last digit. "
    "Sides and cells leave room for other outlines, and a search is no proof",
)

STABLE_ORIENTATIONS: Final = Erratum(
    "Def. 3.4, number of stable orientations",
    "at most one for each edge",
    "at most two, 2 n together",
    "each edge may lie against either jaw, as 4.4.2 has it with up to 2 n states, and Fig. 4.6 "
    "with eight for four edges; App. D's n stable grasps count orientations half a turn apart once",
)

LEMMA_5_1: Final = Erratum(
    "Lemma 5.1 and Def. 5.3",
    "if a plan collapses a set, it collapses the smallest contiguous set around it",
    "it collapses one contiguous set around it; the smallest one if the period T is at most half "
    "a turn, as that of squeezes",
    "two push-grasps of App. E's house bring the orientations 34 and 180 degrees to one, and 144 "
    "of the 146 degrees between them elsewhere: they collapse the longer arc, of 214 degrees. "
    "A collapsed arc is narrower than T, so that for T up to half a turn it is the shorter one. "
    "Lemma 5.2 and the theorems need one contiguous set only",
)

EQUATION_5_7: Final = Erratum(
    "5.7, text before Eq. 5.7",
    "a set larger than the last whose image is no larger than it",
    "smaller, as Eq. 5.7 and Fig. 5.1 have it",
    "an image is closed and a preimage open at one end, so that of two of one width the image does "
    "not fit; there is a part with an arc a period wide and an image exactly as wide as the second "
    "preimage, and no plan of three steps collapses that arc",
)

NUMBER_OF_PLANS: Final = Erratum(
    "5.4.1",
    "N preimages give plans of up to N - 1 steps",
    "of 1 to N steps",
    "the first preimage is a step of the transfer function and takes one action; each that follows "
    "takes one more, and for all eight parts no plan of one step less collapses the last of them",
)

TRAY_STATES: Final = Erratum(
    "6.2",
    "twelve states: in one of four corners or at one of four sides, horizontal or vertical",
    "at a side in one way only, the long edge against the wall",
    "corners and sides, each in two ways, would be sixteen; twelve are eight in corners and four "
    "at sides, and the matrix of Fig. 6.4 agrees with these (decision 24)",
)

FIGURE_E_1: Final = Erratum(
    "Fig. E.1, caption",
    "in a squeeze the part turns so that its diameter decreases, to a minimum of it",
    "in a push, its radius, to a minimum of that",
    "the figure is of the radius function, and the words those of the figure of the diameter; a "
    "push ends at minima of the radius and turns away from its maxima, which are others",
)

TEXT_OF_4_8: Final = Erratum(
    "4.8, text on the house, and a reference in 4.9.3",
    "a one-step plan costs 6.0; the search of section 4.5",
    "the two-step plan costs 6.0, one step 5.0; the search of section 4.8",
    "Table 4.1 and the recomputation have 5.0 at one step and 6.0 at two; section 4.5 defines "
    "optimal plans and searches for none",
)

EQUATION_5_3: Final = Erratum(
    "Eq. 5.3 and 5.4.1",
    "angles from the left ends of the preimages, margins (h_i - h_(i-1)) / 2",
    "angles are middles of the slack between the image of one preimage and the next preimage, "
    "with margins (h_(i-1) - image) / 2; no turn lies between a preimage and its own image",
    "the printed angles of Figs. 4.5, 4.6 and E.8 are such middles, added up; the angles of "
    "Eq. 5.3 are others, and for most parts they do not make a plan that orients the part, "
    "whatever signs its terms have",
)

FIGURE_5_1: Final = Erratum(
    "Fig. 5.1",
    "h_i = T is asked from i = 2 on",
    "it has to be asked of h_1 first",
    "one squeeze orients a square, a right and an obtuse triangle up to symmetry; the printed "
    "loop gives them plans of two steps, against Cor. 5.1.1",
)

FIGURE_5_8: Final = Erratum(
    "Fig. 5.8 and Lemma 5.4",
    "(i + 1)",
    "(i + c), with c the cost of the filter over that of an action",
    "the expected cost is (i + c) 2 pi / h_i by Eq. 4.5; the two are the same for c = 1 only, and "
    "the best number of steps depends on c",
)

PERIOD: Final = Erratum(
    "4.4.5, T_r",
    "the period of a transfer function for r-fold symmetry",
    "a period: the smallest one divides it",
    "the part (0, 0), (2, 0), (2, 1), (1, 2), (0, 1) has r = 1 and the period 90 degrees, not 180; "
    "the period of push-grasps divides 2 pi / r if r is that of the part with its centre of mass "
    "(a 3 by 2 rectangle has the period 180, and 360 with its centre at (1.9, 1)), so that a part "
    "is oriented uniquely only if it is 2 pi",
)

THEOREM_4_1: Final = Erratum(
    "Thm. 4.1",
    "k <= 2 n (c + 1)",
    "holds; for squeezes, k <= n (c + 1) - c",
    "the final orientations of squeezes come in pairs half a turn apart, so that no plan has a "
    "probability above 1/2",
)

THEOREM_5_4: Final = Erratum(
    "Thm. 5.4",
    "O(n^2) time",
    "for a fixed c by the printed proof; for every c as plans have at most 2 n - 1 steps",
    "the printed bound on the number of steps grows with c; that of Chen and Ierardi (1995) does "
    "not",
)

CONJECTURE_5_4_1: Final = Erratum(
    "Conj. 5.4.1",
    "open: whether the geometric planner takes O(n^2) time as well",
    "it does",
    "Chen and Ierardi (1995) proved that every polygon has a plan up to symmetry of at most "
    "2 n - 1 steps",
)

POTENTIAL: Final = Erratum(
    "Eq. D.2 and D.3",
    "U = -k d^2 / 2",
    "U = +k d^2 / 2, up to a constant",
    "jaws that close by a spring of negative stiffness would make the maxima of d stable; squeezed "
    "parts come to rest at minima",
)

SWEEP: Final = Erratum(
    "App. D, the sweep over chords",
    "the longest chord in the orthogonal interval touches the jaws",
    "the antipodal pair of the interval does",
    "the direction of the chord that touches need not lie in that interval, and a longer chord "
    "there need not touch; the rule fails for five of the eight parts",
)

DERIVATIVE: Final = Erratum(
    "Eq. F.4",
    "dp / dtheta = f(theta) - f(theta + h), with a unique zero",
    "f(theta + h) - f(theta), and its zeros are never unique",
    "p is the mass of [theta, theta + h): what enters ahead counts positive; on a circle p has a "
    "maximum and a minimum",
)

POSTERIOR: Final = Erratum(
    "Eq. 6.10 to 6.13",
    "the variance decreases with every observation; sum of alpha + x",
    "it decreases in expectation; sum of (alpha + x)",
    "Beta(1, 9) has the variance .0082, and .0124 after one success",
)

RANDOM_TILTS: Final = Erratum(
    "6.3.2",
    "a random number from zero to twelve",
    "from one to twelve",
    "there are twelve tilts, and the printed plans number them from one",
)

MEASURED_PLAN: Final = Erratum(
    "6.4",
    "the second plan performed slightly better than predicted",
    "better by at least five standard errors",
    ".67 predicted and .85 measured, in 200 trials if the two plans share the 400, or in 400",
)

SHORTEST_PATH: Final = Erratum(
    "7.1.2",
    "the heuristic minimises a lower bound; the exact method is exponential in the actions",
    "it maximises the bound; the exact method is exponential in the length of plans",
    "a lower bound on success is to be large; there are m^k plans of k of m actions, a power of "
    "m for each k",
)

SHANNON: Final = Erratum(
    "7.3",
    "Shannon's first theorem shows that a sensor's information is not negative on average",
    "the concavity of entropy does",
    "the hyperstate is the mean of the posteriors, weighted by their readings; one reading alone "
    "may raise the entropy",
)

LENGTH_OF_PLANS: Final = Erratum(
    "2.4",
    "additive costs bounded from below bound the length of plans",
    "they do if every action costs something, as the actions are finitely many",
    "with an action that costs nothing and moves half of what is left to the goal, the best plan "
    "of every horizon is as long as the horizon",
)

WORDS: Final = Erratum(
    "2.5.2, App. A, A.1 and 5.7",
    "maximise expected cost; maximum; L(theta, delta); preimage",
    "minimise; minimum; L(theta, delta(x)); image",
    "misprints: costs and losses are to be small, a loss is that of what the rule answers to x, "
    "and phase I compares the image with the last preimage",
)

INFINITE_COST: Final = Erratum(
    "2.5.3",
    "states off the goal cost infinity, so that a plan of finite cost cannot fail",
    "that needs the convention 0 x infinity = 0",
    "a sure plan still has states of probability 0 off the goal in its sum",
)
