"""The diagrams of grasps with friction, worked by hand."""

from __future__ import annotations

import pytest

from stochgeom.decision.density_priors import WrappedNormal
from stochgeom.decision.discrete_prior import DiscretePrior
from stochgeom.decision.mixture_prior import MixturePrior
from stochgeom.decision.priors import uniform_prior
from stochgeom.errors import CenterOfMassError, InputError, InvalidAngleError, OutcomeError
from stochgeom.exact.angles import FULL_TURN, HALF_TURN, QUARTER_TURN, ZERO, Angle
from stochgeom.exact.cells import CellSet
from stochgeom.exact.intervals import Interval
from stochgeom.exact.sums import AngleSum
from stochgeom.geometry.diameter import DiameterFunction
from stochgeom.geometry.part import Part
from stochgeom.grasping.contacts import contacts_of
from stochgeom.grasping.grasp_diagram import GraspDiagram
from stochgeom.grasping.grasp_report import GraspReport
from stochgeom.grasping.push_stability import Jaw, Motion, PushStability
from stochgeom.grasping.squeeze_stability import SqueezeStability
from stochgeom.thesis.parts import catalogue_part

SQUARE = Part([(0, 0), (1, 0), (1, 1), (0, 1)])
HOUSE = catalogue_part("house")
ALPHA = Angle(0, (4, 1))
TINY = Angle(0, (10**30, 1))


def degrees(value):
    return Angle.from_degrees(value)


class TestPushStability:
    def test_motions_of_the_square(self):
        push = PushStability(SQUARE)
        motions = {k: push.motion(degrees(k)).name for k in (0, 30, 45, 60, 359, 405)}
        assert motions == {
            0: "STABLE",
            30: "CLOCKWISE",
            45: "UNSTABLE",
            60: "COUNTERCLOCKWISE",
            359: "COUNTERCLOCKWISE",
            405: "UNSTABLE",
        }

    def test_an_unstable_equilibrium_may_tip_either_way(self):
        push = PushStability(SQUARE)
        arc = push.image(degrees(45))
        assert (arc.start.reduced(), arc.width) == (ZERO, QUARTER_TURN)

    def test_a_stable_orientation_stays(self):
        arc = PushStability(SQUARE).image(degrees(90))
        assert (arc.start.reduced(), arc.width) == (QUARTER_TURN, ZERO)

    def test_the_upper_jaw_is_the_lower_one_half_a_turn_on(self):
        lower, upper = PushStability(HOUSE), PushStability(HOUSE, Jaw.UPPER)
        assert upper.stable == tuple(
            sorted((theta + HALF_TURN).reduced() for theta in lower.stable)
        )
        for k in range(0, 360, 7):
            assert upper.motion(degrees(k)) == lower.motion(degrees(k + 180))

    def test_edges_that_are_not_stable_are_left_out(self):
        """The house, its centre of mass at the walls: the roof's edges do not hold it."""
        assert [theta.degrees(0) for theta in PushStability(HOUSE).stable] == ["0", "90", "270"]

    def test_center_of_mass_straight_over_the_end_of_an_edge(self):
        """No mark there: the part turns on through that orientation."""
        push = PushStability(Part([(0, 0), (4, 0), (5, 3), (0, 3)], (4, 1)))
        assert ZERO not in push.stable
        assert ZERO not in push.unstable
        assert push.motion(ZERO) == push.motion(degrees(1)) != Motion.STABLE

    @pytest.mark.parametrize("center", [(2, 0), (0, 0), (1, 0)])
    def test_a_center_of_mass_that_is_not_inside(self, center):
        part = Part([(0, 0), (1, 0), (1, 1), (0, 1)], center)
        for make in (PushStability, lambda p: GraspDiagram(p, "1/4")):
            with pytest.raises(CenterOfMassError, match="strictly inside"):
                make(part)
        assert SqueezeStability(part, "1/4").stable  # a squeeze does not ask for it

    def test_valleys_cover_the_circle(self):
        part = Part([(0, 0), (10, 0), (0, 1)], ("1/5", "1/3"))
        push = PushStability(part)
        for k in range(0, 360, 5):
            valley = push.valley_of(degrees(k))
            assert valley.low <= degrees(k) < valley.high


