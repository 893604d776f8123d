"""The paper's network trained in PyTorch (Debian: python3-torch), and loaded in limber.

    08_train_in_pytorch.py RECORDING.h5 MODEL.safetensors [EPOCHS]
"""

import sys

import limber
import numpy as np
import torch  # type: ignore[import]
from model_file import scaling, write_network
from recording_windows import windows

WINDOW = 8  # frames that the network runs on its own while it learns


def main() -> None:
    arm = limber.load_arm(limber.data_folder() / "arms" / "three_segment.yaml")
    recording = limber.read_recording(sys.argv[1])
    limber.require_recording_of(recording, arm, sys.argv[1])
    arrays = q, real, free = windows(arm, recording, WINDOW)
    inputs = scaling(np.concatenate([q[:-1], q[1:], real[:-1], free[1:]], axis=2))
    outputs = scaling(real[1:] - free[1:])

    torch.manual_seed(1)
    pressure, seen, alone = map(torch.tensor, arrays)
    in_offset, in_scale = map(torch.tensor, inputs)
    out_offset, out_scale = map(torch.tensor, outputs)
    sizes = [len(inputs[0]), 100, 100, 100, len(outputs[0])]
    layers = [torch.nn.Linear(a, b) for a, b in zip(sizes, sizes[1:])]
    adam = torch.optim.Adam([p for layer in layers for p in layer.parameters()], lr=1e-3)
    for epoch in range(int(sys.argv[3]) if len(sys.argv) > 3 else 200):
        losses = []
        for part in torch.randperm(pressure.shape[1]).split(128):
            state, loss = seen[0, part], torch.tensor(0.0)
            for t in range(1, WINDOW + 1):
                x = torch.cat([pressure[t - 1, part], pressure[t, part], state, alone[t, part]], 1)
                x = (x - in_offset) * in_scale
                for layer in layers[:-1]:
                    x = torch.relu(layer(x))
                state = alone[t, part] + layers[-1](x) / out_scale + out_offset
                loss = loss + (((state - seen[t, part]) * out_scale) ** 2).mean() / WINDOW
            adam.zero_grad()
            loss.backward()
            adam.step()
            losses.append(loss.item())
        print(f"epoch {epoch + 1}: loss {np.mean(losses):.4f}")

    weights = [(layer.weight.detach().numpy(), layer.bias.detach().numpy()) for layer in layers]
    write_network(sys.argv[2], arm, weights, inputs, outputs)
    model = limber.read_model(sys.argv[2])
    model.bounds = limber.gap_bounds_of(recording.episodes)  # `plan` asks for them
    model.set_valves(limber.identify_valves(recording.episodes, arm))
    limber.write_model(sys.argv[2], model)
    print(limber.evaluate(limber.ForwardModel(arm), limber.ForwardModel(arm, model),
                          recording.episodes))


if __name__ == "__main__":
    main()
