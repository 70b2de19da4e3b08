"""Every error that stochgeom raises on purpose.

One family: `StochgeomError`. Each class names the fact that failed; each message gives the
offending value, where it stands, and what would have been accepted. `where` repeats the place
as data (``"vertex 7"``, ``"line 3"``), so that programs need not read prose.

Examples
--------
>>> from stochgeom.errors import NumberError, StochgeomError
>>> raise NumberError("'abc' is not a number; accepted: 3, 2/7, 0.25, 1e-3", where="vertex 7, x")
Traceback (most recent call last):
...
stochgeom.errors.NumberError: vertex 7, x: 'abc' is not a number; accepted: 3, 2/7, 0.25, 1e-3
"""

from __future__ import annotations


class StochgeomError(Exception):
    """Root of the family.

    Parameters
    ----------
    message : str
        What failed, the value, and what is accepted.
    where : str, optional
        The place in the input, such as ``"vertex 7"``.
    """

    def __init__(self, message: str, *, where: str | None = None) -> None:
        self.message = message
        self.where = where
        super().__init__(message if where is None else f"{where}: {message}")


class InputError(StochgeomError, ValueError):
    """The caller's input is not acceptable (exit code 2 on the command line)."""


# --- numbers -------------------------------------------------------------------------------------


class NumberError(InputError):
    """A value is not an exact rational number in an accepted notation."""


class FloatRefusedError(NumberError, TypeError):
    """A binary float was given where an exact number is needed."""


class NumberLimitError(NumberError):
    """A number's text is longer, or its exponent larger, than the limits allow."""


class NotRationalError(InputError):
    """An exact rational answer was asked for where the value is irrational."""


class MixedFieldsError(NumberError):
    """Irrational numbers of two different algebraic fields meet."""


class PrecisionLimitError(StochgeomError, ArithmeticError):
    """A certified answer needs more bits than the cap allows."""


# --- angles, arcs --------------------------------------------------------------------------------


class InvalidAngleError(InputError):
    """An angle is not well formed: the zero vector has no direction."""


class InvalidArcError(InputError):
    """An arc's width is outside (0, 360] degrees, or an interval is empty."""


# --- parts ---------------------------------------------------------------------------------------


class InvalidPartError(InputError):
    """A part's outline or centre of mass is not acceptable."""


class TooFewVerticesError(InvalidPartError):
    """An outline has fewer than three distinct vertices."""


class CollinearOutlineError(InvalidPartError):
    """All vertices of an outline lie on one line."""


class SelfIntersectionError(InvalidPartError):
    """Two edges of an outline cross or touch.

    Attributes
    ----------
    edges : tuple of int
        The two edges; edge i runs from vertex i to vertex i + 1, counted from 0.
    """

    def __init__(
        self, message: str, *, edges: tuple[int, int] = (-1, -1), where: str | None = None
    ) -> None:
        super().__init__(message, where=where)
        self.edges = edges


class InvalidHoleError(InvalidPartError):
    """A hole does not lie strictly inside the outline, or meets another hole."""


class CenterOfMassError(InvalidPartError):
    """A centre of mass lies outside the convex hull where the physics needs it inside."""


# --- transfer functions and plans ----------------------------------------------------------------


class InvalidStepFunctionError(InputError):
    """Breaks and values do not form a monotone step map of degree one."""


class CostError(InputError):
    """A cost ratio is negative or not a rational number."""


class GripperErrorError(InputError):
    """A gripper error is negative or no gripper's."""


class GoalError(InputError):
    """A chosen final orientation is none that an action leaves the part in."""


class NoPlanError(StochgeomError):
    """No plan does what was asked for (exit code 1 on the command line)."""


class FrictionError(InputError):
    """A coefficient of friction is negative, or no friction angle lies in [0, 90) degrees."""


class OutcomeError(InputError):
    """No grasp ends in the orientation asked for."""


class PriorError(InputError):
    """A prior's weights, densities or parameters do not make a probability distribution."""


class VerificationError(StochgeomError):
    """A plan does not do what it claims (exit code 1 on the command line)."""


# --- planning problems ---------------------------------------------------------------------------


class ProblemError(InputError):
    """A planning problem, a cost or a decision rule does not fit together."""


class NotStochasticError(ProblemError):
    """A prior or a row of a matrix is no probability distribution."""


class ShapeMismatchError(ProblemError):
    """A vector, a matrix or a table does not have one entry for each label."""


class UnknownLabelError(ProblemError, KeyError):
    """No state, action or reading of a problem has that label."""

    __str__ = Exception.__str__  # that of KeyError would quote the whole message


class DuplicateLabelError(ProblemError):
    """Two states, actions or readings of a problem have the same label."""


class EmptyProblemError(ProblemError):
    """A planning problem has no state or no action."""


class MixedNumbersError(ProblemError, NumberError):
    """Floats and exact numbers stand in one planning problem."""


class NodeLimitError(InputError):
    """A search would make more nodes than its limit allows."""


class SensorError(ProblemError):
    """A sensor, its cost or its noise is not acceptable."""


class ImpossibleReadingError(SensorError):
    """A reading has probability zero, so that it has no posterior."""


# --- tray tilting --------------------------------------------------------------------------------


class TrayError(InputError):
    """A tray, a tile, a gripper or the way they are simulated is none that there can be."""


class RecordingError(InputError):
    """A recording names a state or an action that does not exist, or a count that is none."""


class SimulationError(StochgeomError):
    """A simulated trial did not end inside the tray and at rest."""


# --- reading and writing -------------------------------------------------------------------------


class ReadError(InputError):
    """A file is missing or cannot be read."""


class WriteError(InputError):
    """A file cannot be written."""


class FormatError(InputError):
    """Text is not in one of the accepted formats."""


class UnknownPartError(InputError):
    """The catalogue has no part of that name."""


class UnknownErratumError(InputError):
    """The register of errata has none of that number or text."""


class UnknownReproductionError(InputError):
    """No table, figure or section of that name can be recomputed."""


class MissingExtraError(StochgeomError, ImportError):
    """An optional dependency is not installed (exit code 2); the message names its extra."""

    @classmethod
    def of(cls, what: str, module: str, extra: str, *, instead: str = "") -> MissingExtraError:
        """Return the error that something needs a module which an extra brings.

        Examples
        --------
        >>> print(MissingExtraError.of("pictures", "matplotlib", "plot"))
        pictures need matplotlib, which is not installed; accepted: the extra stochgeom[plot] (pip
        install 'stochgeom[plot]', or '.[plot]' in a clone)
        """
        return cls(
            f"{what} need {module}, which is not installed; accepted: the extra stochgeom[{extra}] "
            f"(pip install 'stochgeom[{extra}]', or '.[{extra}]' in a clone){instead}"
        )
