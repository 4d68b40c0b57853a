# SPDX-License-Identifier: GPL-3.0-or-later
"""truelux.torch: PyTorch's own check of gradients, by differences."""

import numpy as np
import pytest

torch = pytest.importorskip("torch", reason="PyTorch is not installed")

import truelux
import truelux.torch
from conftest import LAMP, PLATE, UP

FACES = [[0, 1, 2, 3], [4, 5, 6]]


def tensors(points):
    make = lambda values: torch.tensor(values, dtype=torch.float64,
                                       requires_grad=True)
    return (make(points), make([0.1, -0.2, 2.0]), make(LAMP + PLATE),
            make([[2, 1, 0.5], [0.0, 0, 0]]))


def test_has_the_bits_of_the_oracle(oracle, grid):
    points, _, vertices, emission = tensors(grid)
    e = truelux.torch.irradiance(points, torch.tensor(UP), vertices, FACES,
                                 emission)
    np.testing.assert_array_equal(e.detach().numpy(),
                                  oracle.irradiance(grid, UP))
    narrow = truelux.torch.irradiance(points.float(), torch.tensor(UP).float(),
                                      vertices.float(), FACES, emission.float())
    assert narrow.dtype == torch.float32 and narrow.shape == (6, 5, 3)


@pytest.mark.parametrize("options", [{}, {"emission": "radiance"},
                                     {"threads": 1}])
def test_gradients_are_those_of_differences(options):
    points = np.array([[0.13, -0.21, 0], [-0.34, 0.27, 0.1]])
    points, normals, vertices, emission = tensors(points)

    def function(p, n, v):
        return truelux.torch.irradiance(p, n, v, FACES, emission.detach(),
                                        **options)

    assert torch.autograd.gradcheck(function, (points, normals, vertices),
                                    eps=1e-6, atol=1e-7)

    def by_lamp(lamp):
        both = torch.cat([lamp, torch.zeros(1, 3, dtype=torch.float64)])
        return truelux.torch.irradiance(points.detach(), normals.detach(),
                                        vertices.detach(), FACES, both,
                                        **options)

    lamp = torch.tensor([[2.0, 1, 0.5]], dtype=torch.float64,
                        requires_grad=True)
    assert torch.autograd.gradcheck(by_lamp, (lamp,), eps=1e-6, atol=1e-8)


def test_where_there_is_no_derivative_it_is_0_and_said():
    # The receiver lies on the plate, which on_face does not name.
    plate = [[0, 0, 0.5], [1, 0, 0.5], [0, 1, 0.5]]
    points = torch.tensor([[0.2, 0.2, 0.5]], dtype=torch.float64,
                          requires_grad=True)
    e = truelux.torch.irradiance(
        points, torch.tensor([0.6, 0, 0.8], dtype=torch.float64),
        torch.tensor(LAMP + plate, dtype=torch.float64), FACES,
        torch.tensor([[1.0, 1, 1], [0, 0, 0]]))
    with pytest.warns(truelux.Note, match="discontinuous at 1 receivers"):
        e.sum().backward()
    assert (points.grad == 0).all()


def test_descent_finds_a_lamp():
    # The height of the lamp from irradiances below it.
    points = torch.tensor([[x, 0.1, 0] for x in np.linspace(-1, 1, 7)],
                          dtype=torch.float64)
    up = torch.tensor(UP)
    square = torch.tensor(LAMP, dtype=torch.float64)
    emission = torch.ones(1, 3, dtype=torch.float64)

    def seen(height):
        moved = square + height * torch.tensor([0, 0, 1.0],
                                               dtype=torch.float64)
        return truelux.torch.irradiance(points, up, moved, [[0, 1, 2, 3]],
                                        emission)

    wanted = seen(torch.tensor(0.3, dtype=torch.float64)).detach()
    height = torch.zeros((), dtype=torch.float64, requires_grad=True)
    search = torch.optim.LBFGS([height], max_iter=30, tolerance_grad=1e-14,
                               tolerance_change=1e-16)

    def loss():
        search.zero_grad()
        error = ((seen(height) - wanted)**2).sum()
        error.backward()
        return error

    search.step(loss)
    assert height.item() == pytest.approx(0.3, abs=1e-7)
