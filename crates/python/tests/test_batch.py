"""Laws over columns: the numbers of the law, where they stand, and no copy."""

import threading
import time
from fractions import Fraction

import kane
import numpy as np
import pytest

ALPHA = np.concatenate([np.linspace(0, 4, 1001), np.logspace(-300, 300, 601), [np.inf]])


def test_the_paper_s_law_against_its_formula():
    k, impulse, energy = kane.batch("wang-su-li", ALPHA)
    finite = np.isfinite(ALPHA) & (ALPHA < 1e300)
    for a, got, i, e in zip(ALPHA[finite], k[finite], impulse[finite], energy[finite]):
        exact = Fraction(float(a))
        share = 1 / (1 + exact)
        assert abs(Fraction(float(got)) - (1 - exact) * share) <= Fraction(9, 4) / 2**52
        assert abs(Fraction(float(i)) - share) <= share * Fraction(3, 2) / 2**52
        assert abs(Fraction(float(e)) + share * share) <= share * share * 4 / 2**52 + Fraction(1, 2**1000)
    assert k[-1] == -1 and impulse[-1] == 0


@pytest.mark.parametrize("law", kane.batched())
def test_each_law_is_that_of_the_exact_collision(law):
    """One collision of a sphere, by the exact law, and the lane at its α."""
    ball = kane.collide(
        shape="sphere", velocity=(2, -1), friction="1/10", restitution="1/2", law=law
    )
    alpha = ball.before["alpha"].nearest
    k, impulse, energy = (float(column[0]) for column in kane.batch(law, np.array([alpha])))
    for symbol, got in (("k", k), ("i_x", impulse), ("de", energy)):
        assert got == pytest.approx(ball[law][symbol].nearest, rel=4e-15)


def test_results_are_written_where_they_are_asked_for():
    alpha = np.linspace(0, 2, 7)
    out = tuple(np.full(7, np.nan) for _ in range(3))
    got = kane.batch("walton", alpha, out=out)
    assert all(a is b for a, b in zip(got, out))
    assert np.array_equal(got.k, kane.batch("walton", alpha).k)


def test_a_contiguous_column_is_not_copied():
    import kane._batch as half

    alpha = np.linspace(0, 2, 7)
    assert half._column(alpha, "alpha") is alpha
    view = memoryview(alpha)
    assert np.shares_memory(half._column(view, "alpha"), alpha)


def test_lists_other_floats_and_gaps_are_converted():
    alpha = np.linspace(0, 2, 8)
    whole = kane.batch("smith-1991", alpha).k
    assert np.array_equal(kane.batch("smith-1991", alpha[::2]).k, whole[::2])
    assert np.array_equal(kane.batch("smith-1991", list(alpha)).k, whole)
    assert len(kane.batch("smith-1991", np.array([], dtype=np.float64)).k) == 0
    assert kane.batch("smith-1991", np.array([1], dtype=np.int8)).k.dtype == np.float64
    assert kane.batch("smith-1991", [Fraction(1, 2)]).k[0] == kane.batch("smith-1991", [0.5]).k[0]


def test_contacts_are_the_rows_of_their_alpha():
    slip = np.array([-1.0, 2.0, 0.5])
    sliding = np.array([0.1, 0.0, 3.0])
    mobility = np.array([3.5, 3.5, 2.0])
    rows = kane.batch_contacts("whittaker-stop", slip, sliding, mobility)
    alpha = sliding * mobility / (2 * np.abs(slip))
    assert np.array_equal(rows.k, kane.batch("whittaker-stop", alpha).k)


def test_a_survey_counts_what_the_rows_show():
    alpha = np.array([0.0, 0.5, 3.0, -1.0, np.nan])
    found = kane.survey("whittaker-uncapped", alpha)
    assert (found.rows, found.outside, found.gains) == (5, 2, 1)
    assert found.greatest_energy == 2.0 and found.least_k == -5.0


