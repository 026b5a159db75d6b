"""Laws over columns of floats."""

from __future__ import annotations

from typing import Any, NamedTuple, Union

from . import _kane


class Columns(NamedTuple):
    """k, i_x and Δe of every row, as NumPy arrays of float64; pure numbers."""

    #: k = v_t⁺/v_t
    k: Any
    #: i_x, the friction by the one of full sliding
    impulse: Any
    #: Δe, the work of friction by μ·p_n·v_t
    energy: Any


class Survey(NamedTuple):
    """What many rows have in common."""

    #: how many rows there were
    rows: int
    #: rows whose α is negative or NaN, or at which the law has no value; the others are the law's
    outside: int
    #: rows inside where friction gains energy, Δe > 0
    gains: int
    #: rows inside that exceed Coulomb's bound, abs(i_x) > 1
    beyond_cone: int
    #: the greatest Δe inside; -inf without a row
    greatest_energy: float
    #: the least k inside; inf without a row
    least_k: float


def batched() -> list[str]:
    """The ids of the laws that `batch` knows: all whose k is a function of α, which are those without a frame of their own.

    The first six have kernels of their own, of about a nanosecond a row; the others are evaluated row by row.
    """
    return _kane.batched()


def _column(values: Any, name: str) -> Any:
    import numpy as np

    if type(values) is np.ndarray and values.dtype == np.float64 and _is_whole(values):
        return values
    if isinstance(values, np.ma.MaskedArray) and np.ma.getmaskarray(values).any():
        raise ValueError(f"{name} has masked cells, which are no numbers")
    array = np.asarray(values)
    if array.ndim != 1:
        raise ValueError(f"{name} has {array.ndim} dimensions; a column has one")
    if array.dtype.kind == "O":  # fractions, say; None is no number, and no NaN either
        try:
            array = np.array([float(value) for value in array], dtype=np.float64)
        except (TypeError, OverflowError) as error:
            raise ValueError(f"{name}: {error}") from None
    if array.dtype.kind not in "fiu":
        raise ValueError(f"{name} has cells of the type {array.dtype}, which are no numbers")
    array = np.ascontiguousarray(array, dtype=np.float64)
    return array if array.flags.aligned else array.copy()


def _is_whole(array: Any) -> bool:
    """Whether the numbers of a column stand one after the other where the processor reads them."""
    flags = array.flags
    return bool(array.ndim == 1 and flags.c_contiguous and flags.aligned)


def _results(rows: int, out: Union[tuple[Any, Any, Any], None]) -> Columns:
    import numpy as np

    if out is None:
        return Columns(*(np.empty(rows) for _ in range(3)))
    try:
        columns = Columns(*out)
    except TypeError:
        raise ValueError("out takes three columns of float64") from None
    for column in columns:
        if not isinstance(column, np.ndarray) or column.dtype != np.float64 or column.ndim != 1:
            raise ValueError("out takes three columns of float64")
        if not (_is_whole(column) and column.flags.writeable):
            raise ValueError("a column of out has gaps or cannot be written")
    return columns


def batch(law: str, alpha: Any, *, out: Union[tuple[Any, Any, Any], None] = None) -> Columns:
    """k, i_x and Δe of a law for a column of α, each from 0 to inf, a pure number.

    `alpha` is read where it stands if it is a contiguous array of float64; anything else is converted first. `out`
    takes three such arrays, k, i_x and Δe, to write into instead of new ones. What each law promises about its
    last digits is said in the Rust documentation of `kane_impact::batch`. A row whose α is NaN or negative has no
    meaning: its results are NaN, and `survey` counts it. Other threads run meanwhile, and leave these columns alone.
    Raises `ValueError` for a law that is no function of α (see `batched`), and for columns of several lengths.
    """
    column = _column(alpha, "alpha")
    results = _results(len(column), out)
    try:
        _kane.batch(law, column, *results)
    except _kane_borrowed() as error:
        raise ValueError(f"a column is given twice, or in use by another thread: {error}") from None
    return results


def batch_contacts(
    law: str,
    slip: Any,
    sliding: Any,
    mobility: Any,
    *,
    out: Union[tuple[Any, Any, Any], None] = None,
) -> Columns:
    """k, i_x and Δe of a law for columns of contacts that do not couple.

    `slip` is v_t in m/s, of either sign; `sliding` S = μ·p_n, the friction of full sliding, at least 0, in N·s;
    `mobility` W_tt > 0 in 1/kg. α = S·W_tt/(2·abs(v_t)), with a relative error of at most 2⁻⁵². A row beyond these
    ranges, or with neither slip nor friction, is NaN. The rest is as of `batch`.
    """
    columns = [
        _column(values, name)
        for values, name in ((slip, "slip"), (sliding, "sliding"), (mobility, "mobility"))
    ]
    results = _results(len(columns[0]), out)
    try:
        _kane.batch_contacts(law, columns, *results)
    except _kane_borrowed() as error:
        raise ValueError(f"a column is given twice, or in use by another thread: {error}") from None
    return results


def survey(law: str, alpha: Any) -> Survey:
    """What a law does over a column of α, without storing a row; exact about the floats of `batch`."""
    return Survey(*_kane.survey(law, _column(alpha, "alpha")))


def _kane_borrowed() -> type[Exception]:
    """What the Rust half raises where one array is read and written at once."""
    return TypeError
