# SPDX-License-Identifier: GPL-3.0-or-later
"""Compiled laws as functions of PyTorch."""

from __future__ import annotations

from typing import Any

import torch

from ..errors import ArgumentTypeError
from ..law import ContactLaw
from ._generic import Branch


class _TorchBranch(Branch):
    """On one device."""

    def __init__(self, law: ContactLaw, quantity: str, branch: str, device: Any) -> None:
        super().__init__(
            law, quantity, branch, torch, lambda array: torch.as_tensor(array, device=device), lambda tensor: tensor.detach()
        )

    def pick(self, rows: Any, index: Any) -> Any:
        # under vmap a tensor of no dimension is not an index
        return torch.index_select(rows, 0, index.reshape(-1)).reshape(index.shape + rows.shape[1:])

    def whole(self, numbers: Any) -> Any:
        return numbers.long()


def function(law: ContactLaw, quantity: str, branch: str) -> Any:
    """See `torch_function`."""
    on = {torch.device("cpu"): _TorchBranch(law, quantity, branch, "cpu")}

    def evaluate(d: Any) -> Any:
        if not isinstance(d, torch.Tensor) or d.dtype != torch.float64:
            raise ArgumentTypeError("d: it must be a tensor of torch.float64")
        if d.device not in on:
            on[d.device] = _TorchBranch(law, quantity, branch, d.device)
        return on[d.device](d)

    return evaluate
