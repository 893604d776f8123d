"""Makes tests/data/pytorch_gradients.json: loss and gradient of a small network rolled over windows
with its own output fed back, as PyTorch computes them in double precision.

Run once with Debian's python3-torch (1.13); window_gradient_test.cpp compares against the file.
"""

import json
import pathlib

import torch

SEGMENTS, STATE, NO_LOAD, HIDDEN = 2, 5, 3, [7, 6]
FRAMES, WINDOWS, WINDOW_FRAMES = 24, 3, 6


def main():
    torch.manual_seed(7)
    torch.set_default_dtype(torch.float64)
    pressure = torch.randn(SEGMENTS, FRAMES)
    no_load = torch.randn(NO_LOAD, FRAMES)
    uncompensated = torch.randn(STATE, FRAMES)
    state = torch.randn(STATE, FRAMES)
    output_scale = torch.rand(STATE) + 0.2
    loss_weight = torch.rand(STATE) + 0.2
    widths = [2 * SEGMENTS + STATE + NO_LOAD, *HIDDEN, STATE]
    weights = [torch.randn(b, a).mul(0.4).requires_grad_() for a, b in zip(widths, widths[1:])]
    biases = [torch.randn(b).mul(0.2).requires_grad_() for b in widths[1:]]
    starts = [0, 7, 14]

    loss = torch.zeros(())
    for start in starts:
        backbone = state[:, start]
        for frame in range(start + 1, start + 1 + WINDOW_FRAMES):
            x = torch.cat([pressure[:, frame - 1], pressure[:, frame], backbone, no_load[:, frame]])
            for layer, (w, b) in enumerate(zip(weights, biases)):
                x = w @ x + b
                x = torch.relu(x) if layer + 1 < len(weights) else x
            backbone = uncompensated[:, frame] + output_scale * x
            loss = loss + (loss_weight * (backbone - state[:, frame]).abs()).sum() / WINDOW_FRAMES
    loss.backward()

    def flat(tensors):
        # The order of ParameterLayout: weight column-major, then bias, layer by layer.
        return torch.cat([part for w, b in tensors for part in (w.t().reshape(-1), b)]).tolist()

    def columns(matrix):
        return matrix.t().reshape(-1).tolist()

    values = {
        "torch": torch.__version__,
        "segments": SEGMENTS,
        "widths": widths,
        "window_frames": WINDOW_FRAMES,
        "starts": starts,
        "pressure": columns(pressure),
        "no_load": columns(no_load),
        "uncompensated": columns(uncompensated),
        "state": columns(state),
        "output_scale": output_scale.tolist(),
        "loss_weight": loss_weight.tolist(),
        "parameters": flat([(w.detach(), b.detach()) for w, b in zip(weights, biases)]),
        "loss": loss.item(),
        "gradient": flat([(w.grad, b.grad) for w, b in zip(weights, biases)]),
    }
    path = pathlib.Path(__file__).parent.parent / "data" / "pytorch_gradients.json"
    path.parent.mkdir(exist_ok=True)
    path.write_text(json.dumps(values) + "\n")


if __name__ == "__main__":
    main()
