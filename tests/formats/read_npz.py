"""Prints the arrays of an .npz file as JSON, read by NumPy: {name: {"dtype", "shape", "values"}}."""

import json
import sys

import numpy

with numpy.load(sys.argv[1], allow_pickle=False) as arrays:
    print(
        json.dumps(
            {
                name: {"dtype": str(a.dtype), "shape": list(a.shape), "values": a.ravel().tolist()}
                for name, a in ((name, arrays[name]) for name in arrays.files)
            }
        )
    )
