# SPDX-License-Identifier: GPL-3.0-or-later
"""tamaas: a model does not keep operators of Python classes alive. A collected one is of kind "dirac".

Wanted: keep_alive for `model.operators[name] = operator`.
"""

import gc

import tamaas as tm

tm.set_log_level(tm.LogLevel.error)


class Twice(tm.IntegralOperator):
    """Any operator."""

    def updateFromModel(self):
        """Nothing to update."""

    def getKind(self):
        """From tractions to displacements."""
        return tm.IntegralOperator.neumann

    def getType(self):
        """Of the model."""
        return tm.model_type.basic_2d

    def apply(self, source, result):
        """Multiply by 2."""
        result[...] = 2.0 * source


model = tm.Model(tm.model_type.basic_2d, [1.0, 1.0], [8, 8])
operator = Twice(model)
model.operators["twice"] = operator
before = model.operators["twice"].kind
del operator
gc.collect()
print(f"found: {before}, then {model.operators['twice'].kind}; expected: {before} twice")