class TestContacts:
    def test_rho_jumps_up_at_transitions_and_falls_between(self):
        for name in ("house", "wrench", "key"):
            found = contacts_of(DiameterFunction(catalogue_part(name)))
            for p in range(len(found)):
                assert found.before[p] < found.after[p]
                assert found.before[(p + 1) % len(found)] < found.after[p]
                assert found.before[p] > -QUARTER_TURN
                assert found.after[p] < QUARTER_TURN

    def test_lifted_pieces(self):
        found = contacts_of(DiameterFunction(SQUARE))
        assert found.start(-1) == -QUARTER_TURN
        assert found.normal(4) == FULL_TURN + degrees(45)


class TestSqueezeStability:
    def test_ends_of_a_wedging_interval_turn_away(self):
        squeeze = SqueezeStability(SQUARE, "1/4")
        low, high = degrees(45) - ALPHA, degrees(45) + ALPHA
        assert squeeze.outcomes(low) == (ZERO,)
        assert squeeze.outcomes(high) == (QUARTER_TURN,)
        assert squeeze.motion(low) is Motion.CLOCKWISE
        assert squeeze.motion(high) is Motion.COUNTERCLOCKWISE
        assert squeeze.motion(degrees(45)) is Motion.WEDGED
        assert squeeze.motion(ZERO) is Motion.STABLE
        assert low not in squeeze.wedged
        assert high not in squeeze.wedged

    def test_without_friction_a_maximum_may_tip_either_way(self):
        squeeze = SqueezeStability(SQUARE, 0)
        assert set(squeeze.outcomes(degrees(45))) == {ZERO, QUARTER_TURN}
        assert squeeze.motion(degrees(45)) is Motion.UNSTABLE
        assert squeeze.wedging == ()
        both = squeeze.weak_preimage(CellSet.at([ZERO]))
        assert degrees(45) in both
        assert degrees(45) not in squeeze.strong_preimage(CellSet.at([ZERO]))

    def test_wedging_clipped_to_the_piece_of_its_pair(self):
        """The house: roof and wall; each interval is inside the piece of its pair."""
        squeeze = SqueezeStability(HOUSE, "1/4")
        shown = [
            (w.start.degrees(4), w.arc.end.degrees(4), w.vertices) for w in squeeze.wedging[:4]
        ]
        assert shown == [
            ("4.3987", "32.4712", (0, 3)),
            ("45.0000", "59.0362", (0, 2)),
            ("120.9638", "135.0000", (4, 1)),
            ("147.5288", "175.6013", (3, 1)),
        ]
        assert squeeze.wedging[1].normal == degrees(45)
        assert degrees(45) not in squeeze.wedged

    def test_an_edge_that_only_friction_holds(self):
        squeeze = SqueezeStability(HOUSE, "1/4")
        roof = next(edge for edge in squeeze.stable if edge.orientation == degrees(45))
        assert (roof.by_friction, roof.lower_edge, roof.upper_edge) == (True, None, (2, 3))
        assert squeeze.outcomes(degrees(45)) == (degrees(45),)
        assert squeeze.outcomes(degrees(44)) == (degrees(45),)
        assert not any(e.orientation == degrees(45) for e in SqueezeStability(HOUSE, 0).stable)

    def test_turning_into_a_wedging_interval(self):
        """From 44 degrees the house turns onto its roof, behind which the interval begins."""
        squeeze = SqueezeStability(HOUSE, "1/4")
        assert degrees(44) not in squeeze.wedged
        assert degrees(44) in squeeze.wedged_if_strict
        assert degrees(45) not in squeeze.wedged_if_strict

    def test_parallel_edges_lie_flush_together(self):
        assert [(e.lower_edge, e.upper_edge) for e in SqueezeStability(SQUARE, 1).stable][:2] == [
            ((0, 1), (2, 3)),
            ((3, 0), (1, 2)),
        ]

    def test_endless_friction(self):
        squeeze = SqueezeStability(HOUSE, 10**9)
        assert squeeze.wedged == ~CellSet.at(squeeze.contacts.starts)
        assert len(squeeze.stable) == len(squeeze.contacts)

    def test_a_friction_angle_that_just_does_not_reach(self):
        """A cone is open: at equality neither a pair wedges nor an edge holds.

        Both edges at a corner see each other's far end under the angle between them: they begin
        to hold together.
        """
        part = Part([(0, 0), (5, 0), (-2, 1)])
        found = contacts_of(DiameterFunction(part))
        p = next(p for p, rho in enumerate(found.after) if rho < ZERO)
        just, start = -found.after[p], found.starts[p]
        at_it, above = (SqueezeStability(part, mu) for mu in (just, just + TINY))
        assert start not in at_it.stable_set
        assert start in above.stable_set
        assert len(above.wedging) == len(at_it.wedging) + 4  # both edges at it, twice