def test_bad_columns_are_errors_and_never_panics():
    alpha = np.linspace(0, 1, 4)
    with pytest.raises(ValueError, match="no law smith for columns; there are wang-su-li"):
        kane.batch("smith", alpha)
    with pytest.raises(ValueError, match="frame of its own"):
        kane.batch("tilted-2002", alpha)
    with pytest.raises(ValueError, match="dimensions"):
        kane.batch("walton", np.zeros((2, 2)))
    with pytest.raises(ValueError, match="one length"):
        kane.batch("walton", alpha, out=tuple(np.zeros(3) for _ in range(3)))
    with pytest.raises(ValueError, match="one length"):
        kane.batch_contacts("walton", alpha, alpha, alpha[:2])
    with pytest.raises(ValueError, match="gaps"):
        kane.batch("walton", alpha, out=tuple(np.zeros(8)[::2] for _ in range(3)))
    with pytest.raises(ValueError, match="float64"):
        kane.batch("walton", alpha, out=tuple(np.zeros(4, np.float32) for _ in range(3)))
    for bad in (["one", "two"], None, 0.5, [None, 1.0], [1j], [True], "12", {"a": 1}):
        with pytest.raises(ValueError):
            kane.batch("walton", bad)
    read_only = np.zeros(4)
    read_only.flags.writeable = False
    with pytest.raises(ValueError, match="written"):
        kane.batch("walton", alpha, out=(read_only, np.zeros(4), np.zeros(4)))


def test_a_column_is_not_read_and_written_at_once():
    alpha = np.linspace(0, 1, 4)
    with pytest.raises(ValueError, match="twice"):
        kane.batch("walton", alpha, out=(alpha, np.zeros(4), np.zeros(4)))
    one = np.zeros(4)
    with pytest.raises(ValueError, match="twice"):
        kane.batch("walton", alpha, out=(one, one, np.zeros(4)))


@pytest.mark.parametrize("law", kane.batched())
def test_a_row_without_a_meaning_is_nan_and_its_neighbours_are_not(law):
    alpha = np.linspace(0, 4, 9000)
    good = kane.batch(law, alpha)
    bad = [0, 7, 4095, 4096, 5000, 8999]
    alpha[bad] = [np.nan, -1.0, -np.inf, -5e-324, np.nan, np.nan]
    for column, was in zip(kane.batch(law, alpha), good):
        assert np.isnan(column[bad]).all()
        assert np.array_equal(np.delete(column, bad), np.delete(was, bad), equal_nan=True)
    slip, sliding, mobility = (np.array(column, dtype=float) for column in zip(
        (1, 1, 1), (-2, 0, 1), (0, 1, 1), (0, 0, 1), (np.nan, 1, 1), (np.inf, 1, 1), (1, -1, 1), (1, 1, 0), (1, 1, np.nan)
    ))
    k = kane.batch_contacts(law, slip, sliding, mobility).k
    # some laws have no value at α = 0, as garwin, or at ∞, as those without a bound
    without = list(np.isnan(kane.batch(law, np.array([0.5, 0.0, np.inf])).k))
    assert list(np.isnan(k)) == without + [True] * 6
    assert not any(without) or law in ("garwin", "brach", "keller-printed", "smith-printed")


def unaligned(rows):
    return np.zeros(8 * rows + 1, np.uint8)[1:].view(np.float64)


def test_a_column_in_the_middle_of_numbers_is_copied_and_not_written():
    assert np.array_equal(kane.batch("walton", unaligned(2)).k, kane.batch("walton", [0, 0]).k)
    with pytest.raises(ValueError, match="gaps"):
        kane.batch("walton", [0.0, 0.0], out=tuple(unaligned(2) for _ in range(3)))
    with pytest.raises(ValueError, match="aligned"):
        kane._kane.survey("walton", unaligned(2))


def test_a_masked_cell_is_no_number():
    with pytest.raises(ValueError, match="masked"):
        kane.batch("walton", np.ma.array([0.5, 1.0], mask=[False, True]))
    assert len(kane.batch("walton", np.ma.array([0.5, 1.0])).k) == 2


def test_other_threads_run_while_rows_are_computed():
    alpha, out = np.linspace(0, 4, 4_000_000), tuple(np.ones(4_000_000) for _ in range(3))
    went_on, done = [], threading.Event()

    def beside():
        while not done.wait(0.0005):
            went_on.append(time.perf_counter())

    thread = threading.Thread(target=beside)
    thread.start()
    between = []
    for _ in range(20):
        start = time.perf_counter()
        kane.batch("smith-1991", alpha, out=out)
        between.append((start, time.perf_counter()))
    done.set()
    thread.join()
    # a lock that is held is handed over between the calls, but never within one
    assert any(start < at < end for at in went_on for start, end in between)


def test_a_number_beyond_all_floats_is_an_error_and_no_infinity():
    for bad in ([10**400], [Fraction(10**400, 3)]):
        with pytest.raises(ValueError, match="alpha: "):
            kane.batch("walton", bad)
