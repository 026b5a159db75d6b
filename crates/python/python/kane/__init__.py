"""Checks the derivations and the arithmetic of collision laws.

>>> import kane
>>> audit = kane.audit('''
... ```kane
... var u > 0, 0 <= e <= 1
... claim strict: u^2 - e^2*u^2 > 0
... ```
... ''')
>>> audit["strict"].verdict
'refuted'
>>> audit["strict"].witness["e"]
Fraction(1, 1)

`audit` judges a derivation, `collide` puts a collision to every law, `batch` runs a law over NumPy
arrays without a copy, `check` says what a log of impacts follows, `scene` answers a scene by the least
model that is good enough, and `laws` lists the laws. All quantities are in SI units. Bad input raises
`ValueError` with the place and the reason.
"""

from ._audit import Audit, Irrational, Link, Statement, audit
from ._batch import Columns, Survey, batch, batch_contacts, batched, survey
from ._check import Check, Checked, check
from ._kane import version as _version
from ._laws import Law, Parameter, laws
from ._worlds import Collision, LawAnswer, Quantity, Scene, collide, scene

__version__ = _version()

__all__ = [
    "Audit",
    "Check",
    "Checked",
    "Collision",
    "Columns",
    "Irrational",
    "Law",
    "LawAnswer",
    "Link",
    "Parameter",
    "Quantity",
    "Scene",
    "Statement",
    "Survey",
    "audit",
    "batch",
    "batch_contacts",
    "batched",
    "check",
    "collide",
    "laws",
    "scene",
    "survey",
]