class TestGraspDiagram:
    def test_targets_that_no_grasp_ends_in(self):
        diagram = GraspDiagram(SQUARE, "1/4")
        with pytest.raises(OutcomeError, match=r"no grasp ends at 20\.0000°; accepted: the stable"):
            diagram.weak_preimage(degrees(20))
        with pytest.raises(InvalidAngleError, match="accepted"):
            diagram.strong_preimage("stable")
        assert diagram.weak_preimage(degrees(45))  # a wedged one is an outcome

    def test_a_preimage_of_a_wedged_orientation(self):
        """45 degrees is reached by no push, so from itself only."""
        diagram = GraspDiagram(SQUARE, "1/4")
        assert diagram.weak_preimage(degrees(45)) == CellSet.at([degrees(45)])
        assert not diagram.strong_preimage(degrees(45))

    def test_a_triangle_guarantees_nothing(self):
        diagram = GraspDiagram(catalogue_part("triangle"), "1/100")
        assert not diagram.guaranteed
        assert diagram.largest_tolerances() == ()
        assert not diagram.grasps_bearing(ZERO)

    def test_no_friction_bears_everything(self):
        diagram = GraspDiagram(HOUSE, 0)
        (best,) = diagram.largest_tolerances()
        assert (best.margin.angle, best.grasp_angle.angle) == (HALF_TURN, ZERO)
        assert diagram.grasps_bearing(HALF_TURN).is_whole

    def test_bearing_a_tolerance(self):
        diagram = GraspDiagram(SQUARE, "1/4")
        most = degrees(45) - ALPHA
        assert diagram.grasps_bearing(most) == diagram.stable_set
        assert not diagram.grasps_bearing(most + Angle(0, (10**20, 1)))
        assert not diagram.grasps_bearing(HALF_TURN)
        with pytest.raises(InvalidAngleError, match="0 or more"):
            diagram.grasps_bearing(-most)

    def test_the_grasp_angle_turns_the_gripper(self):
        """The part at its input pose, the gripper turned by g: the orientation is -g."""
        part = HOUSE.multiply((3, 1))
        for best in GraspDiagram(part, "1/4").largest_tolerances():
            total = best.grasp_angle.doubled + best.orientation.doubled
            assert not total.reduced()
            middle = best.orientation.nearby
            assert middle in GraspDiagram(part, "1/4").guaranteed

    def test_points_of_a_prior_at_the_ends(self):
        diagram = GraspDiagram(SQUARE, "1/4")
        end = degrees(45) - ALPHA
        at_end = DiscretePrior([(end, "1/3"), (end + Angle(0, (10**20, 1)), "2/3")])
        assert diagram.bound_under(at_end).rational * 3 == 1
        half = MixturePrior([("1/2", at_end), ("1/2", uniform_prior())])
        mixed = diagram.bound_under(half)
        expected = AngleSum("1/6") + diagram.bound.scaled("1/2")
        assert mixed.compare(expected) == 0

    def test_a_prior_that_is_only_enclosed(self):
        prior = WrappedNormal(mean="0", sd="5")
        assert GraspDiagram(SQUARE, "1/4").bound_under(prior).decimal(4) == "1.0000"
        assert GraspDiagram(SQUARE, 0).bound_under(prior).rational == 1

    def test_open_ends_do_not_count_points(self):
        cells = CellSet.of([Interval(ZERO, QUARTER_TURN, False, True)])
        prior = DiscretePrior({"0": "1/4", "45": "1/4", "90": "1/2"})
        assert prior.mass_of(cells).rational * 4 == 3
        assert prior.mass_of(CellSet.at([ZERO])).rational * 4 == 1
        assert uniform_prior().mass_of(CellSet.at([ZERO])).rational == 0


class TestGraspReport:
    def test_what_was_not_asked(self):
        report = GraspReport(SQUARE, "1/4")
        for name in ("grasps", "prior_bound", "largest_mu", "largest_mu_pushing"):
            with pytest.raises(InputError, match="was given"):
                getattr(report, name)

    @pytest.mark.parametrize("value", ["-1", "181", degrees(200)])
    def test_tolerances_that_are_none(self, value):
        with pytest.raises(InputError, match=r"tolerance: .*from 0 to 180"):
            GraspReport(SQUARE, "1/4", tolerance=value)

    def test_grasps_are_angles_of_the_gripper(self):
        part = Part([(0, 0), (3, 0), (3, 2), (0, 2)]).multiply((2, 1))
        report = GraspReport(part, "1/4", tolerance="20")
        for item in report.grasps:
            assert -item.start in report.diagram.guaranteed
